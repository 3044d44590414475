// Textures as programs: flat layers, or a choice among other programs; one for every texture and
// placement.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "scene/scene.h"
#include "tracer/patterns/map_search.h"
#include "tracer/quality.h"
#include "tracer/shading/finish.h"
#include "tracer/shading/normal.h"
#include "tracer/shading/pigment.h"

namespace durer::tracer {

/// How many patterned textures may stand around one another.
inline constexpr std::uint32_t max_texture_depth = 8;

/// Index of a program of a TextureStore.
using ProgramId = std::uint32_t;

struct LayerProgram {
  PigmentId pigment = 0;
  std::uint32_t finish = 0;       // index into TextureStore::finishes()
  NormalId normal = scene::none;  // none: no bumps
};

/// Layers first…end-1 of the store, outermost first; or a choice among other textures.
struct TextureProgram {
  std::uint32_t first_layer = 0;
  std::uint32_t end_layer = 0;
  std::uint32_t choice = scene::none;  // index of a TextureChoice
  bool opaque = false;                 // it can never let light through
  bool uses_uv = false;                // some of it is looked up at (u, v, 0)
  bool plain = false;      // one opaque layer that neither mirrors nor lets light in
  bool asks_view = false;  // some of it depends on more than the place: the ray, the normal

  [[nodiscard]] bool patterned() const { return choice != scene::none; }
};

struct TextureChoiceEntry {
  float key = 0;
  ProgramId texture = 0;
};

/// A pattern that chooses among textures, which see the point where it has moved it to.
struct TextureChoice {
  PatternProgram pattern;
  NormalFrame frame;
  std::uint32_t first_entry = 0;
  std::uint32_t end_entry = 0;
  bool by_uv = false;  // no pattern, but a move to (u, v, 0)
};

/// All textures of a compiled scene.
class TextureStore {
 public:
  explicit TextureStore(const scene::Scene& scene, Quality quality = Quality(9));

  /// The program of a texture at a place; the same one for the same place.
  ProgramId add(const scene::TextureUse& use);

  [[nodiscard]] const TextureProgram& program(ProgramId id) const { return programs_[id]; }
  [[nodiscard]] const LayerProgram& layer(std::uint32_t i) const { return layers_[i]; }
  [[nodiscard]] const Finish& finish(const LayerProgram& l) const { return finishes_[l.finish]; }
  [[nodiscard]] const PigmentStore& pigments() const { return pigments_; }
  [[nodiscard]] const NormalStore& normals() const { return normals_; }

  [[nodiscard]] const TextureChoice& choice(const TextureProgram& p) const {
    return choices_[p.choice];
  }
  [[nodiscard]] std::span<const TextureChoiceEntry> entries(const TextureChoice& c) const {
    return {&choice_entries_[c.first_entry], c.end_entry - c.first_entry};
  }
  [[nodiscard]] dvec3 warp(const TextureChoice& c, dvec3 p) const {
    return patterns_.warp(c.pattern, p);
  }

 private:
  struct Key {
    scene::TextureId texture;
    Affine placement;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };

  [[nodiscard]] TextureProgram compile_layers(scene::TextureId id, const Transform& placement);
  [[nodiscard]] TextureProgram compile_choice(const scene::Texture& texture,
                                              const Transform& placement);
  [[nodiscard]] std::uint32_t finishes_of(scene::TextureId texture);

  const scene::Scene* scene_;
  Quality quality_;
  std::vector<TextureProgram> programs_;
  std::vector<LayerProgram> layers_;
  std::vector<TextureChoice> choices_;
  std::vector<TextureChoiceEntry> choice_entries_;
  std::vector<Finish> finishes_;
  PigmentStore pigments_;
  NormalStore normals_;
  PatternStore patterns_;
  std::unordered_map<scene::TextureId, std::uint32_t> first_finish_;
  std::unordered_map<Key, ProgramId, KeyHash> known_;
};

}  // namespace durer::tracer

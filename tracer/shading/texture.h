// Textures as flat layers, one program per texture and placement.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scene/scene.h"
#include "tracer/shading/finish.h"
#include "tracer/shading/pigment.h"

namespace durer::tracer {

/// Index of a program of a TextureStore.
using ProgramId = std::uint32_t;

struct LayerProgram {
  PigmentId pigment = 0;
  std::uint32_t finish = 0;  // index into TextureStore::finishes()
  bool by_uv = false;        // the pigment is looked up at (u, v, 0)
};

/// Layers first…end-1 of the store, outermost first.
struct TextureProgram {
  std::uint32_t first_layer = 0;
  std::uint32_t end_layer = 0;
  bool opaque = false;   // some layer can never let light through
  bool uses_uv = false;  // some layer is by_uv
};

/// All textures of a compiled scene.
class TextureStore {
 public:
  explicit TextureStore(const scene::Scene& scene) : scene_(&scene), pigments_(scene.settings) {}

  /// The program of a texture at a place; the same one for the same place.
  ProgramId add(const scene::TextureUse& use);

  [[nodiscard]] const TextureProgram& program(ProgramId id) const { return programs_[id]; }
  [[nodiscard]] const LayerProgram& layer(std::uint32_t i) const { return layers_[i]; }
  [[nodiscard]] const Finish& finish(const LayerProgram& l) const { return finishes_[l.finish]; }
  [[nodiscard]] const PigmentStore& pigments() const { return pigments_; }

 private:
  struct Key {
    scene::TextureId texture;
    Affine placement;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };

  [[nodiscard]] std::uint32_t finishes_of(scene::TextureId texture);

  const scene::Scene* scene_;
  std::vector<TextureProgram> programs_;
  std::vector<LayerProgram> layers_;
  std::vector<Finish> finishes_;
  PigmentStore pigments_;
  std::unordered_map<scene::TextureId, std::uint32_t> first_finish_;
  std::unordered_map<Key, ProgramId, KeyHash> known_;
};

}  // namespace durer::tracer

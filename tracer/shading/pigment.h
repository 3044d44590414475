// Pigments as flat programs: nodes and entries in two arrays, from a world point to a colour
// without allocation.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/texture.h"
#include "tracer/patterns/program.h"

namespace durer::tracer {

/// Index of a node of a PigmentStore.
using PigmentId = std::uint32_t;

/// All pigments of a compiled scene.
class PigmentStore {
 public:
  /// `quick`: quick colours are shown where pigments have them (textures §11.8).
  explicit PigmentStore(const scene::Settings& settings = {}, bool quick = false)
      : patterns_(settings), quick_(quick) {}

  /// Adds a pigment and everything below it. `to_world` leads from the space around the pigment to
  /// the world.
  PigmentId add(const scene::Pigment& pigment, const Transform& to_world);

  /// The pigment's colour at a world point (textures §3, §11.1).
  /// `view`: what a ray sees there, for patterns that ask; null away from surfaces.
  [[nodiscard]] Colour at(PigmentId id, const dvec3& p, const SurfaceView* view = nullptr) const;

  /// The same at several world points away from surfaces. `points` are moved about meanwhile.
  static constexpr std::size_t most_points = 16;
  void at(PigmentId id, std::span<dvec3> points, Colour* out) const;

  /// Its colour, if that is the same wherever it is looked at; else null.
  [[nodiscard]] const Colour* everywhere(PigmentId id) const {
    return nodes_[id].pattern.type == nullptr ? &nodes_[id].colour : nullptr;
  }

  /// False where it shows nothing: beyond a picture that is shown once, and only there (textures
  /// §14.4).
  [[nodiscard]] bool covers(PigmentId id, const dvec3& p, const SurfaceView* view = nullptr) const;

  /// The value that its pattern selects colours with, at a world point; 0 if it has no pattern.
  [[nodiscard]] double pattern_value(PigmentId id, dvec3 p) const;

  /// True if it can never filter or transmit, wherever it is looked at.
  [[nodiscard]] bool opaque(PigmentId id) const;

 private:
  struct Entry {
    float key;
    PigmentId child;  // scene::none: use the colour
    Colour colour;
  };
  struct Node {
    PatternProgram pattern;  // of no type: `colour` everywhere
    Colour colour;
    std::uint32_t first_entry = 0;
    std::uint32_t end_entry = 0;
    bool by_uv = false;  // looked up at (u, v, 0)
    bool flat = false;   // its entries are colours, and chosen by a value
  };

  [[nodiscard]] static const dvec3& place(const Node& node, const dvec3& p,
                                          const SurfaceView* view) {
    return node.by_uv && view != nullptr ? view->uv : p;
  }
  static void blend(std::span<const Entry> entries, double value, Colour& out);
  [[nodiscard]] Colour select(const Node& node, double value, const dvec3& warped,
                              const SurfaceView* view) const;
  [[nodiscard]] Colour average(std::span<const Entry> entries, const dvec3& p,
                               const SurfaceView* view) const;
  [[nodiscard]] Colour entry_colour(const Entry& entry, const dvec3& p,
                                    const SurfaceView* view) const;

  PatternStore patterns_;
  bool quick_;
  std::vector<Node> nodes_;
  std::vector<Entry> entries_;
};

}  // namespace durer::tracer

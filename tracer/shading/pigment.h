// Pigments as flat programs: nodes and entries in two arrays, from a world point to a colour
// without allocation.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/texture.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer {

/// Index of a node of a PigmentStore.
using PigmentId = std::uint32_t;

/// All pigments of a compiled scene.
class PigmentStore {
 public:
  /// Adds a pigment and everything below it. `to_world` leads from the space around the pigment to
  /// the world.
  PigmentId add(const scene::Pigment& pigment, const Transform& to_world);

  /// The pigment's colour at a world point (textures §3, §11.1).
  [[nodiscard]] Colour at(PigmentId id, dvec3 p) const;

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
    const PatternType* pattern = nullptr;  // null: `colour` everywhere
    bool moved = false;
    scene::Wave wave = scene::Wave::ramp;
    float frequency = 1;
    float phase = 0;
    float wave_exponent = 1;
    std::uint32_t first_entry = 0;
    std::uint32_t end_entry = 0;
    Colour colour;
    Affine to_pattern;
    PatternState state;
  };

  [[nodiscard]] double value(const Node& node, dvec3 p) const;
  [[nodiscard]] Colour select(const Node& node, double value, dvec3 p) const;
  [[nodiscard]] Colour entry_colour(const Entry& entry, dvec3 p) const;

  std::vector<Node> nodes_;
  std::vector<Entry> entries_;
  std::vector<functions::FunctionRef> functions_;  // that nodes point to
};

/// The wave form that shapes a pattern's value, 0…1 (textures §3, step 5).
[[nodiscard]] double shape_wave(scene::Wave wave, float exponent, double value);

}  // namespace durer::tracer

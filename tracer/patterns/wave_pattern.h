// What `ripples` and `waves` share: circles around centres on the unit sphere (textures §2.9).
#pragma once

#include <glm/geometric.hpp>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {

struct WavePattern {
  std::span<const functions::WaveSource> waves;
  double frequency = 1;  // inside of the pattern; the pipeline uses both once more
  double phase = 0;

  void prepare(const PatternContext& context) {
    waves = context.waves;
    frequency = context.frequency;
    phase = context.phase;
  }

 protected:
  /// How far away a wave started; the centre itself counts as 1.
  static double distance(dvec3 p, const functions::WaveSource& source) {
    const double length = glm::length(p - source.centre);
    return length == 0 ? 1 : length;
  }
};

}  // namespace durer::tracer::patterns

// Noise as a pattern; three words for it differ in their default map, or as normals.
#pragma once

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {

// Noise (textures §5).
struct NoisePattern {
  functions::NoiseGenerator generator = 2;

  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.417192032657},
      Sample{{-1.5, 2.25, 7.75}, 0.429671663473},
      Sample{{123.4, -56.7, 8.9}, 0.320953256784},
  };
  void prepare(const PatternContext& context) { generator = context.noise_generator; }
  double operator()(dvec3 p) const { return functions::noise(p, generator); }
  void evaluate(std::span<const dvec3> points, double* values) const {
    functions::noise(points, generator, {values, points.size()});
  }
};

}  // namespace durer::tracer::patterns

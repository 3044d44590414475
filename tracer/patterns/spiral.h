// The arms of `spiral1` and `spiral2`.
#pragma once

#include <cmath>
#include <numbers>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {

// Spiral arms around the z axis (textures §5.3).
struct SpiralPattern {
  double arms = 1;
  double amount = 0;  // the x of `turbulence`
  functions::NoiseGenerator generator = 2;
  functions::Octaves octaves{};

  void prepare(const PatternContext& context) {
    arms = static_cast<std::int16_t>(static_cast<std::int64_t>(arms));
    amount = context.turbulence.x;
    generator = context.noise_generator;
    octaves = context.octaves;
  }

 protected:
  static double radius(dvec3 p) { return std::sqrt(p.x * p.x + p.y * p.y); }

  double arm(dvec3 p, double r) const {
    double turn = 0;
    if (r != 0) {
      const double s = std::asin(p.y / r);
      turn = p.x >= 0 ? std::numbers::pi / 2 + s : 3 * std::numbers::pi / 2 - s;
    }
    const double w = p.z + r + arms * turn / (2 * std::numbers::pi);
    return amount == 0 ? w : w + amount * functions::turbulence(p, octaves, generator);
  }
};

}  // namespace durer::tracer::patterns

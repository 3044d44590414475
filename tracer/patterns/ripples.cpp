#include "tracer/patterns/wave_pattern.h"

namespace durer::tracer::patterns {
namespace {

// Waves of one length (textures §5).
struct Ripples : WavePattern {
  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.70289994639725},
      Sample{{-1.5, 2.25, 7.75}, 0.36601394425587},
  };
  double operator()(dvec3 p) const {
    double sum = 0;
    for (const functions::WaveSource& w : waves) {
      sum += functions::cycloidal(distance(p, w) * frequency + phase);
    }
    return 0.5 * (1 + sum / static_cast<double>(waves.size()));
  }
  dvec3 perturb(dvec3 p, dvec3 n, double amount) const {
    const double share = amount / static_cast<double>(waves.size());
    for (const functions::WaveSource& w : waves) {
      const double length = distance(p, w);
      const double height = functions::cycloidal(length * frequency + phase);
      n += share * height / length * (p - w.centre);
    }
    return n;
  }
};

}  // namespace

extern constinit const PatternType ripples_pattern =
    describe_pattern<Ripples>("ripples", "Waves of one length.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

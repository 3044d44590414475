#include "tracer/patterns/wave_pattern.h"

namespace durer::tracer::patterns {
namespace {

// Waves of as many lengths as there are centres; long ones are high (textures §5).
struct Waves : WavePattern {
  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.76286702727402},
      Sample{{-1.5, 2.25, 7.75}, 0.58188977946053},
  };
  double operator()(dvec3 p) const {
    double sum = 0;
    for (const functions::WaveSource& w : waves) {
      sum += functions::cycloidal(distance(p, w) * frequency * w.frequency + phase) / w.frequency;
    }
    return 0.2 * (2.5 + sum / static_cast<double>(waves.size()));
  }
  dvec3 perturb(dvec3 p, dvec3 n, double amount) const {
    const double share = amount / static_cast<double>(waves.size());
    for (const functions::WaveSource& w : waves) {
      const double length = distance(p, w);
      const double height = functions::cycloidal(length * frequency * w.frequency + phase);
      n += share * height / (w.frequency * length) * (p - w.centre);
    }
    return n;
  }
};

}  // namespace

extern constinit const PatternType waves_pattern =
    describe_pattern<Waves>("waves", "Waves of many lengths.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

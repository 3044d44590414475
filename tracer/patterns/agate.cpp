#include <algorithm>
#include <cmath>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Bands across z, bent by turbulence even where none is asked for (textures §5).
struct Agate {
  float amount = 1;
  functions::NoiseGenerator generator = 2;
  functions::Octaves octaves{};

  static constexpr std::array operands{
      keyword<&Agate::amount>("agate_turb", "how much the bands are bent"),
  };
  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.22369533703985},
      Sample{{-1.5, 2.25, 7.75}, 0.36332226194469},
  };
  void prepare(const PatternContext& context) {
    generator = context.noise_generator;
    octaves = context.octaves;
  }
  double operator()(dvec3 p) const {
    return band(p, functions::turbulence(p, octaves, generator));
  }
  void evaluate(std::span<const dvec3> points, double* values) const {
    functions::turbulence(points, octaves, generator, {values, points.size()});
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = band(points[i], values[i]);
  }

 private:
  double band(const dvec3& p, double turbulence) const {
    const double t = amount * turbulence;
    const double n = 0.5 * (functions::cycloidal(1.3 * t + 1.1 * p.z) + 1);
    return n < 0 ? 0 : std::pow(std::min(1.0, n), 0.77);
  }
};

constexpr std::array default_map{
    entry(0, 1, 1, 1),          entry(0.5F, 0.95F, 0.75F, 0.5F), entry(0.5F, 0.9F, 0.7F, 0.5F),
    entry(0.6F, 0.9F, 0.7F, 0.4F), entry(0.6F, 1, 0.7F, 0.4F),   entry(1, 0.6F, 0.3F, 0),
};

}  // namespace

extern constinit const PatternType agate_pattern =
    describe_pattern<Agate>("agate", "Twisted bands.", {.default_map = default_map});

}  // namespace durer::tracer::patterns

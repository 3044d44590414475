#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Layers across x, bent by turbulence (textures §5).
struct Marble {
  double amount = 0;  // the x of `turbulence`
  functions::NoiseGenerator generator = 2;
  functions::Octaves octaves{};

  static constexpr std::array samples{
      Sample{{0.25, 7, 0}, 0.25},
      Sample{{-3, 0, 2}, -3},
  };
  void prepare(const PatternContext& context) {
    amount = context.turbulence.x;
    generator = context.noise_generator;
    octaves = context.octaves;
  }
  double operator()(dvec3 p) const {
    return amount == 0 ? p.x : p.x + amount * functions::turbulence(p, octaves, generator);
  }
  void evaluate(std::span<const dvec3> points, double* values) const {
    if (amount == 0) {
      for (const dvec3& p : points) *values++ = p.x;
      return;
    }
    functions::turbulence(points, octaves, generator, {values, points.size()});
    for (const dvec3& p : points) {
      *values = p.x + amount * *values;
      ++values;
    }
  }
};

constexpr std::array default_map{
    entry(0, 0.9F, 0.8F, 0.8F),
    entry(0.9F, 0.9F, 0.08F, 0.08F),
    entry(0.9F, 0, 0, 0),
};

}  // namespace

extern constinit const PatternType marble_pattern = describe_pattern<Marble>(
    "marble", "Layers across x.",
    {.wave = scene::Wave::triangle, .default_map = default_map, .own_turbulence = true});

}  // namespace durer::tracer::patterns

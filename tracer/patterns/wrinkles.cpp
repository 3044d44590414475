#include <algorithm>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Ten octaves of noise (textures §5).
struct Wrinkles {
  static constexpr int octaves = 10;
  functions::NoiseGenerator generator = 2;

  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.500987778579},
      Sample{{-1.5, 2.25, 7.75}, 0.411190325658},
      Sample{{123.4, -56.7, 8.9}, 0.380590307988},
  };
  void prepare(const PatternContext& context) { generator = context.noise_generator; }
  double operator()(dvec3 p) const {
    std::array<double, 12> noise;
    functions::noise_octaves(p, 2, octaves, generator, noise.data());
    double sum = 0;
    double weight = 1;
    for (int i = 0; i < octaves; ++i, weight /= 2) {
      const double n = noise[static_cast<std::size_t>(i)];
      sum += weight * (generator < 2 ? n : std::clamp(2 * n - 0.5, 0.0, 1.0));
    }
    return sum / 2;
  }
  dvec3 perturb(dvec3 p, dvec3 n, double amount) const {
    return n + amount * functions::folded_vnoise(p, octaves);
  }
  void perturb(std::span<const dvec3> points, dvec3* normals, double amount) const {
    std::array<dvec3, 16> bumps;
    for (std::size_t done = 0; done < points.size(); done += bumps.size()) {
      const auto some = points.subspan(done, std::min(bumps.size(), points.size() - done));
      functions::folded_vnoise(some, octaves, std::span(bumps).first(some.size()));
      for (std::size_t i = 0; i < some.size(); ++i) *normals++ += amount * bumps[i];
    }
  }
};

}  // namespace

extern constinit const PatternType wrinkles_pattern =
    describe_pattern<Wrinkles>("wrinkles", "Crumpled noise.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

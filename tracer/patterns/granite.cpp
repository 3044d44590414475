#include <algorithm>
#include <cmath>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Six octaves of folded noise (textures §5).
struct Granite {
  static constexpr int octaves = 6;
  functions::NoiseGenerator generator = 2;

  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.643653545756},
      Sample{{-1.5, 2.25, 7.75}, 0.512001498817},
      Sample{{123.4, -56.7, 8.9}, 0.268233185530},
  };
  void prepare(const PatternContext& context) { generator = context.noise_generator; }
  double operator()(dvec3 p) const {
    std::array<double, 8> noise;
    functions::noise_octaves(4.0 * p, 2, octaves, generator, noise.data());
    return sum(noise.data(), 1);
  }
  void evaluate(std::span<const dvec3> points, double* values) const {
    std::array<double, 4 * octaves> noise;
    for (std::size_t done = 0; done < points.size(); done += 4) {
      const std::size_t count = std::min<std::size_t>(4, points.size() - done);
      std::array<dvec3, 4> scaled;
      for (std::size_t i = 0; i < count; ++i) scaled[i] = 4.0 * points[done + i];
      functions::noise_octaves(std::span(scaled).first(count), 2, octaves, generator, noise.data());
      for (std::size_t i = 0; i < count; ++i) values[done + i] = sum(&noise[i], 4);
    }
  }

 private:
  // Of octaves that lie `step` numbers behind each other.
  double sum(const double* noise, int step) const {
    double sum = 0;
    double weight = 1;
    for (int i = 0; i < octaves; ++i, weight /= 2) {
      const double n = noise[i * step];
      sum += weight * (generator < 2 ? std::abs(0.5 - n) : std::min(std::abs(1 - 2 * n), 0.5));
    }
    return sum;
  }
};

}  // namespace

extern constinit const PatternType granite_pattern =
    describe_pattern<Granite>("granite", "Fractal granite.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

#include <algorithm>
#include <glm/common.hpp>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Ten octaves of noise (textures §5).
struct Wrinkles {
  functions::NoiseGenerator generator = 2;

  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.500987778579},
      Sample{{-1.5, 2.25, 7.75}, 0.411190325658},
      Sample{{123.4, -56.7, 8.9}, 0.380590307988},
  };
  void prepare(const PatternContext& context) { generator = context.noise_generator; }
  double operator()(dvec3 p) const {
    double sum = 0;
    double frequency = 1;
    for (int i = 0; i < 10; ++i, frequency *= 2) {
      const double n = functions::noise(frequency * p, generator);
      sum += (generator < 2 ? n : std::clamp(2 * n - 0.5, 0.0, 1.0)) / frequency;
    }
    return sum / 2;
  }
  dvec3 perturb(dvec3 p, dvec3 n, double amount) const {
    dvec3 sum(0.0);
    double frequency = 1;
    for (int i = 0; i < 10; ++i, frequency *= 2) {
      sum += glm::abs(functions::vnoise(frequency * p)) / frequency;
    }
    return n + amount * sum;
  }
};

}  // namespace

extern constinit const PatternType wrinkles_pattern =
    describe_pattern<Wrinkles>("wrinkles", "Crumpled noise.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

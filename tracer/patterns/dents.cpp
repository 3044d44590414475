#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Noise to the third power (textures §5).
struct Dents {
  functions::NoiseGenerator generator = 2;

  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.417192032657 * 0.417192032657 * 0.417192032657},
  };
  void prepare(const PatternContext& context) { generator = context.noise_generator; }
  double operator()(dvec3 p) const {
    const double n = functions::noise(p, generator);
    return n * n * n;
  }
  dvec3 perturb(dvec3 p, dvec3 n, double amount) const {
    return n + amount * (*this)(p) * functions::vnoise(p);
  }
};

}  // namespace

extern constinit const PatternType dents_pattern =
    describe_pattern<Dents>("dents", "Scattered dents.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

#include "tracer/patterns/fractal.h"

namespace durer::tracer::patterns {
namespace {

// A Julia set: z ← zᴱ + c from z = the point (textures §7).
struct Julia {
  dvec2 constant{0.0};
  double iterations = 0;
  double exponent = 2;
  Pair exterior{1, 1};
  Pair interior{0, 1};

  static constexpr std::array operands{
      positional<&Julia::constant>("constant", "what is added at every step"),
      positional<&Julia::iterations>("iterations", "number of iterations"),
      keyword<&Julia::exponent>("exponent", "exponent, 2 to 33"),
      keyword<&Julia::exterior>("exterior", "type and factor of values outside"),
      keyword<&Julia::interior>("interior", "type and factor of values inside"),
  };
  static constexpr std::array samples{
      Sample{{0, 0, 0}, 1},
  };

  void prepare() { exponent = legal_exponent(exponent); }

  double operator()(dvec3 p) const {
    const Complex z0{p.x, p.y};
    const Complex c{constant.x, constant.y};
    const int e = static_cast<int>(exponent);
    return FractalColours{exterior, interior}.walk(
        z0, z0.norm(), iterations, [&](Complex z) { return power(z, e) + c; },
        [](Complex, double norm) { return norm > 4; });
  }
};

}  // namespace

extern constinit const PatternType julia_pattern = with_check(
    describe_pattern<Julia>("julia", "A Julia set.", {.default_map = black_to_white}));

}  // namespace durer::tracer::patterns

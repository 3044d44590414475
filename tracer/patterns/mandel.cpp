#include "tracer/patterns/fractal.h"

namespace durer::tracer::patterns {
namespace {

// The Mandelbrot set: z ← zᴱ + c from z = c, the point itself (textures §7).
struct Mandel {
  double iterations = 0;
  double exponent = 2;
  Pair exterior{1, 1};
  Pair interior{0, 1};

  static constexpr std::array operands{
      positional<&Mandel::iterations>("iterations", "number of iterations"),
      keyword<&Mandel::exponent>("exponent", "exponent, 2 to 33"),
      keyword<&Mandel::exterior>("exterior", "type and factor of values outside"),
      keyword<&Mandel::interior>("interior", "type and factor of values inside"),
  };
  static constexpr std::array samples{
      Sample{{0, 0, 0}, 1},
  };

  void prepare() { exponent = legal_exponent(exponent); }

  double operator()(dvec3 p) const {
    const Complex c{p.x, p.y};
    const int e = static_cast<int>(exponent);
    return FractalColours{exterior, interior}.walk(
        c, c.norm(), iterations, [&](Complex z) { return power(z, e) + c; },
        [](Complex, double norm) { return norm > 4; });
  }
};

constexpr std::array default_map{
    entry(0.001F, 0, 0, 0), entry(0.001F, 0, 1, 1), entry(0.012F, 1, 1, 0),
    entry(0.015F, 1, 0, 1), entry(0.1F, 0, 1, 1),
};

}  // namespace

extern constinit const PatternType mandel_pattern = with_check(
    describe_pattern<Mandel>("mandel", "The Mandelbrot set.", {.default_map = default_map}));

}  // namespace durer::tracer::patterns

#include "tracer/patterns/fractal.h"

namespace durer::tracer::patterns {
namespace {

// Fractals of two formulas from the theory of magnets, as Mandelbrot or Julia set (textures §7).
struct Magnet {
  double type = 1;
  bool julia = false;
  dvec2 constant{0.0};
  double iterations = 0;
  Pair exterior{1, 1};
  Pair interior{0, 1};

  static constexpr std::array operands{
      positional<&Magnet::type>("type", "which formula, 1 or 2"),
      positional<&Magnet::julia>("julia", "a Julia set rather than a Mandelbrot set"),
      positional<&Magnet::constant>("constant", "constant of a Julia set"),
      positional<&Magnet::iterations>("iterations", "number of iterations"),
      keyword<&Magnet::exterior>("exterior", "type and factor of values outside"),
      keyword<&Magnet::interior>("interior", "type and factor of values inside"),
  };
  static constexpr std::array samples{
      Sample{{0, 0, 0}, 1},
  };
  double operator()(dvec3 p) const {
    const Complex point{p.x, p.y};
    const Complex k = julia ? Complex{constant.x, constant.y} : point;
    const Complex start = julia ? point : Complex{};
    const double least = julia ? point.norm() : 10000;
    const auto escapes = [](Complex z, double norm) {
      return norm > 10000 || (z + -1.0).norm() < 1.0 / 10000;
    };
    const FractalColours colours{exterior, interior};
    if (type == 1) {
      return colours.walk(
          start, least, iterations,
          [&](Complex z) { return square((z * z + k + -1.0) / (2 * z + k + -2.0)); }, escapes);
    }
    const Complex k1 = k + -1.0;
    const Complex k2 = k + -2.0;
    const Complex k12 = k1 * k2;
    return colours.walk(
        start, least, iterations,
        [&](Complex z) {
          const Complex z2 = z * z;
          return square((z2 * z + 3 * (k1 * z) + k12) / (3 * z2 + 3 * (k2 * z) + k12 + 1.0));
        },
        escapes);
  }

 private:
  static Complex square(Complex z) { return z * z; }
};

}  // namespace

extern constinit const PatternType magnet_pattern = with_check(
    describe_pattern<Magnet>("magnet", "Magnetic fractals.", {.default_map = black_to_white}));

}  // namespace durer::tracer::patterns

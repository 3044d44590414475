// What the escape-time fractals share: how a number's fate becomes a value (textures §7).
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {

/// A complex number, a + ib. Plain arithmetic without the detours of std::complex.
struct Complex {
  double a = 0;
  double b = 0;

  [[nodiscard]] double norm() const { return a * a + b * b; }
};
[[nodiscard]] inline Complex operator+(Complex x, Complex y) { return {x.a + y.a, x.b + y.b}; }
[[nodiscard]] inline Complex operator+(Complex x, double y) { return {x.a + y, x.b}; }
[[nodiscard]] inline Complex operator*(Complex x, Complex y) {
  return {x.a * y.a - x.b * y.b, x.a * y.b + x.b * y.a};
}
[[nodiscard]] inline Complex operator*(double s, Complex x) { return {s * x.a, s * x.b}; }
[[nodiscard]] inline Complex operator/(Complex x, Complex y) {
  const double n = y.norm();
  return {(x.a * y.a + x.b * y.b) / n, (x.b * y.a - x.a * y.b) / n};
}

/// `exterior` and `interior`: a type and a factor each.
struct FractalColours {
  Pair exterior{1, 1};
  Pair interior{0, 1};

  /// The value of a number that escaped at iteration n of N and ended as z.
  [[nodiscard]] double outside(int n, int limit, Complex z) const {
    const double f = exterior.second;
    const auto turn = [&](double period) {
      const int whole = static_cast<int>(period);
      return whole == 0 ? 0 : static_cast<double>(n % whole) / f;
    };
    switch (static_cast<int>(exterior.first)) {
      case 0: return f;
      case 1: return static_cast<double>(n) / limit;
      case 6: return std::sqrt(z.norm()) * f;
      case 7: return turn(f);
      case 8: return turn(1 + f);
      default: return parts(static_cast<int>(exterior.first), z, f);
    }
  }
  /// The value of a number that stays; `least` is the smallest norm it had.
  [[nodiscard]] double inside(double least, Complex z) const {
    const double f = interior.second;
    switch (static_cast<int>(interior.first)) {
      case 0: return f;
      case 1: return std::sqrt(least) * f;
      case 6: return z.a * z.a + z.b * z.b * f;  // as the oracle has it
      default: return parts(static_cast<int>(interior.first), z, f);
    }
  }
  /// Follows z from `least`, its first norm, on. `next` makes z of z, `escapes` ends the walk.
  template <typename Next, typename Escapes>
  [[nodiscard]] double walk(Complex z, double least, double iterations, Next next,
                            Escapes escapes) const {
    const int limit = static_cast<int>(iterations);
    for (int n = 0; n < limit; ++n) {
      z = next(z);
      const double norm = z.norm();
      if (norm < least) least = norm;
      if (escapes(z, norm)) return outside(n, limit, z);
    }
    return inside(least, z);
  }

 private:
  static double parts(int type, Complex z, double f) {
    switch (type) {
      case 2: return z.a * f;
      case 3: return z.b * f;
      case 4: return z.a * z.a * f;
      default: return z.b * z.b * f;
    }
  }
};

/// z to a whole power, at least 2.
[[nodiscard]] inline Complex power(Complex z, int exponent) {
  const double a2 = z.a * z.a;
  const double b2 = z.b * z.b;
  switch (exponent) {
    case 2: return {a2 - b2, 2 * z.a * z.b};
    case 3: return {z.a * (a2 - 3 * b2), z.b * (3 * a2 - b2)};
    case 4: return {a2 * a2 - 6 * a2 * b2 + b2 * b2, 4 * z.a * z.b * (a2 - b2)};
    default: break;
  }
  Complex r = z;
  for (int i = 1; i < exponent; ++i) r = r * z;
  return r;
}

/// Exponents are whole and 2 to 33; others act as 2.
[[nodiscard]] inline int legal_exponent(double exponent) {
  const double e = std::trunc(exponent);
  return e >= 2 && e <= 33 ? static_cast<int>(e) : 2;
}

/// For TypeInfo::validate: the last four operands of a fractal are `exterior` and `interior`.
[[nodiscard]] inline std::optional<std::string> check_fractal(std::span<const double> args) {
  const double outer = args[args.size() - 4];
  const double inner = args[args.size() - 2];
  if (!(outer >= 0 && outer < 9)) return "the type of `exterior` is 0 to 8";
  if (!(inner >= 0 && inner < 7)) return "the type of `interior` is 0 to 6";
  return {};
}

/// A fractal whose `exterior` and `interior` are checked.
[[nodiscard]] constexpr PatternType with_check(PatternType type) {
  type.validate = &check_fractal;
  return type;
}

}  // namespace durer::tracer::patterns

// Dual numbers: a value with its gradient, for derivatives by the rules of calculus.
#pragma once

#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>

namespace durer {

/// A value and its partial derivatives by the first three parameters (x, y, z).
/// At kinks (abs, min, max, floor) the gradient is that of one side.
struct Dual {
  double v = 0;
  glm::dvec3 d{0.0};

  Dual() = default;
  Dual(double value) : v(value) {}  // NOLINT: a number is a constant
  Dual(double value, glm::dvec3 gradient) : v(value), d(gradient) {}
};

namespace dual_detail {
/// slope · d, but 0 where d is 0, so that an infinite slope does not turn constants into NaN.
[[nodiscard]] inline glm::dvec3 chain(double slope, const glm::dvec3& d) {
  return d == glm::dvec3(0.0) ? d : slope * d;
}
}  // namespace dual_detail

[[nodiscard]] inline Dual operator-(const Dual& a) { return {-a.v, -a.d}; }
[[nodiscard]] inline Dual operator+(const Dual& a, const Dual& b) { return {a.v + b.v, a.d + b.d}; }
[[nodiscard]] inline Dual operator-(const Dual& a, const Dual& b) { return {a.v - b.v, a.d - b.d}; }
[[nodiscard]] inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d};
}
[[nodiscard]] inline Dual operator/(const Dual& a, const Dual& b) {
  const double q = a.v / b.v;
  return {q, (a.d - q * b.d) / b.v};
}
inline Dual& operator+=(Dual& a, const Dual& b) { return a = a + b; }
inline Dual& operator-=(Dual& a, const Dual& b) { return a = a - b; }
inline Dual& operator*=(Dual& a, const Dual& b) { return a = a * b; }

[[nodiscard]] inline Dual sqr(const Dual& a) { return {a.v * a.v, 2 * a.v * a.d}; }
[[nodiscard]] inline Dual abs(const Dual& a) { return {std::abs(a.v), a.v < 0 ? -a.d : a.d}; }
[[nodiscard]] inline Dual min(const Dual& a, const Dual& b) { return a.v < b.v ? a : b; }
[[nodiscard]] inline Dual max(const Dual& a, const Dual& b) { return a.v < b.v ? b : a; }
[[nodiscard]] inline Dual floor(const Dual& a) { return std::floor(a.v); }
[[nodiscard]] inline Dual ceil(const Dual& a) { return std::ceil(a.v); }
[[nodiscard]] inline Dual trunc(const Dual& a) { return std::trunc(a.v); }
[[nodiscard]] inline Dual sqrt(const Dual& a) {
  const double s = std::sqrt(a.v);
  return {s, dual_detail::chain(0.5 / s, a.d)};
}
[[nodiscard]] inline Dual exp(const Dual& a) {
  const double e = std::exp(a.v);
  return {e, e * a.d};
}
[[nodiscard]] inline Dual log(const Dual& a) {
  return {std::log(a.v), dual_detail::chain(1 / a.v, a.d)};
}
[[nodiscard]] inline Dual log10(const Dual& a) {
  return {std::log10(a.v), dual_detail::chain(1 / (a.v * std::numbers::ln10), a.d)};
}
[[nodiscard]] inline Dual sin(const Dual& a) { return {std::sin(a.v), std::cos(a.v) * a.d}; }
[[nodiscard]] inline Dual cos(const Dual& a) { return {std::cos(a.v), -std::sin(a.v) * a.d}; }
[[nodiscard]] inline Dual tan(const Dual& a) {
  const double t = std::tan(a.v);
  return {t, (1 + t * t) * a.d};
}
[[nodiscard]] inline Dual asin(const Dual& a) {
  return {std::asin(a.v), dual_detail::chain(1 / std::sqrt(1 - a.v * a.v), a.d)};
}
[[nodiscard]] inline Dual acos(const Dual& a) {
  return {std::acos(a.v), dual_detail::chain(-1 / std::sqrt(1 - a.v * a.v), a.d)};
}
[[nodiscard]] inline Dual atan(const Dual& a) { return {std::atan(a.v), a.d / (1 + a.v * a.v)}; }
[[nodiscard]] inline Dual sinh(const Dual& a) { return {std::sinh(a.v), std::cosh(a.v) * a.d}; }
[[nodiscard]] inline Dual cosh(const Dual& a) { return {std::cosh(a.v), std::sinh(a.v) * a.d}; }
[[nodiscard]] inline Dual tanh(const Dual& a) {
  const double t = std::tanh(a.v);
  return {t, (1 - t * t) * a.d};
}
[[nodiscard]] inline Dual asinh(const Dual& a) {
  return {std::asinh(a.v), a.d / std::sqrt(a.v * a.v + 1)};
}
[[nodiscard]] inline Dual acosh(const Dual& a) {
  return {std::acosh(a.v), dual_detail::chain(1 / std::sqrt(a.v * a.v - 1), a.d)};
}
[[nodiscard]] inline Dual atanh(const Dual& a) {
  return {std::atanh(a.v), dual_detail::chain(1 / (1 - a.v * a.v), a.d)};
}
[[nodiscard]] inline Dual atan2(const Dual& y, const Dual& x) {
  const double r2 = x.v * x.v + y.v * y.v;
  return {std::atan2(y.v, x.v), dual_detail::chain(1 / r2, x.v * y.d - y.v * x.d)};
}
[[nodiscard]] inline Dual fmod(const Dual& a, const Dual& m) {
  return {std::fmod(a.v, m.v), a.d - dual_detail::chain(std::trunc(a.v / m.v), m.d)};
}
[[nodiscard]] inline Dual pow(const Dual& a, const Dual& b) {
  using dual_detail::chain;
  const double p = std::pow(a.v, b.v);
  return {p, chain(b.v * std::pow(a.v, b.v - 1), a.d) + chain(p * std::log(a.v), b.d)};
}

[[nodiscard]] inline bool lt(const Dual& a, const Dual& b) { return a.v < b.v; }
[[nodiscard]] inline bool le(const Dual& a, const Dual& b) { return a.v <= b.v; }
[[nodiscard]] inline bool eq(const Dual& a, const Dual& b) { return a.v == b.v; }
[[nodiscard]] inline Dual where(bool m, const Dual& a, const Dual& b) { return m ? a : b; }

}  // namespace durer

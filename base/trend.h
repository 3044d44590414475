// Trends: the range of a formula over a box together with the ranges of its slopes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/interval.h"

namespace durer {

/// A range and, along each axis, the range of the slopes: for any two points p, q of the box the
/// difference f(q) - f(p) is g · (q - p) for some g in `d`. That holds at kinks too, where `d`
/// spans both sides; where a formula may jump, `d` is unbounded.
struct Trend {
  using Slopes = std::array<Interval, 3>;

  Interval v;
  Slopes d{};

  Trend() = default;
  Trend(double value) : v(value) {}  // NOLINT: a number is a constant
  Trend(const Interval& range, const Slopes& slopes) : v(range), d(slopes) {}
  /// The coordinate along `axis`.
  [[nodiscard]] static Trend coordinate(const Interval& range, std::size_t axis) {
    Trend t;
    t.v = range;
    t.d[axis] = 1.0;
    return t;
  }
  /// Nothing is known about the slopes, as where there is a jump.
  [[nodiscard]] static Trend erratic(const Interval& range) {
    const Interval any = Interval::entire();
    return {range, {any, any, any}};
  }
};

namespace trend_detail {
inline constexpr Interval zero{0.0, 0.0};

/// slope · s, but 0 where s is 0, so that an infinite slope does not spoil constants.
[[nodiscard]] inline Interval product(const Interval& slope, const Interval& s) {
  return s.lo == 0 && s.hi == 0 ? zero : slope * s;
}
[[nodiscard]] inline Trend chain(const Interval& v, const Interval& slope, const Trend& a) {
  return {v, {product(slope, a.d[0]), product(slope, a.d[1]), product(slope, a.d[2])}};
}
template <class F>
[[nodiscard]] Trend::Slopes map(F f) {
  return {f(std::size_t{0}), f(std::size_t{1}), f(std::size_t{2})};
}
[[nodiscard]] inline Trend::Slopes hull_of(const Trend& a, const Trend& b) {
  return map([&](std::size_t i) { return hull(a.d[i], b.d[i]); });
}
[[nodiscard]] inline bool is_constant(const Trend& a) {
  for (const Interval& s : a.d) {
    if (s.lo != 0 || s.hi != 0) return false;
  }
  return true;
}
/// A step function: flat, or with a jump inside.
[[nodiscard]] inline Trend steps(const Interval& v, const Trend& a) {
  if (v.is_point() || is_constant(a)) return {v, {}};
  return Trend::erratic(v);
}
}  // namespace trend_detail

[[nodiscard]] inline Trend operator-(const Trend& a) {
  return {-a.v, trend_detail::map([&](std::size_t i) { return -a.d[i]; })};
}
[[nodiscard]] inline Trend operator+(const Trend& a, const Trend& b) {
  return {a.v + b.v, trend_detail::map([&](std::size_t i) { return a.d[i] + b.d[i]; })};
}
[[nodiscard]] inline Trend operator-(const Trend& a, const Trend& b) {
  return {a.v - b.v, trend_detail::map([&](std::size_t i) { return a.d[i] - b.d[i]; })};
}
[[nodiscard]] inline Trend operator*(const Trend& a, const Trend& b) {
  using trend_detail::product;
  return {a.v * b.v, trend_detail::map([&](std::size_t i) {
            return product(b.v, a.d[i]) + product(a.v, b.d[i]);
          })};
}
[[nodiscard]] inline Trend operator/(const Trend& a, const Trend& b) {
  using trend_detail::product;
  const Interval q = a.v / b.v;
  if (interval_detail::has_zero(b.v)) return Trend::erratic(q);
  const Interval r = Interval(1.0) / b.v;
  return {q, trend_detail::map([&](std::size_t i) {
            return product(r, a.d[i] - product(q, b.d[i]));
          })};
}
inline Trend& operator+=(Trend& a, const Trend& b) { return a = a + b; }
inline Trend& operator-=(Trend& a, const Trend& b) { return a = a - b; }
inline Trend& operator*=(Trend& a, const Trend& b) { return a = a * b; }

[[nodiscard]] inline Trend sqr(const Trend& a) {
  return trend_detail::chain(sqr(a.v), Interval(2.0) * a.v, a);
}
[[nodiscard]] inline Trend abs(const Trend& a) {
  const double least = a.v.lo >= 0 ? 1 : -1;
  const double most = a.v.hi <= 0 ? -1 : 1;
  return trend_detail::chain(abs(a.v), {std::min(least, most), std::max(least, most)}, a);
}
[[nodiscard]] inline Trend min(const Trend& a, const Trend& b) {
  if (!a.v.nan && !b.v.nan) {
    if (a.v.hi < b.v.lo) return a;
    if (b.v.hi <= a.v.lo) return b;
    return {min(a.v, b.v), trend_detail::hull_of(a, b)};
  }
  return Trend::erratic(min(a.v, b.v));
}
[[nodiscard]] inline Trend max(const Trend& a, const Trend& b) {
  if (!a.v.nan && !b.v.nan) {
    if (a.v.hi < b.v.lo) return b;
    if (b.v.hi <= a.v.lo) return a;
    return {max(a.v, b.v), trend_detail::hull_of(a, b)};
  }
  return Trend::erratic(max(a.v, b.v));
}
[[nodiscard]] inline Trend floor(const Trend& a) { return trend_detail::steps(floor(a.v), a); }
[[nodiscard]] inline Trend ceil(const Trend& a) { return trend_detail::steps(ceil(a.v), a); }
[[nodiscard]] inline Trend trunc(const Trend& a) { return trend_detail::steps(trunc(a.v), a); }
[[nodiscard]] inline Trend sqrt(const Trend& a) {
  const Interval s = sqrt(a.v);
  if (s.lo <= 0) return trend_detail::chain(s, {0, interval_detail::inf}, a);
  return trend_detail::chain(s, Interval(0.5) / s, a);
}
[[nodiscard]] inline Trend exp(const Trend& a) {
  const Interval e = exp(a.v);
  return trend_detail::chain(e, e, a);
}
[[nodiscard]] inline Trend log(const Trend& a) {
  if (!(a.v.lo > 0)) return Trend::erratic(log(a.v));
  return trend_detail::chain(log(a.v), Interval(1.0) / a.v, a);
}
[[nodiscard]] inline Trend log10(const Trend& a) {
  if (!(a.v.lo > 0)) return Trend::erratic(log10(a.v));
  return trend_detail::chain(log10(a.v), Interval(1 / std::numbers::ln10) / a.v, a);
}
[[nodiscard]] inline Trend sin(const Trend& a) {
  return trend_detail::chain(sin(a.v), cos(a.v), a);
}
[[nodiscard]] inline Trend cos(const Trend& a) {
  return trend_detail::chain(cos(a.v), -sin(a.v), a);
}
[[nodiscard]] inline Trend tan(const Trend& a) {
  const Interval t = tan(a.v);
  if (!t.is_bounded()) return Trend::erratic(t);
  return trend_detail::chain(t, Interval(1.0) + sqr(t), a);
}
[[nodiscard]] inline Trend asin(const Trend& a) {
  if (!(a.v.lo > -1 && a.v.hi < 1)) return Trend::erratic(asin(a.v));
  return trend_detail::chain(asin(a.v), Interval(1.0) / sqrt(Interval(1.0) - sqr(a.v)), a);
}
[[nodiscard]] inline Trend acos(const Trend& a) {
  if (!(a.v.lo > -1 && a.v.hi < 1)) return Trend::erratic(acos(a.v));
  return trend_detail::chain(acos(a.v), Interval(-1.0) / sqrt(Interval(1.0) - sqr(a.v)), a);
}
[[nodiscard]] inline Trend atan(const Trend& a) {
  return trend_detail::chain(atan(a.v), Interval(1.0) / (Interval(1.0) + sqr(a.v)), a);
}
[[nodiscard]] inline Trend sinh(const Trend& a) {
  return trend_detail::chain(sinh(a.v), cosh(a.v), a);
}
[[nodiscard]] inline Trend cosh(const Trend& a) {
  return trend_detail::chain(cosh(a.v), sinh(a.v), a);
}
[[nodiscard]] inline Trend tanh(const Trend& a) {
  const Interval t = tanh(a.v);
  return trend_detail::chain(t, Interval(1.0) - sqr(t), a);
}
[[nodiscard]] inline Trend asinh(const Trend& a) {
  return trend_detail::chain(asinh(a.v), Interval(1.0) / sqrt(sqr(a.v) + Interval(1.0)), a);
}
[[nodiscard]] inline Trend acosh(const Trend& a) {
  if (!(a.v.lo > 1)) return Trend::erratic(acosh(a.v));
  return trend_detail::chain(acosh(a.v), Interval(1.0) / sqrt(sqr(a.v) - Interval(1.0)), a);
}
[[nodiscard]] inline Trend atanh(const Trend& a) {
  if (!(a.v.lo > -1 && a.v.hi < 1)) return Trend::erratic(atanh(a.v));
  return trend_detail::chain(atanh(a.v), Interval(1.0) / (Interval(1.0) - sqr(a.v)), a);
}
[[nodiscard]] inline Trend atan2(const Trend& y, const Trend& x) {
  using trend_detail::product;
  const Interval v = atan2(y.v, x.v);
  const Interval r2 = sqr(x.v) + sqr(y.v);
  const bool jumps = interval_detail::has_zero(y.v) && x.v.lo <= 0;
  if (jumps || !(r2.lo > 0)) return Trend::erratic(v);
  const Interval along_y = x.v / r2;
  const Interval along_x = -y.v / r2;
  return {v, trend_detail::map([&](std::size_t i) {
            return product(along_y, y.d[i]) + product(along_x, x.d[i]);
          })};
}
[[nodiscard]] inline Trend fmod(const Trend& a, const Trend& m) {
  const Interval v = fmod(a.v, m.v);
  const bool whole = m.v.is_point() && m.v.lo != 0 && trend_detail::is_constant(m) && !a.v.nan &&
                     std::trunc(a.v.lo / m.v.lo) == std::trunc(a.v.hi / m.v.lo);
  return whole ? Trend{v, a.d} : Trend::erratic(v);
}
[[nodiscard]] inline Trend pow(const Trend& a, const Trend& b) {
  const Interval v = pow(a.v, b.v);
  if (trend_detail::is_constant(b) && b.v.is_point()) {
    const double e = b.v.lo;
    if (e == 0) return {v, {}};
    const bool integer = e == std::trunc(e) && e >= 1;
    if (integer || a.v.lo > 0) {
      return trend_detail::chain(v, Interval(e) * pow(a.v, Interval(e - 1)), a);
    }
    // A root at its end: as steep as you like, but rising.
    if (a.v.lo >= 0 && e > 0) {
      const Interval steep = pow(a.v, Interval(e - 1));
      return trend_detail::chain(v, {0, e >= 1 ? e * steep.hi : interval_detail::inf}, a);
    }
    return Trend::erratic(v);
  }
  if (!(a.v.lo > 0)) return Trend::erratic(v);
  return exp(b * log(a));
}

[[nodiscard]] inline Tri lt(const Trend& a, const Trend& b) { return lt(a.v, b.v); }
[[nodiscard]] inline Tri le(const Trend& a, const Trend& b) { return le(a.v, b.v); }
[[nodiscard]] inline Tri eq(const Trend& a, const Trend& b) { return eq(a.v, b.v); }
/// Undecided, the sides may differ at the seam: nothing is known about slopes across it.
[[nodiscard]] inline Trend where(Tri m, const Trend& a, const Trend& b) {
  if (!m.can_be_false) return a;
  return m.can_be_true ? Trend::erratic(hull(a.v, b.v)) : b;
}

}  // namespace durer

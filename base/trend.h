// Trends: the range of a formula over a box together with the ranges of its slopes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/circle.h"
#include "base/interval.h"
#include "base/ranges.h"

namespace durer {

/// A range and, along each axis, the range of the slopes: for any two points p, q of the box the
/// difference f(q) - f(p) is g · (q - p) for some g in the slopes. That holds at kinks too, where
/// they span both sides; where a formula may jump, they are unbounded.
class Trend {
 public:
  using Slopes = std::array<Interval, 3>;

  Trend() = default;
  Trend(double value)  // NOLINT: a number is a constant
      : Trend(Ranges{}, Interval(value)) {}
  Trend(const Interval& range, const Slopes& slopes)
      : Trend(side_by_side(range, known(slopes[0]), known(slopes[1]), known(slopes[2])),
              range.nan) {}
  /// From ranges of the value and the slopes, of which the first may be replaced.
  Trend(const Ranges& all, bool nan) : all_(all), bounded_(all.is_bounded()), nan_(nan) {}
  Trend(const Ranges& all, const Interval& range) : Trend(all.with_first(range), range.nan) {}
  /// Takes over ends from vectors of four. `bounded`: all are finite.
  template <class Quad>
  __attribute__((always_inline)) void assign(const Quad& lo, const Quad& hi, bool nan,
                                             bool bounded) {
    lo.store(reinterpret_cast<double*>(all_.lo));
    hi.store(reinterpret_cast<double*>(all_.hi));
    bounded_ = bounded;
    nan_ = nan;
  }
  /// The coordinate along `axis`.
  [[nodiscard]] static Trend coordinate(const Interval& range, std::size_t axis) {
    Slopes slopes{};
    slopes[axis] = 1.0;
    return {range, slopes};
  }
  /// Nothing is known about the slopes, as where there is a jump.
  [[nodiscard]] static Trend erratic(const Interval& range) {
    const Interval any = Interval::entire();
    return {range, Slopes{any, any, any}};
  }

  [[nodiscard]] Interval range() const {
    Interval r = all_.at(0);
    r.nan = nan_;
    return r;
  }
  [[nodiscard]] Interval slope(std::size_t axis) const { return all_.at(axis + 1); }
  /// The range and the slopes, side by side.
  [[nodiscard]] const Ranges& all() const { return all_; }
  [[nodiscard]] bool nan() const { return nan_; }
  /// True if all ends are finite: then the quick ways of calculating hold.
  [[nodiscard]] bool is_bounded() const { return bounded_; }

 private:
  static Interval known(const Interval& slope) { return slope.nan ? Interval::entire() : slope; }
  static Ranges side_by_side(const Interval& a, const Interval& b, const Interval& c,
                             const Interval& d) {
    return {{DoublePair{a.lo, b.lo}, DoublePair{c.lo, d.lo}},
            {DoublePair{a.hi, b.hi}, DoublePair{c.hi, d.hi}}};
  }

  Ranges all_;
  bool bounded_ = true;
  bool nan_ = false;
};

namespace trend_detail {
inline constexpr Interval zero{0.0, 0.0};

/// slope · s, but 0 where s is 0, so that an infinite slope does not spoil constants.
[[nodiscard]] inline Interval product(const Interval& slope, const Interval& s) {
  return s.lo == 0 && s.hi == 0 ? zero : slope * s;
}
template <class F>
[[nodiscard]] Trend::Slopes map(F f) {
  return {f(std::size_t{0}), f(std::size_t{1}), f(std::size_t{2})};
}
/// What follows if something is infinite: slope by slope.
[[nodiscard]] inline Trend chain_unbounded(const Interval& v, const Interval& slope,
                                           const Trend& a) {
  return {v, map([&](std::size_t i) { return product(slope, a.slope(i)); })};
}
[[nodiscard]] inline Trend add_unbounded(const Trend& a, const Trend& b) {
  return {a.range() + b.range(), map([&](std::size_t i) { return a.slope(i) + b.slope(i); })};
}
[[nodiscard]] inline Trend multiply_unbounded(const Trend& a, const Trend& b) {
  return {a.range() * b.range(), map([&](std::size_t i) {
            return product(b.range(), a.slope(i)) + product(a.range(), b.slope(i));
          })};
}

/// A formula of `a` whose value is `v` and whose derivative by `a` is `slope`.
[[nodiscard]] inline Trend chain(const Interval& v, const Interval& slope, const Trend& a) {
  if (a.is_bounded() && slope.is_bounded() && !slope.nan) {
    const Trend r(a.all() * slope, v);
    if (r.is_bounded()) return r;
  }
  return chain_unbounded(v, slope, a);
}
[[nodiscard]] inline Trend hull_of(const Interval& v, const Trend& a, const Trend& b) {
  return Trend(hull(a.all(), b.all()), v);
}
[[nodiscard]] inline bool is_constant(const Trend& a) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval s = a.slope(i);
    if (s.lo != 0 || s.hi != 0) return false;
  }
  return true;
}
/// A step function: flat, or with a jump inside.
[[nodiscard]] inline Trend steps(const Interval& v, const Trend& a) {
  if (v.is_point() || is_constant(a)) return {v, Trend::Slopes{}};
  return Trend::erratic(v);
}
}  // namespace trend_detail

[[nodiscard]] inline Trend operator-(const Trend& a) { return {-a.all(), a.nan()}; }
[[nodiscard]] inline Trend operator+(const Trend& a, const Trend& b) {
  if (a.is_bounded() && b.is_bounded()) {
    const Trend r(a.all() + b.all(), a.nan() || b.nan());
    if (r.is_bounded()) return r;
  }
  return trend_detail::add_unbounded(a, b);
}
[[nodiscard]] inline Trend operator-(const Trend& a, const Trend& b) {
  if (a.is_bounded() && b.is_bounded()) {
    const Trend r(a.all() - b.all(), a.nan() || b.nan());
    if (r.is_bounded()) return r;
  }
  return trend_detail::add_unbounded(a, -b);
}
[[nodiscard]] inline Trend operator*(const Trend& a, const Trend& b) {
  if (a.is_bounded() && b.is_bounded()) {
    const Ranges slopes = b.all().with_first(trend_detail::zero);
    const Trend r(a.all() * b.range() + slopes * a.range(), a.nan() || b.nan());
    if (r.is_bounded()) return r;
  }
  return trend_detail::multiply_unbounded(a, b);
}
/// Cheaper than with a range: the ends keep their order, or change places.
[[nodiscard]] inline Trend operator*(const Trend& a, double s) {
  if (a.is_bounded()) {
    const Trend r(a.all() * s, a.nan());
    if (r.is_bounded()) return r;
  }
  return a * Trend(s);
}
[[nodiscard]] inline Trend operator*(double s, const Trend& a) { return a * s; }
[[nodiscard]] inline Trend operator/(const Trend& a, const Trend& b) {
  using trend_detail::product;
  const Interval q = a.range() / b.range();
  if (interval_detail::has_zero(b.range())) return Trend::erratic(q);
  const Interval r = Interval(1.0) / b.range();
  if (a.is_bounded() && b.is_bounded() && q.is_bounded() && r.is_bounded()) {
    const Trend t((a.all() - b.all() * q) * r, q);
    if (t.is_bounded()) return t;
  }
  return {q, trend_detail::map(
                 [&](std::size_t i) { return product(r, a.slope(i) - product(q, b.slope(i))); })};
}
inline Trend& operator+=(Trend& a, const Trend& b) { return a = a + b; }
inline Trend& operator-=(Trend& a, const Trend& b) { return a = a - b; }
inline Trend& operator*=(Trend& a, const Trend& b) { return a = a * b; }
inline Trend& operator*=(Trend& a, double s) { return a = a * s; }

[[nodiscard]] inline Trend sqr(const Trend& a) {
  return trend_detail::chain(sqr(a.range()), Interval(2.0) * a.range(), a);
}
[[nodiscard]] inline Trend abs(const Trend& a) {
  const double least = a.range().lo >= 0 ? 1 : -1;
  const double most = a.range().hi <= 0 ? -1 : 1;
  return trend_detail::chain(abs(a.range()), {std::min(least, most), std::max(least, most)}, a);
}
[[nodiscard]] inline Trend min(const Trend& a, const Trend& b) {
  if (!a.range().nan && !b.range().nan) {
    if (a.range().hi < b.range().lo) return a;
    if (b.range().hi <= a.range().lo) return b;
    return trend_detail::hull_of(min(a.range(), b.range()), a, b);
  }
  return Trend::erratic(min(a.range(), b.range()));
}
[[nodiscard]] inline Trend max(const Trend& a, const Trend& b) {
  if (!a.range().nan && !b.range().nan) {
    if (a.range().hi < b.range().lo) return b;
    if (b.range().hi <= a.range().lo) return a;
    return trend_detail::hull_of(max(a.range(), b.range()), a, b);
  }
  return Trend::erratic(max(a.range(), b.range()));
}
[[nodiscard]] inline Trend floor(const Trend& a) {
  return trend_detail::steps(floor(a.range()), a);
}
[[nodiscard]] inline Trend ceil(const Trend& a) { return trend_detail::steps(ceil(a.range()), a); }
[[nodiscard]] inline Trend trunc(const Trend& a) {
  return trend_detail::steps(trunc(a.range()), a);
}
[[nodiscard]] inline Trend sqrt(const Trend& a) {
  const Interval s = sqrt(a.range());
  if (s.lo <= 0) return trend_detail::chain(s, {0, interval_detail::inf}, a);
  return trend_detail::chain(s, Interval(0.5) / s, a);
}
[[nodiscard]] inline Trend exp(const Trend& a) {
  const Interval e = exp(a.range());
  return trend_detail::chain(e, e, a);
}
[[nodiscard]] inline Trend log(const Trend& a) {
  if (!(a.range().lo > 0)) return Trend::erratic(log(a.range()));
  return trend_detail::chain(log(a.range()), Interval(1.0) / a.range(), a);
}
[[nodiscard]] inline Trend log10(const Trend& a) {
  if (!(a.range().lo > 0)) return Trend::erratic(log10(a.range()));
  return trend_detail::chain(log10(a.range()), Interval(1 / std::numbers::ln10) / a.range(), a);
}
[[nodiscard]] inline Trend sin(const Trend& a) {
  const Circle c = circle_of(a.range());
  return trend_detail::chain(c.sine, c.cosine, a);
}
[[nodiscard]] inline Trend cos(const Trend& a) {
  const Circle c = circle_of(a.range());
  return trend_detail::chain(c.cosine, -c.sine, a);
}
[[nodiscard]] inline Trend tan(const Trend& a) {
  const Interval t = tan(a.range());
  if (!t.is_bounded()) return Trend::erratic(t);
  return trend_detail::chain(t, Interval(1.0) + sqr(t), a);
}
[[nodiscard]] inline Trend asin(const Trend& a) {
  if (!(a.range().lo > -1 && a.range().hi < 1)) return Trend::erratic(asin(a.range()));
  return trend_detail::chain(asin(a.range()), Interval(1.0) / sqrt(Interval(1.0) - sqr(a.range())),
                             a);
}
[[nodiscard]] inline Trend acos(const Trend& a) {
  if (!(a.range().lo > -1 && a.range().hi < 1)) return Trend::erratic(acos(a.range()));
  return trend_detail::chain(acos(a.range()), Interval(-1.0) / sqrt(Interval(1.0) - sqr(a.range())),
                             a);
}
[[nodiscard]] inline Trend atan(const Trend& a) {
  return trend_detail::chain(atan(a.range()), Interval(1.0) / (Interval(1.0) + sqr(a.range())), a);
}
[[nodiscard]] inline Trend sinh(const Trend& a) {
  return trend_detail::chain(sinh(a.range()), cosh(a.range()), a);
}
[[nodiscard]] inline Trend cosh(const Trend& a) {
  return trend_detail::chain(cosh(a.range()), sinh(a.range()), a);
}
[[nodiscard]] inline Trend tanh(const Trend& a) {
  const Interval t = tanh(a.range());
  return trend_detail::chain(t, Interval(1.0) - sqr(t), a);
}
[[nodiscard]] inline Trend asinh(const Trend& a) {
  return trend_detail::chain(asinh(a.range()), Interval(1.0) / sqrt(sqr(a.range()) + Interval(1.0)),
                             a);
}
[[nodiscard]] inline Trend acosh(const Trend& a) {
  if (!(a.range().lo > 1)) return Trend::erratic(acosh(a.range()));
  return trend_detail::chain(acosh(a.range()), Interval(1.0) / sqrt(sqr(a.range()) - Interval(1.0)),
                             a);
}
[[nodiscard]] inline Trend atanh(const Trend& a) {
  if (!(a.range().lo > -1 && a.range().hi < 1)) return Trend::erratic(atanh(a.range()));
  return trend_detail::chain(atanh(a.range()), Interval(1.0) / (Interval(1.0) - sqr(a.range())), a);
}
[[nodiscard]] inline Trend atan2(const Trend& y, const Trend& x) {
  using trend_detail::product;
  const Interval v = atan2(y.range(), x.range());
  const Interval r2 = sqr(x.range()) + sqr(y.range());
  const bool jumps = interval_detail::has_zero(y.range()) && x.range().lo <= 0;
  if (jumps || !(r2.lo > 0)) return Trend::erratic(v);
  const Interval along_y = x.range() / r2;
  const Interval along_x = -y.range() / r2;
  return {v, trend_detail::map([&](std::size_t i) {
            return product(along_y, y.slope(i)) + product(along_x, x.slope(i));
          })};
}
[[nodiscard]] inline Trend fmod(const Trend& a, const Trend& m) {
  const Interval v = fmod(a.range(), m.range());
  const bool whole =
      m.range().is_point() && m.range().lo != 0 && trend_detail::is_constant(m) && !a.range().nan &&
      std::trunc(a.range().lo / m.range().lo) == std::trunc(a.range().hi / m.range().lo);
  return whole ? Trend(a.all(), v) : Trend::erratic(v);
}
[[nodiscard]] inline Trend pow(const Trend& a, const Trend& b) {
  const Interval v = pow(a.range(), b.range());
  if (trend_detail::is_constant(b) && b.range().is_point()) {
    const double e = b.range().lo;
    if (e == 0) return {v, Trend::Slopes{}};
    const bool integer = e == std::trunc(e) && e >= 1;
    if (integer || a.range().lo > 0) {
      return trend_detail::chain(v, Interval(e) * pow(a.range(), Interval(e - 1)), a);
    }
    // A root at its end: as steep as you like, but rising.
    if (a.range().lo >= 0 && e > 0) {
      const Interval steep = pow(a.range(), Interval(e - 1));
      return trend_detail::chain(v, {0, e >= 1 ? e * steep.hi : interval_detail::inf}, a);
    }
    return Trend::erratic(v);
  }
  if (!(a.range().lo > 0)) return Trend::erratic(v);
  return exp(b * log(a));
}

[[nodiscard]] inline Tri lt(const Trend& a, const Trend& b) { return lt(a.range(), b.range()); }
[[nodiscard]] inline Tri le(const Trend& a, const Trend& b) { return le(a.range(), b.range()); }
[[nodiscard]] inline Tri eq(const Trend& a, const Trend& b) { return eq(a.range(), b.range()); }
/// Undecided, the sides may differ at the seam: nothing is known about slopes across it.
[[nodiscard]] inline Trend where(Tri m, const Trend& a, const Trend& b) {
  if (!m.can_be_false) return a;
  return m.can_be_true ? Trend::erratic(hull(a.range(), b.range())) : b;
}

}  // namespace durer

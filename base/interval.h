// Interval arithmetic: what a formula can give when its inputs are only known to lie in ranges.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace durer {

/// A closed range [lo, hi] of doubles, possibly unbounded.
/// Contract: the result of an operation encloses every number that the same operation on doubles
/// *computes* from operands inside the ranges. Rounding to nearest is monotone, so + - * / sqrt
/// need no outward rounding for that; functions of the C library, which promise no monotony, are
/// padded. `nan` says that some operands inside the ranges may give NaN; [lo, hi] encloses the
/// other results.
struct Interval {
  double lo = 0;
  double hi = 0;
  bool nan = false;

  constexpr Interval() = default;
  constexpr Interval(double v) : lo(v), hi(v), nan(v != v) {  // NOLINT: a number is a range
    if (nan) *this = entire(true);
  }
  constexpr Interval(double l, double h, bool may_be_nan = false) : lo(l), hi(h), nan(may_be_nan) {}

  /// Every number; with `may_be_nan` also "not a number".
  [[nodiscard]] static constexpr Interval entire(bool may_be_nan = false) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {-inf, inf, may_be_nan};
  }
  [[nodiscard]] constexpr bool contains(double v) const {
    return v != v ? nan : lo <= v && v <= hi;
  }
  [[nodiscard]] constexpr bool is_point() const { return lo == hi && !nan; }
  [[nodiscard]] bool is_bounded() const { return std::isfinite(lo) && std::isfinite(hi); }
  [[nodiscard]] constexpr double mid() const { return lo + (hi - lo) / 2; }
  [[nodiscard]] constexpr double radius() const { return std::max(hi - mid(), mid() - lo); }
};

/// What a comparison of ranges can be; neither flag excludes the other.
struct Tri {
  bool can_be_true = false;
  bool can_be_false = false;
};

[[nodiscard]] constexpr Interval hull(Interval a, Interval b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi), a.nan || b.nan};
}
/// The common part; `a` itself where they are disjoint, which only rounding can cause.
[[nodiscard]] constexpr Interval narrowed(Interval a, Interval b) {
  const double lo = std::max(a.lo, b.lo);
  const double hi = std::min(a.hi, b.hi);
  return lo <= hi ? Interval{lo, hi, a.nan} : a;
}

namespace interval_detail {
inline constexpr double inf = std::numeric_limits<double>::infinity();
/// Relative pad for C library functions: glibc stays below 4 ulp, an ulp is at most 2.3e-16.
inline constexpr double library_pad = 2e-15;

[[nodiscard]] inline bool has_infinity(const Interval& a) { return a.lo == -inf || a.hi == inf; }
[[nodiscard]] inline bool has_zero(const Interval& a) { return a.lo <= 0 && a.hi >= 0; }
[[nodiscard]] inline double padded_down(double v) {
  return v * (v > 0 ? 1 - library_pad : 1 + library_pad);
}
[[nodiscard]] inline double padded_up(double v) {
  return v * (v > 0 ? 1 + library_pad : 1 - library_pad);
}
/// Image of an increasing library function `f`.
template <class F>
[[nodiscard]] Interval increasing(const Interval& a, F f) {
  if (a.lo == a.hi) return {f(a.lo), f(a.hi), a.nan};
  return {padded_down(f(a.lo)), padded_up(f(a.hi)), a.nan};
}
}  // namespace interval_detail

[[nodiscard]] inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo, a.nan}; }

[[nodiscard]] inline Interval operator+(const Interval& a, const Interval& b) {
  using interval_detail::inf;
  Interval r{a.lo + b.lo, a.hi + b.hi, a.nan || b.nan};
  if (!(r.lo > -inf && r.hi < inf)) {  // an infinite or NaN end
    r.nan = r.nan || (a.hi == inf && b.lo == -inf) || (a.lo == -inf && b.hi == inf);
    if (std::isnan(r.lo)) r.lo = -inf;
    if (std::isnan(r.hi)) r.hi = inf;
  }
  return r;
}
[[nodiscard]] inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

[[nodiscard]] inline Interval operator*(const Interval& a, const Interval& b) {
  using namespace interval_detail;
  double p = a.lo * b.lo;
  double q = a.lo * b.hi;
  double r = a.hi * b.lo;
  double s = a.hi * b.hi;
  bool nan = a.nan || b.nan;
  if (has_infinity(a) || has_infinity(b)) {
    for (double* e : {&p, &q, &r, &s}) {
      if (std::isnan(*e)) *e = 0;  // 0 times an end that stands for "however large"
    }
    nan = nan || (has_infinity(a) && has_zero(b)) || (has_infinity(b) && has_zero(a));
  }
  return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)), nan};
}

[[nodiscard]] inline Interval operator/(const Interval& a, const Interval& b) {
  using namespace interval_detail;
  const bool nan =
      a.nan || b.nan || (has_zero(a) && has_zero(b)) || (has_infinity(a) && has_infinity(b));
  if (has_zero(b) || (has_infinity(a) && has_infinity(b))) return Interval::entire(nan);
  const double p = a.lo / b.lo;
  const double q = a.lo / b.hi;
  const double r = a.hi / b.lo;
  const double s = a.hi / b.hi;
  return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)), nan};
}
inline Interval& operator+=(Interval& a, const Interval& b) { return a = a + b; }
inline Interval& operator-=(Interval& a, const Interval& b) { return a = a - b; }
inline Interval& operator*=(Interval& a, const Interval& b) { return a = a * b; }

[[nodiscard]] inline Interval sqr(const Interval& a) {
  const double p = a.lo * a.lo;
  const double q = a.hi * a.hi;
  return {interval_detail::has_zero(a) ? 0.0 : std::min(p, q), std::max(p, q), a.nan};
}
[[nodiscard]] inline Interval abs(const Interval& a) {
  const double p = std::abs(a.lo);
  const double q = std::abs(a.hi);
  return {interval_detail::has_zero(a) ? 0.0 : std::min(p, q), std::max(p, q), a.nan};
}
/// The language's minimum, a < b ? a : b, in which a NaN on either side lets the other one through.
[[nodiscard]] inline Interval min(const Interval& a, const Interval& b) {
  if (a.nan || b.nan) return hull(a, b);
  return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)};
}
[[nodiscard]] inline Interval max(const Interval& a, const Interval& b) {
  if (a.nan || b.nan) return hull(a, b);
  return {std::max(a.lo, b.lo), std::max(a.hi, b.hi)};
}

[[nodiscard]] inline Interval sqrt(const Interval& a) {
  if (a.hi < 0) return Interval::entire(true);
  return {std::sqrt(std::max(a.lo, 0.0)), std::sqrt(a.hi), a.nan || a.lo < 0};
}
[[nodiscard]] inline Interval exp(const Interval& a) {
  return interval_detail::increasing(a, [](double v) { return std::exp(v); });
}
[[nodiscard]] inline Interval log(const Interval& a) {
  if (a.hi < 0) return Interval::entire(true);
  const Interval r = interval_detail::increasing({std::max(a.lo, 0.0), a.hi, a.nan},
                                                 [](double v) { return std::log(v); });
  return {r.lo, r.hi, a.nan || a.lo < 0};
}
[[nodiscard]] inline Interval log10(const Interval& a) {
  if (a.hi < 0) return Interval::entire(true);
  const Interval r = interval_detail::increasing({std::max(a.lo, 0.0), a.hi, a.nan},
                                                 [](double v) { return std::log10(v); });
  return {r.lo, r.hi, a.nan || a.lo < 0};
}
[[nodiscard]] inline Interval floor(const Interval& a) {
  return {std::floor(a.lo), std::floor(a.hi), a.nan};
}
[[nodiscard]] inline Interval ceil(const Interval& a) {
  return {std::ceil(a.lo), std::ceil(a.hi), a.nan};
}
[[nodiscard]] inline Interval trunc(const Interval& a) {
  return {std::trunc(a.lo), std::trunc(a.hi), a.nan};
}
[[nodiscard]] inline Interval atan(const Interval& a) {
  return interval_detail::increasing(a, [](double v) { return std::atan(v); });
}
[[nodiscard]] inline Interval sinh(const Interval& a) {
  return interval_detail::increasing(a, [](double v) { return std::sinh(v); });
}
[[nodiscard]] inline Interval tanh(const Interval& a) {
  return interval_detail::increasing(a, [](double v) { return std::tanh(v); });
}
[[nodiscard]] inline Interval asinh(const Interval& a) {
  return interval_detail::increasing(a, [](double v) { return std::asinh(v); });
}
[[nodiscard]] inline Interval cosh(const Interval& a) {
  return interval_detail::increasing(abs(a), [](double v) { return std::cosh(v); });
}
[[nodiscard]] inline Interval acosh(const Interval& a) {
  if (a.hi < 1) return Interval::entire(true);
  const Interval r = interval_detail::increasing({std::max(a.lo, 1.0), a.hi},
                                                 [](double v) { return std::acosh(v); });
  return {r.lo, r.hi, a.nan || a.lo < 1};
}
[[nodiscard]] inline Interval atanh(const Interval& a) {
  if (a.hi < -1 || a.lo > 1) return Interval::entire(true);
  const Interval r = interval_detail::increasing({std::max(a.lo, -1.0), std::min(a.hi, 1.0)},
                                                 [](double v) { return std::atanh(v); });
  return {r.lo, r.hi, a.nan || a.lo < -1 || a.hi > 1};
}
[[nodiscard]] inline Interval asin(const Interval& a) {
  if (a.hi < -1 || a.lo > 1) return Interval::entire(true);
  const Interval r = interval_detail::increasing({std::max(a.lo, -1.0), std::min(a.hi, 1.0)},
                                                 [](double v) { return std::asin(v); });
  return {r.lo, r.hi, a.nan || a.lo < -1 || a.hi > 1};
}
[[nodiscard]] inline Interval acos(const Interval& a) {
  if (a.hi < -1 || a.lo > 1) return Interval::entire(true);
  const Interval r = interval_detail::increasing({-std::min(a.hi, 1.0), -std::max(a.lo, -1.0)},
                                                 [](double v) { return std::acos(-v); });
  return {r.lo, r.hi, a.nan || a.lo < -1 || a.hi > 1};
}

/// Beyond 1e9 the ends no longer tell where the poles lie.
[[nodiscard]] inline Interval tan(const Interval& a) {
  using std::numbers::pi;
  const bool nan = a.nan || interval_detail::has_infinity(a);
  if (a.lo == a.hi && !nan) return std::tan(a.lo);
  if (!(a.hi - a.lo < pi) || !(std::abs(a.lo) < 1e9)) return Interval::entire(nan);
  const double k = std::ceil((a.lo - pi / 2) / pi - 1e-6);
  if (pi / 2 + pi * k <= a.hi + 1e-5) return Interval::entire(nan);
  return interval_detail::increasing(a, [](double v) { return std::tan(v); });
}

/// atan2(y, x): angles of a box; the whole turn if the box touches the negative x axis.
[[nodiscard]] inline Interval atan2(const Interval& y, const Interval& x) {
  using std::numbers::pi;
  const bool nan = y.nan || x.nan;
  if (y.is_point() && x.is_point()) return std::atan2(y.lo, x.lo);
  if (interval_detail::has_zero(y) && x.lo <= 0) return {-pi, pi, nan};
  double lo = interval_detail::inf;
  double hi = -interval_detail::inf;
  for (const double v : {y.lo, y.hi}) {
    for (const double u : {x.lo, x.hi}) {
      lo = std::min(lo, std::atan2(v, u));
      hi = std::max(hi, std::atan2(v, u));
    }
  }
  return {interval_detail::padded_down(lo), interval_detail::padded_up(hi), nan};
}

/// fmod(a, m), sign of `a`: exact shift inside one period, else the whole period.
[[nodiscard]] inline Interval fmod(const Interval& a, const Interval& m) {
  if (a.is_point() && m.is_point()) return std::fmod(a.lo, m.lo);
  const bool nan =
      a.nan || m.nan || interval_detail::has_zero(m) || interval_detail::has_infinity(a);
  const double size = std::max(std::abs(m.lo), std::abs(m.hi));
  if (m.is_point() && !nan && (a.lo >= 0 || a.hi <= 0)) {
    const double p = std::fmod(a.lo, size);
    const double q = std::fmod(a.hi, size);
    if (a.hi - a.lo < size && p <= q) return {p, q};  // no jump between the ends
  }
  return {a.lo < 0 ? -std::min(size, -a.lo) : 0.0, a.hi > 0 ? std::min(size, a.hi) : 0.0, nan};
}

/// pow(a, b) of the C library. Exact shape for a ≥ 0 and for constant integer b.
[[nodiscard]] inline Interval pow(const Interval& a, const Interval& b) {
  using namespace interval_detail;
  if (a.is_point() && b.is_point()) return std::pow(a.lo, b.lo);
  const bool nan = a.nan || b.nan;
  const auto corners = [&](double u, double v) {
    double lo = inf;
    double hi = -inf;
    for (const double s : {u, v}) {
      for (const double e : {b.lo, b.hi}) {
        lo = std::min(lo, std::pow(s, e));
        hi = std::max(hi, std::pow(s, e));
      }
    }
    return Interval{padded_down(lo), padded_up(hi), nan};
  };
  if (a.lo > 0 || (a.lo == 0 && b.lo >= 0)) return corners(a.lo, a.hi);
  const bool integer = b.is_point() && b.lo == std::trunc(b.lo) && std::abs(b.lo) < 1e15;
  if (!integer || b.lo < 0) {  // a pole or NaN inside; the size is still bounded below zero
    return a.lo > 0 ? Interval{0, inf, nan} : Interval::entire(true);  // pow(-0, -1) is -inf
  }
  if (std::fmod(b.lo, 2) != 0) return corners(a.lo, a.hi);
  const Interval size = abs(a);
  return corners(size.lo, size.hi);
}

[[nodiscard]] inline Tri lt(const Interval& a, const Interval& b) {
  const bool nan = a.nan || b.nan;
  return {a.lo < b.hi, nan || a.hi >= b.lo};
}
[[nodiscard]] inline Tri le(const Interval& a, const Interval& b) {
  const bool nan = a.nan || b.nan;
  return {a.lo <= b.hi, nan || a.hi > b.lo};
}
[[nodiscard]] inline Tri eq(const Interval& a, const Interval& b) {
  const bool nan = a.nan || b.nan;
  return {a.lo <= b.hi && b.lo <= a.hi, nan || !(a.is_point() && b.is_point() && a.lo == b.lo)};
}
[[nodiscard]] inline Tri operator!(Tri m) { return {m.can_be_false, m.can_be_true}; }
[[nodiscard]] inline Tri operator&(Tri m, Tri n) {
  return {m.can_be_true && n.can_be_true, m.can_be_false || n.can_be_false};
}
[[nodiscard]] inline Tri operator|(Tri m, Tri n) {
  return {m.can_be_true || n.can_be_true, m.can_be_false && n.can_be_false};
}
[[nodiscard]] inline Interval where(Tri m, const Interval& a, const Interval& b) {
  if (!m.can_be_false) return a;
  return m.can_be_true ? hull(a, b) : b;
}

}  // namespace durer

// Sine and cosine, both at once and without the C library: of two angles, and of a range.
#pragma once

#include <array>
#include <cstdint>

#include "base/interval.h"
#include "base/ranges.h"

// Part of its caller, whatever instruction set that is compiled for.
#define DURER_CIRCLE_INLINE inline __attribute__((always_inline))

namespace durer {

/// Ranges of sine and cosine.
struct Circle {
  Interval sine;
  Interval cosine;
};

namespace circle_detail {
/// Beyond, the way back to the first quarter turn would be too inexact.
inline constexpr double farthest = 1e6;
/// More than the error of the series, and of any C library.
inline constexpr double pad = 1e-15;

/// c[0] + c[1] z + …, with 8 or 9 coefficients. All but the first two terms are summed in pairs, and
/// pairs of pairs (Estrin 1960), which need not wait for each other.
template <std::size_t n, class V>
[[nodiscard]] DURER_CIRCLE_INLINE V series(const std::array<double, n>& c, V z) {
  static_assert(n == 8 || n == 9);
  const V z2 = z * z;
  const V z4 = z2 * z2;
  V last = V{} + c[7];
  if constexpr (n == 9) last = last + c[8] * z;
  const V low = (c[1] + c[2] * z) + (c[3] + c[4] * z) * z2;
  const V high = (c[5] + c[6] * z) + last * z2;
  return c[0] + z * (low + high * z4);
}
/// ±1/first!, ∓1/(first+2)!, …
template <std::size_t n>
[[nodiscard]] constexpr std::array<double, n> factorials(int first) {
  std::array<double, n> c{};
  double f = 1;
  int last = first;
  for (double& v : c) {
    v = 1 / f;
    f *= -static_cast<double>((last + 1) * (last + 2));
    last += 2;
  }
  return c;
}
inline constexpr auto odd = factorials<8>(1);
inline constexpr auto even = factorials<9>(0);
}  // namespace circle_detail

/// Sines and cosines of several angles; how many quarter turns these are, rounded, and what is left.
template <class V>
struct OnCircle {
  V sine, cosine;
  V quarters, rest;
};
using PairOnCircle = OnCircle<DoublePair>;

/// True if the angle is not too large for on_circle().
[[nodiscard]] DURER_CIRCLE_INLINE bool fits_circle(double angle) {
  return angle > -circle_detail::farthest && angle < circle_detail::farthest;
}
/// V: a vector of doubles of any length. The same bits in every lane, on every processor. Error:
/// below 4e-16. Becomes part of its caller, and so is compiled for the caller's instruction set.
template <class V>
[[nodiscard]] DURER_CIRCLE_INLINE OnCircle<V> on_circle(V angles) {
  using namespace circle_detail;
  using Bits = decltype(angles < angles);
  // π/2 in three parts; the first two have so few digits that their products with quarters are exact.
  constexpr double part1 = 0x1.921fb544p+0;
  constexpr double part2 = 0x1.0b4611a6p-34;
  constexpr double part3 = 0x1.3198a2e037073p-69;
  constexpr double rounder = 0x1.8p52;  // leaves an integer in the lowest bits
  const V shifted = angles * (2 / std::numbers::pi) + rounder;
  const V k = shifted - rounder;
  const V r = ((angles - k * part1) - k * part2) - k * part3;
  const V z = r * r;
  const Bits s = Bits(r * series(odd, z));
  const Bits c = Bits(series(even, z));
  const Bits quarter = Bits(shifted);
  const Bits swapped = (s ^ c) & -(quarter & 1);
  const Bits sine_sign = (quarter << 62) & INT64_MIN;
  const Bits cosine_sign = ((quarter + 1) << 62) & INT64_MIN;
  return {V(s ^ swapped ^ sine_sign), V(c ^ swapped ^ cosine_sign), k, r};
}

namespace circle_detail {
[[nodiscard]] DURER_CIRCLE_INLINE bool is_part_of_circle(const Interval& a) {
  return a.hi - a.lo < 2 * std::numbers::pi && fits_circle(a.lo) && fits_circle(a.hi);
}
/// The whole circle, for a range that is not a part of it or too far away.
[[nodiscard]] DURER_CIRCLE_INLINE Circle whole_circle(const Interval& a) {
  const bool nan = a.nan || interval_detail::has_infinity(a);
  return {{-1, 1, nan}, {-1, 1, nan}};
}
/// The part of the circle between two ends.
[[nodiscard]] DURER_CIRCLE_INLINE Circle circle_between(const PairOnCircle& ends, bool nan) {
  using namespace ranges_detail;
  const DoublePair from{ends.sine[0], ends.cosine[0]};
  const DoublePair to{ends.sine[1], ends.cosine[1]};
  const DoublePair lo = greatest(least(from, to) - pad, DoublePair{-1, -1});
  const DoublePair hi = least(greatest(from, to) + pad, DoublePair{1, 1});
  // Quarter turns between the ends, one of five at most; at some of them lie the extremes. Nearly
  // there is there.
  constexpr double hair = 1e-9;
  const int first = static_cast<int>(ends.quarters[0]) + (ends.rest[0] > hair ? 1 : 0);
  const int last = static_cast<int>(ends.quarters[1]) - (ends.rest[1] < -hair ? 1 : 0);
  unsigned passed = (1U << std::max(last - first + 1, 0)) - 1;
  passed = (passed | passed >> 4) << (static_cast<unsigned>(first) & 3);
  passed |= passed >> 4;
  const auto passes = [&](unsigned quarter) { return (passed >> quarter & 1) != 0; };
  return {{passes(3) ? -1 : lo[0], passes(1) ? 1 : hi[0], nan},
          {passes(2) ? -1 : lo[1], passes(0) ? 1 : hi[1], nan}};
}
}  // namespace circle_detail

/// Encloses what std::sin and std::cos, or on_circle(), give for the numbers of a range.
[[nodiscard]] DURER_CIRCLE_INLINE Circle circle_of(const Interval& a) {
  using namespace circle_detail;
  if (!is_part_of_circle(a)) return whole_circle(a);
  return circle_between(on_circle(DoublePair{a.lo, a.hi}), a.nan);
}
/// Of two ranges at once. `Four`: a vector of four doubles.
template <class Four>
[[nodiscard]] DURER_CIRCLE_INLINE std::array<Circle, 2> circles_of(const Interval& a,
                                                                   const Interval& b) {
  using namespace circle_detail;
  if (!is_part_of_circle(a) || !is_part_of_circle(b)) return {circle_of(a), circle_of(b)};
  const OnCircle<Four> ends = on_circle(Four{a.lo, a.hi, b.lo, b.hi});
  const auto lower = [](const Four& v) { return DoublePair{v[0], v[1]}; };
  const auto upper = [](const Four& v) { return DoublePair{v[2], v[3]}; };
  return {circle_between({lower(ends.sine), lower(ends.cosine), lower(ends.quarters),
                          lower(ends.rest)},
                         a.nan),
          circle_between({upper(ends.sine), upper(ends.cosine), upper(ends.quarters),
                          upper(ends.rest)},
                         b.nan)};
}
[[nodiscard]] inline Interval sin(const Interval& a) {
  return a.is_point() ? Interval(std::sin(a.lo)) : circle_of(a).sine;
}
[[nodiscard]] inline Interval cos(const Interval& a) {
  return a.is_point() ? Interval(std::cos(a.lo)) : circle_of(a).cosine;
}

}  // namespace durer

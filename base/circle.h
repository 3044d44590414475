// Sine and cosine of ranges, both at once, without the C library's.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "base/interval.h"
#include "base/ranges.h"

namespace durer {

struct Circle {
  Interval sine;
  Interval cosine;
};

namespace circle_detail {
/// Beyond, the way back to the first quarter turn would be too inexact.
inline constexpr double farthest = 1e6;
/// More than the error of the series, and of any C library.
inline constexpr double pad = 4e-16;

/// c[0] + c[1] z + …
template <std::size_t n>
[[nodiscard]] inline DoublePair series(const std::array<double, n>& c, DoublePair z) {
  DoublePair sum{c[n - 1], c[n - 1]};
  for (std::size_t i = n - 1; i-- > 0;) sum = sum * z + c[i];
  return sum;
}
/// ±1/first!, ∓1/(first+2)!, …
template <std::size_t n>
[[nodiscard]] constexpr std::array<double, n> factorials(int first) {
  std::array<double, n> c{};
  double f = 1;
  for (int i = 2; i <= first; ++i) f *= i;
  int last = first;
  for (double& v : c) {
    v = 1 / f;
    f *= -static_cast<double>((last + 1) * (last + 2));
    last += 2;
  }
  return c;
}

/// Quarter turns, rounded, and what the sine of an angle is with each of the next four added.
struct Turned {
  std::int64_t quarters;
  double rest;
  std::array<double, 4> sine;
};
[[nodiscard]] inline std::array<Turned, 2> turned(const Interval& a) {
  // π/2 in three parts; the first two have so few digits that their products with quarters are exact.
  constexpr double part1 = 0x1.921fb544p+0;
  constexpr double part2 = 0x1.0b4611a6p-34;
  constexpr double part3 = 0x1.3198a2e037073p-69;
  constexpr double rounder = 0x1.8p52;
  const DoublePair x{a.lo, a.hi};
  const DoublePair shifted = x * (2 / std::numbers::pi) + rounder;
  const DoublePair k = shifted - rounder;
  const DoublePair r = ((x - k * part1) - k * part2) - k * part3;
  const DoublePair z = r * r;
  static constexpr auto odd = factorials<8>(1);
  static constexpr auto even = factorials<9>(0);
  const DoublePair s = r * series(odd, z);
  const DoublePair c = series(even, z);
  const auto end = [&](int i) {
    return Turned{static_cast<std::int64_t>(k[i]), r[i], {s[i], c[i], -s[i], -c[i]}};
  };
  return {end(0), end(1)};
}
}  // namespace circle_detail

/// Encloses what std::sin and std::cos give for the numbers of a range.
[[nodiscard]] inline Circle circle_of(const Interval& a) {
  using namespace circle_detail;
  const bool nan = a.nan || interval_detail::has_infinity(a);
  if (a.lo == a.hi && !nan) return {std::sin(a.lo), std::cos(a.lo)};
  if (!(a.hi - a.lo < 2 * std::numbers::pi) || !(a.lo > -farthest && a.hi < farthest)) {
    return {{-1, 1, nan}, {-1, 1, nan}};
  }
  const auto [low, high] = turned(a);
  // Quarter turns between the ends; at some of them lie the extremes. Nearly there is there.
  constexpr double hair = 1e-9;
  const std::int64_t first = low.quarters + (low.rest > hair ? 1 : 0);
  const std::int64_t last = high.quarters - (high.rest < -hair ? 1 : 0);
  const auto passes = [&](int quarter) { return first + ((quarter - first) & 3) <= last; };
  const auto range = [&](int shift) {
    const double p = low.sine[static_cast<std::size_t>((low.quarters + shift) & 3)];
    const double q = high.sine[static_cast<std::size_t>((high.quarters + shift) & 3)];
    return Interval{passes(3 - shift) ? -1 : std::max(std::min(p, q) - pad, -1.0),
                    passes(1 - shift) ? 1 : std::min(std::max(p, q) + pad, 1.0), nan};
  };
  return {range(0), range(1)};
}
[[nodiscard]] inline Interval sin(const Interval& a) { return circle_of(a).sine; }
[[nodiscard]] inline Interval cos(const Interval& a) { return circle_of(a).cosine; }

}  // namespace durer

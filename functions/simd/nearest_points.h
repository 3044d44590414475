// The smallest distances from a point to a few dozen others, once per instruction set. Every set
// computes the same bits.
#pragma once

#include <array>
#include <limits>

#include "base/vec.h"

namespace durer::functions::simd {

/// Points by coordinate; `count` is a multiple of four (fill up with points that are far away).
struct PointList {
  const double* x = nullptr;
  const double* y = nullptr;
  const double* z = nullptr;
  int count = 0;
};

/// The three smallest of several distances, ascending. Distances are sums of powers of coordinates.
using Smallest3 = std::array<double, 3>;
inline constexpr Smallest3 nothing_near = [] {
  constexpr double far = std::numeric_limits<double>::infinity();
  return Smallest3{far, far, far};
}();

/// `so_far` and the distances from `p` to `points`: |dx|^n + |dy|^n + |dz|^n for n = `exponent`,
/// at least 1.
[[nodiscard]] Smallest3 smallest_distances(const PointList& points, const dvec3& p, int exponent,
                                           const Smallest3& so_far = nothing_near);
/// The same for four points side by side, which is faster than one after another.
using FourPoints = std::array<dvec3, 4>;
using FourSmallest3 = std::array<Smallest3, 4>;
[[nodiscard]] FourSmallest3 smallest_distances(const PointList& points, const FourPoints& p,
                                               int exponent);
/// The same by a given instruction set, for tests: 0 baseline, 1 the best.
[[nodiscard]] Smallest3 smallest_distances(const PointList& points, const dvec3& p, int exponent,
                                           const Smallest3& so_far, int set);
[[nodiscard]] FourSmallest3 smallest_distances(const PointList& points, const FourPoints& p,
                                               int exponent, int set);

}  // namespace durer::functions::simd

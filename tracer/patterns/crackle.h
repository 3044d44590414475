// The cells of `crackle` and `facets`: every unit cube holds one random point (textures §5.1).
#pragma once

#include <array>
#include <cstdint>

#include "functions/simd/nearest_points.h"

namespace durer::tracer::patterns {

/// A cube of the lattice.
struct CrackleCube {
  std::int64_t x = 0, y = 0, z = 0;

  /// That in which crackle finds `p`: the lower one exactly at whole numbers.
  [[nodiscard]] static CrackleCube around(dvec3 p);
  bool operator==(const CrackleCube&) const = default;
};

/// Some of the random points around a cube.
template <std::size_t n>
struct CracklePoints {
  // Whole groups of four; what is too much lies far away.
  static constexpr std::size_t count = n;
  static constexpr std::size_t room = (n + 3) / 4 * 4;
  alignas(32) std::array<double, room> x, y, z;

  [[nodiscard]] functions::simd::PointList list() const {
    return {x.data(), y.data(), z.data(), static_cast<int>(room)};
  }
  [[nodiscard]] dvec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// The 81 cubes that may hold one of the points nearest to a point in the middle one: those beside
/// it, and those one farther that are at most one farther along one axis only.
struct CrackleCell {
  CrackleCube cube;
  CracklePoints<27> near;
  CracklePoints<54> far;
  bool near_known = false;
  bool far_known = false;

  /// What lies in `far` is at least so far away from `p` along some axis.
  [[nodiscard]] double distance_to_far(dvec3 p) const;
};

/// The cell around a cube, with the points near it; they depend on the cube alone. A thread keeps
/// the last few: what is looked up is nearly always beside what was looked up before.
[[nodiscard]] CrackleCell& crackle_cell(const CrackleCube& cube);
/// The points of its farther cubes.
[[nodiscard]] const CracklePoints<54>& far_points(CrackleCell& cell);

}  // namespace durer::tracer::patterns

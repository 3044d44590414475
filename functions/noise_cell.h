// The cell of a noise lattice that a point lies in: shared by value, bounds and gradient.
#pragma once

#include <cmath>
#include <cstdint>

#include "functions/noise_tables.h"
#include "functions/simd/inline.h"

namespace durer::functions {

using simd::to_int32;

/// Where a coordinate lies on its axis of the lattice.
struct CellAxis {
  std::uint32_t index;  // of the lower lattice plane, before masking
  double f;             // position in the cell, [0, 1)
  double s;             // smoothed position f²(3 - 2f)
};

[[nodiscard]] DURER_INLINE double smooth_step(double f) { return f * f * (3 - 2 * f); }

/// Generators 1 and 2. Integers below zero belong to the cell beneath, hence the shift before
/// truncation that leaves them just inside it.
[[nodiscard]] DURER_INLINE CellAxis table_axis(double x) {
  const std::int32_t n = to_int32(x - simd::if_negative(x, 1 - 1e-10));
  const double f = x - n;
  return {static_cast<std::uint32_t>(n) + 10000u, f, smooth_step(f)};
}
/// Generator 3.
[[nodiscard]] DURER_INLINE CellAxis gradient_axis(double x) {
  const double t = x + gradient_origin;
  const std::int32_t n = to_int32(std::floor(t));
  const double f = t - n;
  return {static_cast<std::uint32_t>(n), f, smooth_step(f)};
}

/// Eight corners, each with {value, gradient}; corner number = a + 2b + 4c for offsets (a, b, c).
struct Cell {
  CellAxis x, y, z;
  const double* row[8];
};

/// The row that a place of `row_offsets` tells.
[[nodiscard]] DURER_INLINE const double* row_at(std::uint32_t offset) {
  return reinterpret_cast<const double*>(reinterpret_cast<const char*>(corner_rows.data()) +
                                         offset);
}

[[nodiscard]] DURER_INLINE Cell table_cell(double px, double py, double pz) {
  constexpr std::uint32_t mask = lattice_size - 1;
  Cell cell{table_axis(px), table_axis(py), table_axis(pz), {}};
  for (std::uint32_t a = 0; a < 2; ++a) {
    const std::uint32_t hx = permutation[(cell.x.index + a) & mask];
    for (std::uint32_t b = 0; b < 2; ++b) {
      const std::uint32_t hy = permutation[hx ^ ((cell.y.index + b) & mask)];
      for (std::uint32_t c = 0; c < 2; ++c) {
        cell.row[a + 2 * b + 4 * c] = row_at(row_offsets[hy ^ ((cell.z.index + c) & mask)]);
      }
    }
  }
  return cell;
}

[[nodiscard]] DURER_INLINE Cell gradient_cell(const GradientLattice& t, double px, double py,
                                              double pz) {
  constexpr std::uint32_t mask = 2047;
  Cell cell{gradient_axis(px), gradient_axis(py), gradient_axis(pz), {}};
  for (std::uint32_t a = 0; a < 2; ++a) {
    const std::uint32_t hx = t.p[(cell.x.index + a) & mask];
    for (std::uint32_t b = 0; b < 2; ++b) {
      const std::uint32_t hy = t.p[(hx + cell.y.index + b) & mask];
      for (std::uint32_t c = 0; c < 2; ++c) {
        cell.row[a + 2 * b + 4 * c] = t.gradients[(hy + cell.z.index + c) & mask].c;
      }
    }
  }
  return cell;
}

/// What generators 1, 2 and 3 make of the interpolated sum: offset, then scale, then clamp to [0,
/// 1].
struct NoiseScale {
  double offset;
  double scale;
};
[[nodiscard]] DURER_INLINE NoiseScale noise_scale(int generator) {
  if (generator == 3) return {0.985 / 1.59, 0.5 * 1.59};
  return generator == 2 ? NoiseScale{1.05242, 0.48985582} : NoiseScale{0.5, 1.0};
}

}  // namespace durer::functions

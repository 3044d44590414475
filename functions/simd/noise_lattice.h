// Interpolation in a noise lattice: of one point at a time, or of four that need not lie together.
#pragma once

#include "functions/noise_cell.h"
#include "functions/simd/noise_lanes.h"
#include "functions/simd/shared_cell.h"

namespace durer::functions::simd {

/// The planes of the lattice on both sides of a coordinate, masked.
struct Planes {
  std::uint32_t below;
  std::uint32_t above;

  DURER_INLINE Planes(const NoiseLanes& lanes, int i)
      : below(lanes.index[i]), above(lanes.next_index[i]) {}
  DURER_INLINE Planes(std::uint32_t plane, std::uint32_t mask)
      : below(plane & mask), above((plane + 1) & mask) {}
};

// The eight rows of a cell: number a + 2b + 4c for corner (a, b, c).
struct TableCorners {
  using Axis = TableAxis;
  const double* row[8];

  DURER_INLINE TableCorners(const Planes& x, const Planes& y, const Planes& z) {
    const std::uint32_t hx[2] = {permutation[x.below], permutation[x.above]};
    for (unsigned a = 0; a < 2; ++a) {
      const std::uint32_t hy[2] = {permutation[hx[a] ^ y.below], permutation[hx[a] ^ y.above]};
      for (unsigned b = 0; b < 2; ++b) {
        row[a + 2 * b] = row_at(row_offsets[hy[b] ^ z.below]);
        row[a + 2 * b + 4] = row_at(row_offsets[hy[b] ^ z.above]);
      }
    }
  }
};
struct GradientCorners {
  using Axis = GradientAxis;
  const double* row[8];

  DURER_INLINE GradientCorners(const Planes& x, const Planes& y, const Planes& z) {
    const GradientLattice& t = gradient_lattice();
    constexpr std::uint32_t mask = GradientAxis::mask;
    const std::uint32_t hx[2] = {t.p[x.below], t.p[x.above]};
    for (unsigned a = 0; a < 2; ++a) {
      const std::uint32_t hy[2] = {t.p[(hx[a] + y.below) & mask], t.p[(hx[a] + y.above) & mask]};
      for (unsigned b = 0; b < 2; ++b) {
        row[a + 2 * b] = t.gradients[(hy[b] + z.below) & mask].c;
        row[a + 2 * b + 4] = t.gradients[(hy[b] + z.above) & mask].c;
      }
    }
  }
};

/// The weight of a corner is separable, also with the dot product of its gradient folded in: lane 1
/// of the x factor is the slope's, and likewise lane 2 of y and lane 3 of z.
template <class Quad>
struct Weights {
  Quad x0, x1, y0, y1, z0, z1;

  explicit DURER_INLINE Weights(const Cell& cell)
      : x0(Quad::of(below(cell.x), below(cell.x) * cell.x.f, below(cell.x), below(cell.x))),
        x1(Quad::of(cell.x.s, cell.x.s * (cell.x.f - 1), cell.x.s, cell.x.s)),
        y0(Quad::of(below(cell.y), below(cell.y), below(cell.y) * cell.y.f, below(cell.y))),
        y1(Quad::of(cell.y.s, cell.y.s, cell.y.s * (cell.y.f - 1), cell.y.s)),
        z0(Quad::of(below(cell.z), below(cell.z), below(cell.z), below(cell.z) * cell.z.f)),
        z1(Quad::of(cell.z.s, cell.z.s, cell.z.s, cell.z.s * (cell.z.f - 1))) {}
  DURER_INLINE Weights(const NoiseLanes& x, int i, const NoiseLanes& y, int j, const NoiseLanes& z,
                       int k)
      : x0(Quad::template mixed<1>(x.below[i], x.below_slope[i])),
        x1(Quad::template mixed<1>(x.above[i], x.above_slope[i])),
        y0(Quad::template mixed<2>(y.below[j], y.below_slope[j])),
        y1(Quad::template mixed<2>(y.above[j], y.above_slope[j])),
        z0(Quad::template mixed<3>(z.below[k], z.below_slope[k])),
        z1(Quad::template mixed<3>(z.above[k], z.above_slope[k])) {}

  /// What value and gradients add over the eight corners; rows start `skip` numbers behind `row`.
  DURER_INLINE Quad parts(const double* const (&row)[8], int skip = 0) const {
    const auto edge = [&](int corner) DURER_LAMBDA_INLINE {
      return Quad::load(row[corner] + skip) * x0 + Quad::load(row[corner + 1] + skip) * x1;
    };
    return (edge(0) * y0 + edge(2) * y1) * z0 + (edge(4) * y0 + edge(6) * y1) * z1;
  }

 private:
  static DURER_INLINE double below(const CellAxis& a) { return 1 - a.s; }
};

/// Four points of which each lies somewhere, in lanes.
template <class Axis, class Quad>
struct FourApart {
  NoiseLanes x, y, z;

  DURER_INLINE FourApart(const double* px, const double* py, const double* pz) {
    fill<typename Quad::Register, Axis>(x, px);
    fill<typename Quad::Register, Axis>(y, py);
    fill<typename Quad::Register, Axis>(z, pz);
  }
  explicit DURER_INLINE FourApart(const FourPlaces<Axis, Quad>& places) {
    places.x.store(x);
    places.y.store(y);
    places.z.store(z);
  }
  template <class Corners>
  DURER_INLINE Corners corners(int i) const {
    return Corners(Planes(x, i), Planes(y, i), Planes(z, i));
  }
  DURER_INLINE Weights<Quad> weights(int i) const { return Weights<Quad>(x, i, y, i, z, i); }

  /// The interpolated sums; only `count` of them matter. `Corners`: the lattice.
  template <class Corners>
  DURER_INLINE Quad sums(int count) const {
    Quad parts[4];
    for (int i = 0; i < count; ++i) parts[i] = weights(i).parts(corners<Corners>(i).row);
    for (int i = count; i < 4; ++i) parts[i] = parts[0];
    return Quad::sums(parts[0], parts[1], parts[2], parts[3]);
  }
};

/// The cell of four points that share one.
template <class Corners, class Quad>
DURER_INLINE Corners shared_corners(const FourPlaces<typename Corners::Axis, Quad>& places) {
  constexpr std::uint32_t mask = Corners::Axis::mask;
  return Corners(Planes(places.x.plane(), mask), Planes(places.y.plane(), mask),
                 Planes(places.z.plane(), mask));
}

/// The interpolated sums of four points that are likely to lie together.
template <class Corners, class Quad>
DURER_INLINE Quad lattice_sums(Quad x, Quad y, Quad z, int count) {
  const FourPlaces<typename Corners::Axis, Quad> places(x, y, z);
  if (places.share_cell()) return places.sums(shared_corners<Corners>(places).row);
  return FourApart<typename Corners::Axis, Quad>(places).template sums<Corners>(count);
}

/// Vector noise of four points, by component.
template <class Quad>
struct VectorNoises {
  Quad x, y, z;

  /// Of points that are likely to lie together; only `count` of them matter.
  DURER_INLINE VectorNoises(Quad px, Quad py, Quad pz, int count) {
    constexpr int skip = 16;  // from the rows of one component to those of the next
    const FourPlaces<TableAxis, Quad> places(px, py, pz);
    if (places.share_cell()) {
      const auto corners = shared_corners<TableCorners>(places);
      x = places.sums(corners.row);
      y = places.sums(corners.row, skip);
      z = places.sums(corners.row, 2 * skip);
      return;
    }
    const FourApart<TableAxis, Quad> apart(places);
    Quad parts[3][4];
    for (int i = 0; i < count; ++i) {
      const auto corners = apart.template corners<TableCorners>(i);
      const Weights<Quad> weights = apart.weights(i);
      for (int k = 0; k < 3; ++k) parts[k][i] = weights.parts(corners.row, skip * k);
    }
    for (int i = count; i < 4; ++i) {
      for (auto& part : parts) part[i] = part[0];
    }
    x = Quad::sums(parts[0][0], parts[0][1], parts[0][2], parts[0][3]);
    y = Quad::sums(parts[1][0], parts[1][1], parts[1][2], parts[1][3]);
    z = Quad::sums(parts[2][0], parts[2][1], parts[2][2], parts[2][3]);
  }
};

}  // namespace durer::functions::simd

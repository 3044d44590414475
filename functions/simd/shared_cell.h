// Four points in one cell of a noise lattice, with a lane each: corners are read once for all, and
// nothing has to be shuffled. Neighbours in a picture mostly are such points, in all octaves but the
// finest. The same products and sums, in the same order, as one point at a time.
#pragma once

#include <cstdint>

#include "functions/simd/noise_lanes.h"

namespace durer::functions::simd {

/// Four coordinates along one axis, in the registers of a Quad: one, or two halves.
template <class Axis, class Quad>
class AxisOfFour;

template <class Axis>
class AxisOfFour<Axis, WideQuad> {
 public:
  explicit DURER_INLINE AxisOfFour(WideQuad x) : w_(x.v) {}

  [[nodiscard]] DURER_INLINE WideQuad below() const { return {w_.below}; }
  [[nodiscard]] DURER_INLINE WideQuad above() const { return {w_.above}; }
  [[nodiscard]] DURER_INLINE WideQuad below_slope() const { return {w_.below_slope}; }
  [[nodiscard]] DURER_INLINE WideQuad above_slope() const { return {w_.above_slope}; }
  /// The plane of the first coordinate, and how those of the others differ: 0 if they do not.
  [[nodiscard]] DURER_INLINE std::uint32_t plane() const { return w_.plane[0]; }
  using Differences = std::uint32_t __attribute__((vector_size(16)));
  [[nodiscard]] DURER_INLINE Differences differences() const {
    return w_.plane ^ __builtin_shufflevector(w_.plane, w_.plane, 0, 0, 0, 0);
  }
  DURER_INLINE void store(NoiseLanes& out) const { w_.store(out, 0); }

 private:
  LaneWeights<Double4, Axis> w_;
};

template <class Axis>
class AxisOfFour<Axis, PairQuad> {
 public:
  explicit DURER_INLINE AxisOfFour(PairQuad x) : lo_(x.lo), hi_(x.hi) {}

  [[nodiscard]] DURER_INLINE PairQuad below() const { return {lo_.below, hi_.below}; }
  [[nodiscard]] DURER_INLINE PairQuad above() const { return {lo_.above, hi_.above}; }
  [[nodiscard]] DURER_INLINE PairQuad below_slope() const {
    return {lo_.below_slope, hi_.below_slope};
  }
  [[nodiscard]] DURER_INLINE PairQuad above_slope() const {
    return {lo_.above_slope, hi_.above_slope};
  }
  [[nodiscard]] DURER_INLINE std::uint32_t plane() const { return lo_.plane[0]; }
  using Differences = std::uint32_t;
  [[nodiscard]] DURER_INLINE Differences differences() const {
    const std::uint32_t first = plane();
    return (lo_.plane[1] ^ first) | (hi_.plane[0] ^ first) | (hi_.plane[1] ^ first);
  }
  DURER_INLINE void store(NoiseLanes& out) const {
    lo_.store(out, 0);
    hi_.store(out, 2);
  }

 private:
  LaneWeights<Double2, Axis> lo_, hi_;
};

DURER_INLINE bool is_zero(std::uint32_t v) { return v == 0; }
DURER_INLINE bool is_zero(std::uint32_t __attribute__((vector_size(16))) v) {
  using Halves = std::uint64_t __attribute__((vector_size(16)));
  const auto halves = Halves(v);
  return (halves[0] | halves[1]) == 0;
}

/// Four points, by axis.
template <class Axis, class Quad>
struct FourPlaces {
  AxisOfFour<Axis, Quad> x, y, z;

  DURER_INLINE FourPlaces(Quad px, Quad py, Quad pz) : x(px), y(py), z(pz) {}

  /// True if they lie in one cell.
  [[nodiscard]] DURER_INLINE bool share_cell() const {
    return is_zero(x.differences() | y.differences() | z.differences());
  }

  /// The interpolated sums over the corners of the cell that they share. Rows of corners start
  /// `skip` numbers behind `row`; each is a value, then a gradient.
  [[nodiscard]] DURER_INLINE Quad sums(const double* const (&row)[8], int skip = 0) const {
    const Quad value = part(row, skip, x.below(), x.above(), y.below(), y.above(), z.below(),
                            z.above());
    const Quad along_x = part(row, skip + 1, x.below_slope(), x.above_slope(), y.below(),
                              y.above(), z.below(), z.above());
    const Quad along_y = part(row, skip + 2, x.below(), x.above(), y.below_slope(),
                              y.above_slope(), z.below(), z.above());
    const Quad along_z = part(row, skip + 3, x.below(), x.above(), y.below(), y.above(),
                              z.below_slope(), z.above_slope());
    return (value + along_x) + (along_y + along_z);
  }

 private:
  // What number `k` of the corners' rows adds, for given weights of the planes.
  static DURER_INLINE Quad part(const double* const (&row)[8], int k, const Quad& x0,
                                const Quad& x1, const Quad& y0, const Quad& y1, const Quad& z0,
                                const Quad& z1) {
    const auto edge = [&](int corner) DURER_LAMBDA_INLINE {
      return Quad::all(row[corner] + k) * x0 + Quad::all(row[corner + 1] + k) * x1;
    };
    return (edge(0) * y0 + edge(2) * y1) * z0 + (edge(4) * y0 + edge(6) * y1) * z1;
  }
};

}  // namespace durer::functions::simd

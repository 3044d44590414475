// Four coordinates at a time: where each lies in its cell of a noise lattice, and the weights of the
// two lattice planes beside it.
#pragma once

#include "functions/noise_tables.h"
#include "functions/simd/quad.h"

namespace durer::functions::simd {

/// Four coordinates, of one point or of several. Weights have the dot product with a corner's
/// gradient folded in: `below` and `above` are those of the two planes, `below_slope` and
/// `above_slope` the same times the distance to the plane.
struct NoiseLanes {
  alignas(32) double below[4];
  alignas(32) double below_slope[4];
  alignas(32) double above[4];
  alignas(32) double above_slope[4];
  alignas(16) std::uint32_t index[4];       // of the plane below, masked
  alignas(16) std::uint32_t next_index[4];  // of the one above, masked
};

/// What fits into one register of V: doubles, and as many 32-bit integers.
template <class V>
struct LaneInts;
template <>
struct LaneInts<Double2> {
  static constexpr int lanes = 2;
  using Signed = std::int32_t __attribute__((vector_size(8)));
  using Unsigned = std::uint32_t __attribute__((vector_size(8)));
  using Long = std::int64_t __attribute__((vector_size(16)));
};
template <>
struct LaneInts<Double4> {
  static constexpr int lanes = 4;
  using Signed = std::int32_t __attribute__((vector_size(16)));
  using Unsigned = std::uint32_t __attribute__((vector_size(16)));
  using Long = std::int64_t __attribute__((vector_size(32)));
};

/// Cutting off the fraction; as to_int32 does.
template <class V>
DURER_INLINE typename LaneInts<V>::Signed to_ints(V v) {
  using Signed = typename LaneInts<V>::Signed;
  if constexpr (LaneInts<V>::lanes == 4) return __builtin_convertvector(v, Signed);
  return Signed{to_int32(v[0]), to_int32(v[1])};
}
template <class V>
DURER_INLINE V to_doubles(typename LaneInts<V>::Signed n) {
#if defined(__x86_64__) && !defined(__clang__)
  if constexpr (LaneInts<V>::lanes == 4) return __builtin_ia32_cvtdq2pd256(n);  // GCC takes six
#endif
  if constexpr (LaneInts<V>::lanes == 4) return __builtin_convertvector(n, V);
  return V{static_cast<double>(n[0]), static_cast<double>(n[1])};
}

/// Generators 1 and 2: as table_axis().
struct TableAxis {
  static constexpr std::uint32_t mask = lattice_size - 1;
  static constexpr std::uint32_t origin = 10000;

  template <class V>
  static DURER_INLINE typename LaneInts<V>::Signed cell(V& x) {
    using Long = typename LaneInts<V>::Long;
    constexpr double half = (1 - 1e-10) / 2;
    const Long sign = Long(x) & INT64_MIN;
    const V shift = half - V(sign | Long(V{} + half));  // if_negative()
    const typename LaneInts<V>::Signed n = to_ints<V>(x - shift);
    x -= to_doubles<V>(n);
    return n;
  }
};
/// Generator 3: as gradient_axis().
struct GradientAxis {
  static constexpr std::uint32_t mask = 2047;
  static constexpr std::uint32_t origin = 0;

  template <class V>
  static DURER_INLINE typename LaneInts<V>::Signed cell(V& x) {
    using Long = typename LaneInts<V>::Long;
    x += gradient_origin;
    V n = to_doubles<V>(to_ints<V>(x));
    n -= V(Long(n > x) & Long(V{} + 1.0));  // rounded down, not towards zero
    x -= n;
    return to_ints<V>(n);
  }
};

/// Of as many coordinates as a register of V holds: their cells, and the weights.
template <class V, class Axis>
struct LaneWeights {
  using Unsigned = typename LaneInts<V>::Unsigned;

  Unsigned plane;  // of the lattice, below; not masked
  V below, below_slope, above, above_slope;

  explicit DURER_INLINE LaneWeights(V x) {
    plane = Unsigned(Axis::template cell<V>(x)) + Axis::origin;
    above = x * x * (3 - 2 * x);
    below = 1 - above;
    below_slope = below * x;
    above_slope = above * (x - 1);
  }
  /// Puts them where lanes of NoiseLanes are, from `i` on.
  DURER_INLINE void store(NoiseLanes& out, int i) const {
    put(below, out.below + i);
    put(below_slope, out.below_slope + i);
    put(above, out.above + i);
    put(above_slope, out.above_slope + i);
    put(plane & Axis::mask, out.index + i);
    put((plane + 1) & Axis::mask, out.next_index + i);
  }

 private:
  // By value: whose address is taken would be kept in memory.
  template <class From, class To>
  static DURER_INLINE void put(From from, To* to) {
    std::memcpy(to, &from, sizeof from);
  }
};

/// The lanes of four coordinates.
template <class V, class Axis>
DURER_INLINE void fill(NoiseLanes& out, const double* x) {
  constexpr int lanes = LaneInts<V>::lanes;
  for (int i = 0; i < 4; i += lanes) {
    V some;
    std::memcpy(&some, x + i, sizeof some);
    LaneWeights<V, Axis>(some).store(out, i);
  }
}

}  // namespace durer::functions::simd

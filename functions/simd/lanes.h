// One vector register of doubles in the vocabulary of number.h. Everything here becomes part of its
// caller, and so is compiled for the caller's instruction set. Each lane gets the bits that `double`
// would get.
#pragma once

#include <cstdint>
#include <cstring>

#include "functions/simd/quad.h"

namespace durer::functions::simd {

using Double8 = double __attribute__((vector_size(64)));

#if defined(__x86_64__) && !defined(__clang__)
#define DURER_BUILTIN_LANES 1  // GCC takes a detour for these in plain form
#else
#define DURER_BUILTIN_LANES 0
#endif

/// Outcome of a comparison per lane: all bits set or none.
template <class V>
struct LaneMask {
  decltype(V{} < V{}) m;

  static DURER_INLINE LaneMask less(V a, V b) { return {a < b}; }
  static DURER_INLINE LaneMask less_equal(V a, V b) { return {a <= b}; }
  static DURER_INLINE LaneMask equal(V a, V b) { return {a == b}; }
  [[nodiscard]] DURER_INLINE LaneMask inverse() const { return {~m}; }
  [[nodiscard]] DURER_INLINE LaneMask operator&(LaneMask o) const { return {m & o.m}; }
  [[nodiscard]] DURER_INLINE LaneMask operator|(LaneMask o) const { return {m | o.m}; }
  [[nodiscard]] DURER_INLINE V choose(V a, V b) const { return m ? a : b; }
  [[nodiscard]] DURER_INLINE bool all() const {
#if DURER_BUILTIN_LANES
    if constexpr (sizeof(V) == 32) return __builtin_ia32_movmskpd256(Double4(m)) == 15;
#endif
    std::int64_t lanes[sizeof m / sizeof(std::int64_t)];
    std::memcpy(lanes, &m, sizeof m);
    std::int64_t every = -1;
    for (const std::int64_t lane : lanes) every &= lane;
    return every != 0;
  }
};
#if DURER_BUILTIN_LANES
/// With 512 bits: a bit per lane.
template <>
struct LaneMask<Double8> {
  std::uint8_t m;

  template <int relation>
  static DURER_INLINE LaneMask compare(Double8 a, Double8 b) {
    constexpr int current_rounding = 4;
    return {static_cast<std::uint8_t>(
        __builtin_ia32_cmppd512_mask(a, b, relation, static_cast<char>(-1), current_rounding))};
  }
  static DURER_INLINE LaneMask less(Double8 a, Double8 b) { return compare<_CMP_LT_OQ>(a, b); }
  static DURER_INLINE LaneMask less_equal(Double8 a, Double8 b) {
    return compare<_CMP_LE_OQ>(a, b);
  }
  static DURER_INLINE LaneMask equal(Double8 a, Double8 b) { return compare<_CMP_EQ_OQ>(a, b); }
  [[nodiscard]] DURER_INLINE LaneMask inverse() const { return {static_cast<std::uint8_t>(~m)}; }
  [[nodiscard]] DURER_INLINE LaneMask operator&(LaneMask o) const {
    return {static_cast<std::uint8_t>(m & o.m)};
  }
  [[nodiscard]] DURER_INLINE LaneMask operator|(LaneMask o) const {
    return {static_cast<std::uint8_t>(m | o.m)};
  }
  [[nodiscard]] DURER_INLINE Double8 choose(Double8 a, Double8 b) const {
    return __builtin_ia32_blendmpd_512_mask(b, a, static_cast<char>(m));
  }
  [[nodiscard]] DURER_INLINE bool all() const { return m == 0xff; }
};
#endif

/// The doubles of a register of type V. It lacks what only the C library can do.
template <class V>
struct Lanes {
  using Bits = decltype(V{} < V{});
  static constexpr int count = sizeof(V) / sizeof(double);
  V v;

  Lanes() = default;
  DURER_INLINE explicit Lanes(V all) : v(all) {}
  DURER_INLINE explicit Lanes(double one) : v(V{} + one) {}

  static DURER_INLINE Lanes load(const double* from) {
    Lanes r;
    std::memcpy(&r.v, from, sizeof r.v);
    return r;
  }
  DURER_INLINE void store(double* to) const { std::memcpy(to, &v, sizeof v); }
  /// The bits, as integers.
  [[nodiscard]] DURER_INLINE Bits bits() const { return Bits(v); }
  static DURER_INLINE Lanes of_bits(Bits b) { return Lanes(V(b)); }
};

// clang-format off
template <class V> [[nodiscard]] DURER_INLINE Lanes<V> operator-(Lanes<V> a) { return Lanes<V>(-a.v); }
template <class V> [[nodiscard]] DURER_INLINE Lanes<V> operator+(Lanes<V> a, Lanes<V> b) { return Lanes<V>(a.v + b.v); }
template <class V> [[nodiscard]] DURER_INLINE Lanes<V> operator-(Lanes<V> a, Lanes<V> b) { return Lanes<V>(a.v - b.v); }
template <class V> [[nodiscard]] DURER_INLINE Lanes<V> operator*(Lanes<V> a, Lanes<V> b) { return Lanes<V>(a.v * b.v); }
template <class V> [[nodiscard]] DURER_INLINE Lanes<V> operator/(Lanes<V> a, Lanes<V> b) { return Lanes<V>(a.v / b.v); }

template <class V> [[nodiscard]] DURER_INLINE LaneMask<V> lt(Lanes<V> a, Lanes<V> b) { return LaneMask<V>::less(a.v, b.v); }
template <class V> [[nodiscard]] DURER_INLINE LaneMask<V> le(Lanes<V> a, Lanes<V> b) { return LaneMask<V>::less_equal(a.v, b.v); }
template <class V> [[nodiscard]] DURER_INLINE LaneMask<V> eq(Lanes<V> a, Lanes<V> b) { return LaneMask<V>::equal(a.v, b.v); }
template <class V> [[nodiscard]] DURER_INLINE LaneMask<V> operator!(LaneMask<V> a) { return a.inverse(); }
template <class V> [[nodiscard]] DURER_INLINE LaneMask<V> both(LaneMask<V> a, LaneMask<V> b) { return a & b; }
template <class V> [[nodiscard]] DURER_INLINE LaneMask<V> either(LaneMask<V> a, LaneMask<V> b) { return a | b; }
template <class V> [[nodiscard]] DURER_INLINE Lanes<V> where(LaneMask<V> m, Lanes<V> a, Lanes<V> b) { return Lanes<V>(m.choose(a.v, b.v)); }
// Not from number.h: that one would be compiled for the baseline.
template <class T, class V> [[nodiscard]] DURER_INLINE T truth(LaneMask<V> m) { return where(m, T(1), T(0)); }

template <class V> [[nodiscard]] DURER_INLINE Lanes<V> sqr(Lanes<V> a) { return a * a; }
template <class V> [[nodiscard]] DURER_INLINE Lanes<V> min(Lanes<V> a, Lanes<V> b) { return where(le(a, b), a, b); }
template <class V> [[nodiscard]] DURER_INLINE Lanes<V> max(Lanes<V> a, Lanes<V> b) { return where(lt(a, b), b, a); }
template <class V> [[nodiscard]] DURER_INLINE Lanes<V> abs(Lanes<V> a) { return Lanes<V>::of_bits(a.bits() & INT64_MAX); }
// clang-format on

/// As std::floor, also for zeros, infinities and what is not a number.
template <class V>
[[nodiscard]] DURER_INLINE Lanes<V> floor(Lanes<V> a) {
  const Lanes<V> first_whole(0x1p52);  // from here on all doubles are whole
  const auto sign = a.bits() & INT64_MIN;
  const auto rounder = Lanes<V>::of_bits(sign | first_whole.bits());
  const Lanes<V> near = (a + rounder) - rounder;
  const Lanes<V> down = near - where(lt(a, near), Lanes<V>(1), Lanes<V>(0));
  return where(lt(abs(a), first_whole), Lanes<V>::of_bits(down.bits() | sign), a);
}
template <class V>
[[nodiscard]] DURER_INLINE Lanes<V> ceil(Lanes<V> a) {
  return -floor(-a);
}

#ifdef __SSE2__
/// `f` of every two lanes.
template <class V, class F>
[[nodiscard]] DURER_INLINE Lanes<V> by_pair(Lanes<V> a, F f) {
  __m128d pair[sizeof(V) / sizeof(__m128d)];
  std::memcpy(pair, &a.v, sizeof a.v);
  for (__m128d& p : pair) p = f(p);
  std::memcpy(&a.v, pair, sizeof a.v);
  return a;
}
template <class V>
[[nodiscard]] DURER_INLINE Lanes<V> sqrt(Lanes<V> a) {
#if DURER_BUILTIN_LANES
  if constexpr (sizeof(V) == 64) return Lanes<V>(__builtin_ia32_sqrtpd512_mask(a.v, V{}, -1, 4));
  if constexpr (sizeof(V) == 32) return Lanes<V>(__builtin_ia32_sqrtpd256(a.v));
#endif
  return by_pair(a, [](__m128d p) DURER_LAMBDA_INLINE { return _mm_sqrt_pd(p); });
}
/// As to_int32().
template <class V>
[[nodiscard]] DURER_INLINE Lanes<V> truncated32(Lanes<V> a) {
#if DURER_BUILTIN_LANES
  if constexpr (sizeof(V) == 64) {
    using Ints = std::int32_t __attribute__((vector_size(32)));
    const Ints whole = Ints(__builtin_ia32_cvttpd2dq512_mask(a.v, Ints{}, -1, 4));
    return Lanes<V>(__builtin_ia32_cvtdq2pd512_mask(whole, V{}, -1));
  }
  if constexpr (sizeof(V) == 32) {
    return Lanes<V>(__builtin_ia32_cvtdq2pd256(__builtin_ia32_cvttpd2dq256(a.v)));
  }
#endif
  return by_pair(
      a, [](__m128d p) DURER_LAMBDA_INLINE { return _mm_cvtepi32_pd(_mm_cvttpd_epi32(p)); });
}
#endif

}  // namespace durer::functions::simd

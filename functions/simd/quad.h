// Four doubles that one instruction, or a pair of them, treats alike.
#pragma once

#include <cstring>

#include "functions/simd/inline.h"

#ifdef __x86_64__
#include <immintrin.h>  // declares the built-in functions
#endif

namespace durer::functions::simd {

using Double2 = double __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));

/// `a < b ? a : b` and `a < b ? b : a`, lane by lane, as one instruction each. GCC does not see it
/// in the plain form, and its intrinsics would not fit into code for several instruction sets.
template <class T>
[[nodiscard]] DURER_INLINE T smaller(T a, T b) {
#if defined(__x86_64__) && !defined(__clang__)
  if constexpr (sizeof(T) == 32) return __builtin_ia32_minpd256(a, b);
  if constexpr (sizeof(T) == 16) return __builtin_ia32_minpd(a, b);
#endif
  return a < b ? a : b;
}
template <class T>
[[nodiscard]] DURER_INLINE T larger(T a, T b) {
#if defined(__x86_64__) && !defined(__clang__)
  if constexpr (sizeof(T) == 32) return __builtin_ia32_maxpd256(b, a);
  if constexpr (sizeof(T) == 16) return __builtin_ia32_maxpd(b, a);
#endif
  return a < b ? b : a;
}

/// One 256-bit register; only for code compiled for AVX.
struct WideQuad {
  using Register = Double4;
  Double4 v;

  static DURER_INLINE WideQuad of(double a, double b, double c, double d) {
    return {Double4{a, b, c, d}};
  }
  static DURER_INLINE WideQuad load(const double* p) {
    WideQuad r;
    std::memcpy(&r.v, p, sizeof r.v);
    return r;
  }
  /// Four times the number at `p`.
  static DURER_INLINE WideQuad all(const double* p) {
#if defined(__x86_64__) && !defined(__clang__)
    return {__builtin_ia32_vbroadcastsd256(p)};  // GCC would load it into a half, and shuffle
#endif
    return {Double4{*p, *p, *p, *p}};
  }
  DURER_INLINE WideQuad operator*(WideQuad o) const { return {v * o.v}; }
  DURER_INLINE WideQuad operator+(WideQuad o) const { return {v + o.v}; }
  DURER_INLINE WideQuad operator-(WideQuad o) const { return {v - o.v}; }
  DURER_INLINE WideQuad abs() const { return {v < 0 ? -v : v}; }
  template <int lane>
  DURER_INLINE double at() const {
    return v[lane];
  }
  DURER_INLINE double sum() const { return (v[0] + v[1]) + (v[2] + v[3]); }
  /// Four times `a`, but `b` in one lane.
  template <int lane>
  static DURER_INLINE WideQuad mixed(const double& a, const double& b) {
#if defined(__x86_64__) && !defined(__clang__)
    // Two loads and a choice; GCC would shuffle, for which there is one port.
    return {__builtin_ia32_blendpd256(__builtin_ia32_vbroadcastsd256(&a),
                                      __builtin_ia32_vbroadcastsd256(&b), 1 << lane)};
#endif
    const Double4 all{a, a, a, a};
    const Double4 other{b, b, b, b};
    return {__builtin_shufflevector(all, other, lane == 0 ? 4 : 0, lane == 1 ? 5 : 1,
                                    lane == 2 ? 6 : 2, lane == 3 ? 7 : 3)};
  }
  /// The sum of each.
  static DURER_INLINE WideQuad sums(WideQuad a, WideQuad b, WideQuad c, WideQuad d) {
    const Double4 ab = __builtin_shufflevector(a.v, b.v, 0, 4, 2, 6) +
                       __builtin_shufflevector(a.v, b.v, 1, 5, 3, 7);
    const Double4 cd = __builtin_shufflevector(c.v, d.v, 0, 4, 2, 6) +
                       __builtin_shufflevector(c.v, d.v, 1, 5, 3, 7);
    return {__builtin_shufflevector(ab, cd, 0, 1, 4, 5) +
            __builtin_shufflevector(ab, cd, 2, 3, 6, 7)};
  }
  DURER_INLINE void store(double* p) const { std::memcpy(p, &v, sizeof v); }
  DURER_INLINE WideQuad clamped01() const {
    return {smaller(Double4{} + 1.0, larger(v, Double4{}))};
  }
};

/// Two 128-bit registers: what every x86-64 and ARM64 processor has. Same results, bit for bit.
struct PairQuad {
  using Register = Double2;
  Double2 lo, hi;

  static DURER_INLINE PairQuad of(double a, double b, double c, double d) {
    return {Double2{a, b}, Double2{c, d}};
  }
  static DURER_INLINE PairQuad load(const double* p) {
    PairQuad r;
    std::memcpy(&r.lo, p, sizeof r.lo);
    std::memcpy(&r.hi, p + 2, sizeof r.hi);
    return r;
  }
  static DURER_INLINE PairQuad all(const double* p) {
    const Double2 two{*p, *p};
    return {two, two};
  }
  DURER_INLINE PairQuad operator*(PairQuad o) const { return {lo * o.lo, hi * o.hi}; }
  DURER_INLINE PairQuad operator+(PairQuad o) const { return {lo + o.lo, hi + o.hi}; }
  DURER_INLINE PairQuad operator-(PairQuad o) const { return {lo - o.lo, hi - o.hi}; }
  DURER_INLINE PairQuad abs() const { return {lo < 0 ? -lo : lo, hi < 0 ? -hi : hi}; }
  template <int lane>
  DURER_INLINE double at() const {
    return lane < 2 ? lo[lane & 1] : hi[lane & 1];
  }
  DURER_INLINE double sum() const { return (lo[0] + lo[1]) + (hi[0] + hi[1]); }
  template <int lane>
  static DURER_INLINE PairQuad mixed(const double& a, const double& b) {
    return {Double2{lane == 0 ? b : a, lane == 1 ? b : a},
            Double2{lane == 2 ? b : a, lane == 3 ? b : a}};
  }
  static DURER_INLINE PairQuad sums(PairQuad a, PairQuad b, PairQuad c, PairQuad d) {
    return {pair_of_sums(a.lo, b.lo) + pair_of_sums(a.hi, b.hi),
            pair_of_sums(c.lo, d.lo) + pair_of_sums(c.hi, d.hi)};
  }
  DURER_INLINE void store(double* p) const {
    std::memcpy(p, &lo, sizeof lo);
    std::memcpy(p + 2, &hi, sizeof hi);
  }
  DURER_INLINE PairQuad clamped01() const { return {clamped01(lo), clamped01(hi)}; }

 private:
  static DURER_INLINE Double2 pair_of_sums(Double2 a, Double2 b) {
    return __builtin_shufflevector(a, b, 0, 2) + __builtin_shufflevector(a, b, 1, 3);
  }
  static DURER_INLINE Double2 clamped01(Double2 v) {
    return smaller(Double2{} + 1.0, larger(v, Double2{}));
  }
};

}  // namespace durer::functions::simd

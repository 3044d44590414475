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
  Double4 v;

  static DURER_INLINE WideQuad of(double a, double b, double c, double d) {
    return {Double4{a, b, c, d}};
  }
  static DURER_INLINE WideQuad load(const double* p) {
    WideQuad r;
    std::memcpy(&r.v, p, sizeof r.v);
    return r;
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
};

/// Two 128-bit registers: what every x86-64 and ARM64 processor has. Same results, bit for bit.
struct PairQuad {
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
  DURER_INLINE PairQuad operator*(PairQuad o) const { return {lo * o.lo, hi * o.hi}; }
  DURER_INLINE PairQuad operator+(PairQuad o) const { return {lo + o.lo, hi + o.hi}; }
  DURER_INLINE PairQuad operator-(PairQuad o) const { return {lo - o.lo, hi - o.hi}; }
  DURER_INLINE PairQuad abs() const { return {lo < 0 ? -lo : lo, hi < 0 ? -hi : hi}; }
  template <int lane>
  DURER_INLINE double at() const {
    return lane < 2 ? lo[lane & 1] : hi[lane & 1];
  }
  DURER_INLINE double sum() const { return (lo[0] + lo[1]) + (hi[0] + hi[1]); }
};

}  // namespace durer::functions::simd

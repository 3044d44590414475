// Several numbers at a time. Everything here becomes part of its caller, and so is compiled for the
// caller's instruction set.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "functions/simd/inline.h"
#include "functions/simd/processor.h"

// Functions are compiled for processors with 256-bit vectors and for all others; the results are
// equal. DURER_WIDE marks the former, and has_wide_vectors() tells whether they may be called.
#if defined(__x86_64__)
#define DURER_HAS_WIDE 1
#define DURER_WIDE DURER_AVX2
#else
#define DURER_HAS_WIDE 0
#define DURER_WIDE
#endif

namespace durer::tracer {

[[nodiscard]] inline bool has_wide_vectors() {
#if DURER_HAS_WIDE
  static const bool has = simd::has_avx2();
  return has;
#else
  return false;
#endif
}

namespace wide {

using Float8 = float __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));
using Double4 = double __attribute__((vector_size(32)));
using Long4 = std::int64_t __attribute__((vector_size(32)));

DURER_INLINE Float8 load8(const float* p) {
  Float8 r;
  std::memcpy(&r, p, sizeof r);
  return r;
}
DURER_INLINE Double4 load4(const std::array<double, 4>& a) {
  Double4 r;
  std::memcpy(&r, a.data(), sizeof r);
  return r;
}
DURER_INLINE std::array<double, 4> numbers(Double4 v) {
  std::array<double, 4> r;
  std::memcpy(r.data(), &v, sizeof v);
  return r;
}
DURER_INLINE Float8 greater_of(Float8 a, Float8 b) { return a > b ? a : b; }
DURER_INLINE Float8 less_of(Float8 a, Float8 b) { return a < b ? a : b; }
DURER_INLINE Double4 greater_of(Double4 a, Double4 b) { return a > b ? a : b; }
DURER_INLINE Double4 less_of(Double4 a, Double4 b) { return a < b ? a : b; }

DURER_INLINE Double4 root_of(Double4 v) {
#ifdef __SSE2__
  __m128d half[2];
  std::memcpy(half, &v, sizeof v);
  half[0] = _mm_sqrt_pd(half[0]);
  half[1] = _mm_sqrt_pd(half[1]);
  std::memcpy(&v, half, sizeof v);
  return v;
#else
  for (int i = 0; i < 4; ++i) v[i] = std::sqrt(v[i]);
  return v;
#endif
}

DURER_INLINE Float8 root_of(Float8 v) {
#ifdef __SSE2__
  __m128 half[2];
  std::memcpy(half, &v, sizeof v);
  half[0] = _mm_sqrt_ps(half[0]);
  half[1] = _mm_sqrt_ps(half[1]);
  std::memcpy(&v, half, sizeof v);
  return v;
#else
  for (int i = 0; i < 8; ++i) v[i] = std::sqrt(v[i]);
  return v;
#endif
}

/// A bit for every lane that is set.
DURER_INLINE unsigned bits_of_8(Int8 mask) {
#ifdef __SSE2__
  __m128 half[2];
  std::memcpy(half, &mask, sizeof mask);
  return static_cast<unsigned>(_mm_movemask_ps(half[0]) | (_mm_movemask_ps(half[1]) << 4));
#else
  unsigned bits = 0;
  for (unsigned i = 0; i < 8; ++i) bits |= (mask[i] != 0 ? 1U : 0U) << i;
  return bits;
#endif
}
DURER_INLINE unsigned bits_of_4(Long4 mask) {
#ifdef __SSE2__
  __m128d half[2];
  std::memcpy(half, &mask, sizeof mask);
  return static_cast<unsigned>(_mm_movemask_pd(half[0]) | (_mm_movemask_pd(half[1]) << 2));
#else
  unsigned bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= (mask[i] != 0 ? 1U : 0U) << i;
  return bits;
#endif
}

/// Calls f(lane) for every bit that is set, the lowest first.
template <typename F>
DURER_INLINE void each_bit(unsigned bits, F&& f) {
  for (; bits != 0; bits &= bits - 1) f(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace wide
}  // namespace durer::tracer

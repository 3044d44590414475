#pragma once

// A function or lambda that becomes part of its caller, and so is compiled for the caller's
// instruction set.
#define DURER_INLINE inline __attribute__((always_inline))
#define DURER_LAMBDA_INLINE __attribute__((always_inline))

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <cmath>
#include <cstdint>

namespace durer::functions::simd {

/// Conversion to a 32-bit integer, cutting off the fraction; what does not fit gives -2^31.
[[nodiscard]] DURER_INLINE std::int32_t to_int32(double v) {
#ifdef __SSE2__
  return _mm_cvttsd_si32(_mm_set_sd(v));  // defined for every input, and without a branch
#else
  return v > -2147483649.0 && v < 2147483648.0 ? static_cast<std::int32_t>(v) : INT32_MIN;
#endif
}

/// `c` below zero (and for -0), else 0; without a branch, for half of all coordinates are negative.
[[nodiscard]] DURER_INLINE double if_negative(double v, double c) {
  return c / 2 - std::copysign(c / 2, v);
}

}  // namespace durer::functions::simd

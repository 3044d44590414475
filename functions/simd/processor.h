// Which vectors this processor has. Functions that use them carry the attribute, and are called
// only where the question is answered with yes.
#pragma once

#if defined(__x86_64__)
#define DURER_AVX2 __attribute__((target("avx2")))
#define DURER_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw")))

namespace durer::simd {

/// Of 256 bits, for functions marked DURER_AVX2.
[[nodiscard]] inline bool has_avx2() { return __builtin_cpu_supports("avx2") != 0; }
/// Of 512 bits, for functions marked DURER_AVX512.
[[nodiscard]] inline bool has_avx512() {
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
         __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0;
}

}  // namespace durer::simd
#endif

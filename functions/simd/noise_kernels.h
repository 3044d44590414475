// The inner loops of noise, once per instruction set. Every set computes the same bits.
#pragma once

#include <cstddef>

#include "base/vec.h"
#include "functions/noise.h"

namespace durer::functions::simd {

struct NoiseKernels {
  double (*noise)(double x, double y, double z, int generator);
  void (*noise_many)(const dvec3* points, std::size_t n, int generator, double* out);
  dvec3 (*vnoise)(const dvec3& p);
  void (*vnoise_many)(const dvec3* points, std::size_t n, dvec3* out);
  double (*turbulence)(const dvec3& p, const Octaves& octaves, int generator);
  dvec3 (*vturbulence)(const dvec3& p, const Octaves& octaves);
  void (*vturbulence_many)(const dvec3* points, std::size_t n, const Octaves& octaves, dvec3* out);
  void (*noise_octaves)(const dvec3& p, double lambda, int n, int generator, double* out);
  dvec3 (*vfolded)(const dvec3& p, int n);
  void (*turbulence_many)(const dvec3* points, std::size_t n, const Octaves& octaves, int generator,
                          double* out);
  void (*vfolded_many)(const dvec3* points, std::size_t n, int octaves, dvec3* out);
  void (*four_octaves)(const dvec3* points, int count, double lambda, int octaves, int generator,
                       double* out);
};

/// What runs on every processor of the architecture.
[[nodiscard]] const NoiseKernels& baseline_kernels();
/// The AVX2 form, or null where the processor has none.
[[nodiscard]] const NoiseKernels* avx2_kernels();

/// The best of them for this processor. Not behind a function: a call would cost a tenth of noise.
extern constinit const NoiseKernels* best_kernels;
[[nodiscard]] inline const NoiseKernels& kernels() { return *best_kernels; }

}  // namespace durer::functions::simd

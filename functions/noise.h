// Noise, turbulence and the other random sources of patterns and functions (textures §2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/dual.h"
#include "base/floor.h"
#include "base/interval.h"
#include "base/trend.h"
#include "base/vec.h"

namespace durer::functions {

/// Which scalar noise: 1 original, 2 range corrected, 3 gradient lattice.
/// 0 acts as 1 here; "use the scene's" must be resolved before.
using NoiseGenerator = int;

/// Scalar noise at `p`, in [0, 1]. Period 4096 (generators 1, 2) or 2048 (3) along each axis.
/// Source: textures §2.4, §2.5; agrees with the oracle to 5e-13.
[[nodiscard]] double noise(double x, double y, double z, NoiseGenerator generator);
[[nodiscard]] inline double noise(const dvec3& p, NoiseGenerator generator) {
  return noise(p.x, p.y, p.z, generator);
}
/// out[i] = noise(points[i]), to the last bit. `out` is as long as `points`.
void noise(std::span<const dvec3> points, NoiseGenerator generator, std::span<double> out);
/// Encloses noise over a box; tight while the box spans a few cells, [0, 1] for large ones.
[[nodiscard]] Interval noise(Interval x, Interval y, Interval z, NoiseGenerator generator);
/// Noise and its derivatives; where the value is clamped the gradient is 0.
[[nodiscard]] Dual noise(const Dual& x, const Dual& y, const Dual& z, NoiseGenerator generator);

/// Both of them over a box.
[[nodiscard]] Trend noise(const Trend& x, const Trend& y, const Trend& z, NoiseGenerator generator);

/// Bounds of the scalar noise anywhere: its steepest slope, and how fast a slope along a direction
/// can change along it.
struct NoiseSteepness {
  double slope;
  double bend;
};
[[nodiscard]] NoiseSteepness steepest_noise(NoiseGenerator generator);
/// True if the box is too large for better bounds of the noise than those that hold everywhere.
[[nodiscard]] bool is_any_noise(const Trend& x, const Trend& y, const Trend& z,
                                NoiseGenerator generator);

/// Vector noise, about [-1, 1] per component; the same for all generators (textures §2.4).
[[nodiscard]] dvec3 vnoise(dvec3 p);
void vnoise(std::span<const dvec3> points, std::span<dvec3> out);

/// How octaves add up: octave i has frequency lambda^i and weight omega^i.
struct Octaves {
  int count = 6;  // at least 1; patterns clamp to 1..10
  double omega = 0.5;
  double lambda = 2.0;
};
/// Scalar turbulence (marble, agate, spirals, fog, iridescence; textures §2.7).
[[nodiscard]] double turbulence(dvec3 p, const Octaves& octaves, NoiseGenerator generator);
/// out[i] = turbulence(points[i]), to the last bit. `out` is as long as `points`.
void turbulence(std::span<const dvec3> points, const Octaves& octaves, NoiseGenerator generator,
                std::span<double> out);
/// Vector turbulence (textures §2.7), in pattern units.
[[nodiscard]] dvec3 vturbulence(dvec3 p, const Octaves& octaves);
/// out[i] = vturbulence(points[i]), to the last bit. `out` is as long as `points`, or the same.
void vturbulence(std::span<const dvec3> points, const Octaves& octaves, std::span<dvec3> out);

/// out[i] = noise(lambda^i * p) for i < `count`. `out` has room for the next multiple of four.
void noise_octaves(dvec3 p, double lambda, int count, NoiseGenerator generator, double* out);
/// The same for up to four points: out[4 * i + k] is that of point k.
void noise_octaves(std::span<const dvec3> points, double lambda, int count,
                   NoiseGenerator generator, double* out);
/// Sum of |vnoise(2^i * p)| / 2^i for i < `count`, component by component.
[[nodiscard]] dvec3 folded_vnoise(dvec3 p, int count);
/// out[i] = folded_vnoise(points[i]), to the last bit. `out` is as long as `points`.
void folded_vnoise(std::span<const dvec3> points, int count, std::span<dvec3> out);

/// Integer hashes into 0..4095; arguments in two's complement (textures §2.2).
[[nodiscard]] int hash2(int a, int b);
[[nodiscard]] int hash3(int a, int b, int c);

/// The uniform table of cells, crackle, facets and black holes, in [0, 1); index modulo 32768.
[[nodiscard]] double uniform_table(unsigned index);

/// sin(2πv), and a triangle wave of period 1 in [0, 1] (textures §2.8).
[[nodiscard]] double cycloidal(double v);
[[nodiscard]] inline double triangle(double v) {
  const double o = v >= 0 ? v - floored(v) : v + 1 + floored(-v);
  return o < 0.5 ? 2 * o : 2 * (1 - o);
}

/// One centre of ripples and waves, on the unit sphere, and its frequency (textures §2.9).
struct WaveSource {
  dvec3 centre;
  double frequency;
};
/// The first `count` sources; a smaller count is a prefix. `count` < 1 acts as 1.
[[nodiscard]] std::vector<WaveSource> wave_sources(int count);

}  // namespace durer::functions

#include "functions/noise.h"

#include <glm/geometric.hpp>

#include <cassert>
#include <memory>
#include <random>

#include "base/floor.h"
#include "functions/noise_tables.h"
#include "functions/simd/noise_kernels.h"

namespace durer::functions {
namespace {

constexpr unsigned lattice_mask = lattice_size - 1;
constexpr unsigned uniform_size = 32768;

/// The numbers themselves are 32-bit integers; /2³² is exact and halves the table.
std::vector<std::uint32_t> make_uniform_table() {
  std::mt19937 generator;  // the standard seed, 5489
  std::vector<std::uint32_t> table(uniform_size);
  for (std::uint32_t& v : table) v = static_cast<std::uint32_t>(generator());
  return table;
}

double fraction(double v) { return v - floored(v); }

}  // namespace

double noise(double x, double y, double z, NoiseGenerator generator) {
  return simd::kernels().noise(x, y, z, generator);
}

void noise(std::span<const dvec3> points, NoiseGenerator generator, std::span<double> out) {
  assert(points.size() == out.size());
  simd::kernels().noise_many(points.data(), points.size(), generator, out.data());
}

dvec3 vnoise(dvec3 p) { return simd::kernels().vnoise(p); }

void vnoise(std::span<const dvec3> points, std::span<dvec3> out) {
  assert(points.size() == out.size());
  simd::kernels().vnoise_many(points.data(), points.size(), out.data());
}

double turbulence(dvec3 p, const Octaves& octaves, NoiseGenerator generator) {
  return simd::kernels().turbulence(p, octaves, generator);
}
void turbulence(std::span<const dvec3> points, const Octaves& octaves, NoiseGenerator generator,
                std::span<double> out) {
  assert(points.size() == out.size());
  simd::kernels().turbulence_many(points.data(), points.size(), octaves, generator, out.data());
}
dvec3 vturbulence(dvec3 p, const Octaves& octaves) {
  return simd::kernels().vturbulence(p, octaves);
}
void vturbulence(std::span<const dvec3> points, const Octaves& octaves, std::span<dvec3> out) {
  assert(points.size() == out.size());
  simd::kernels().vturbulence_many(points.data(), points.size(), octaves, out.data());
}

void noise_octaves(dvec3 p, double lambda, int count, NoiseGenerator generator, double* out) {
  simd::kernels().noise_octaves(p, lambda, count, generator, out);
}
void noise_octaves(std::span<const dvec3> points, double lambda, int count,
                   NoiseGenerator generator, double* out) {
  assert(points.size() <= 4);
  simd::kernels().four_octaves(points.data(), static_cast<int>(points.size()), lambda, count,
                               generator, out);
}
dvec3 folded_vnoise(dvec3 p, int count) { return simd::kernels().vfolded(p, count); }
void folded_vnoise(std::span<const dvec3> points, int count, std::span<dvec3> out) {
  assert(points.size() == out.size());
  simd::kernels().vfolded_many(points.data(), points.size(), count, out.data());
}

int hash2(int a, int b) {
  return permutation[permutation[static_cast<unsigned>(a) & lattice_mask] ^
                     (static_cast<unsigned>(b) & lattice_mask)];
}
int hash3(int a, int b, int c) {
  return permutation[static_cast<unsigned>(hash2(a, b)) ^
                     (static_cast<unsigned>(c) & lattice_mask)];
}

double uniform_table(unsigned index) {
  static const std::vector<std::uint32_t> table = make_uniform_table();
  return table[index % uniform_size] * 0x1p-32;
}

double cycloidal(double v) {
  constexpr double turn = 2 * std::numbers::pi;
  return v >= 0 ? std::sin(turn * fraction(v)) : -std::sin(turn * fraction(-v));
}
std::vector<WaveSource> wave_sources(int count) {
  std::vector<WaveSource> sources;
  Lcg lcg{static_cast<std::uint32_t>(-560851967)};
  for (int i = 0; i < std::max(count, 1); ++i) {
    const dvec3 centre = glm::normalize(vnoise({static_cast<double>(i), 0, 0}));
    sources.push_back({centre, lcg.next15() * 0.000030518509476 + 0.01});
  }
  return sources;
}

}  // namespace durer::functions

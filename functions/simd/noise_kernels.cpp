#include "functions/simd/noise_kernels.h"

#include "functions/noise_cell.h"
#include "functions/simd/quad.h"


namespace durer::functions::simd {
namespace {

/// The weight of a corner is separable, also with the dot product of its gradient folded in: lane k
/// of the x factor carries (x - a) where k is the x gradient, and 1 elsewhere; likewise y and z.
template <class Quad>
struct Weights {
  Quad x0, x1, y0, y1, z0, z1;

  explicit DURER_INLINE Weights(const Cell& cell) {
    const auto [fx, sx, ux] = factors(cell.x);
    const auto [fy, sy, uy] = factors(cell.y);
    const auto [fz, sz, uz] = factors(cell.z);
    x0 = Quad::of(ux, ux * fx, ux, ux);
    x1 = Quad::of(sx, sx * (fx - 1), sx, sx);
    y0 = Quad::of(uy, uy, uy * fy, uy);
    y1 = Quad::of(sy, sy, sy * (fy - 1), sy);
    z0 = Quad::of(uz, uz, uz, uz * fz);
    z1 = Quad::of(sz, sz, sz, sz * (fz - 1));
  }
  /// Sum over the eight corners whose rows start `skip` numbers behind the rows of the cell.
  DURER_INLINE double sum(const Cell& cell, int skip = 0) const {
    const auto edge = [&](int corner) DURER_LAMBDA_INLINE {
      return Quad::load(cell.row[corner] + skip) * x0 + Quad::load(cell.row[corner + 1] + skip) * x1;
    };
    return ((edge(0) * y0 + edge(2) * y1) * z0 + (edge(4) * y0 + edge(6) * y1) * z1).sum();
  }

 private:
  struct Factors {
    double f, s, u;
  };
  static DURER_INLINE Factors factors(const CellAxis& a) { return {a.f, a.s, 1 - a.s}; }
};

DURER_INLINE double clamp01(double v) { return v < 0 ? 0 : v > 1 ? 1 : v; }

template <class Quad>
DURER_INLINE double table_noise(dvec3 p, NoiseScale scale) {
  const Cell cell = table_cell(p.x, p.y, p.z);
  return clamp01((Weights<Quad>(cell).sum(cell) + scale.offset) * scale.scale);
}
template <class Quad>
DURER_INLINE double gradient_noise(const GradientLattice& lattice, dvec3 p) {
  const Cell cell = gradient_cell(lattice, p.x, p.y, p.z);
  return clamp01(0.5 * (1.59 * Weights<Quad>(cell).sum(cell) + 0.985));
}
template <class Quad>
DURER_INLINE dvec3 vector_noise(dvec3 p) {
  const Cell cell = table_cell(p.x, p.y, p.z);
  const Weights<Quad> w(cell);
  return {w.sum(cell, 0), w.sum(cell, 16), w.sum(cell, 32)};
}

template <class Quad>
DURER_INLINE double noise_of(dvec3 p, int generator) {
  return generator == 3 ? gradient_noise<Quad>(gradient_lattice(), p)
                        : table_noise<Quad>(p, noise_scale(generator));
}
template <class Quad>
DURER_INLINE void noise_many_of(const dvec3* p, std::size_t n, int generator, double* out) {
  if (generator == 3) {
    const GradientLattice& lattice = gradient_lattice();
    for (std::size_t i = 0; i < n; ++i) out[i] = gradient_noise<Quad>(lattice, p[i]);
  } else {
    const NoiseScale scale = noise_scale(generator);
    for (std::size_t i = 0; i < n; ++i) out[i] = table_noise<Quad>(p[i], scale);
  }
}
template <class Quad>
DURER_INLINE void vnoise_many_of(const dvec3* p, std::size_t n, dvec3* out) {
  for (std::size_t i = 0; i < n; ++i) out[i] = vector_noise<Quad>(p[i]);
}

/// Only the first octave is clamped, and only by generators 2 and 3 (textures §2.7).
template <class Quad, class Noise>
DURER_INLINE double turbulence_sum(dvec3 p, const Octaves& o, int generator, Noise noise) {
  const double scale = generator >= 2 ? 2.0 : 1.0;
  const double shift = generator >= 2 ? 0.5 : 0.0;
  double value = clamp01(scale * noise(p) - shift);
  double frequency = o.lambda;
  double weight = o.omega;
  for (int i = 2; i <= o.count; ++i) {
    value += weight * (scale * noise(frequency * p) - shift);
    frequency *= o.lambda;
    weight *= o.omega;
  }
  return value;
}
template <class Quad>
DURER_INLINE double turbulence_of(dvec3 p, const Octaves& o, int generator) {
  if (generator == 3) {
    const GradientLattice& lattice = gradient_lattice();
    return turbulence_sum<Quad>(p, o, generator, [&](dvec3 q) DURER_LAMBDA_INLINE {
      return gradient_noise<Quad>(lattice, q);
    });
  }
  const NoiseScale scale = noise_scale(generator);
  return turbulence_sum<Quad>(p, o, generator, [&](dvec3 q) DURER_LAMBDA_INLINE {
    return table_noise<Quad>(q, scale);
  });
}
template <class Quad>
DURER_INLINE dvec3 vturbulence_of(dvec3 p, const Octaves& o) {
  dvec3 value = vector_noise<Quad>(p);
  double frequency = o.lambda;
  double weight = o.omega;
  for (int i = 2; i <= o.count; ++i) {
    value += weight * vector_noise<Quad>(frequency * p);
    frequency *= o.lambda;
    weight *= o.omega;
  }
  return value;
}

}  // namespace

// One set of entry points: `target` is the attribute of each, `Quad` its register form.
#define DURER_NOISE_KERNELS(name, Quad, target)                                                \
  namespace name {                                                                             \
  target double noise(double x, double y, double z, int g) {                                   \
    return noise_of<Quad>({x, y, z}, g);                                                       \
  }                                                                                            \
  target void noise_many(const dvec3* p, std::size_t n, int g, double* out) {                  \
    noise_many_of<Quad>(p, n, g, out);                                                         \
  }                                                                                            \
  target dvec3 vnoise(dvec3 p) { return vector_noise<Quad>(p); }                               \
  target void vnoise_many(const dvec3* p, std::size_t n, dvec3* out) {                         \
    vnoise_many_of<Quad>(p, n, out);                                                           \
  }                                                                                            \
  target double turbulence(dvec3 p, const Octaves& o, int g) {                                 \
    return turbulence_of<Quad>(p, o, g);                                                       \
  }                                                                                            \
  target dvec3 vturbulence(dvec3 p, const Octaves& o) { return vturbulence_of<Quad>(p, o); }   \
  constexpr NoiseKernels table{noise, noise_many, vnoise, vnoise_many, turbulence, vturbulence}; \
  }

namespace {
DURER_NOISE_KERNELS(baseline, PairQuad, )
#ifdef __x86_64__
DURER_NOISE_KERNELS(avx2, WideQuad, __attribute__((target("avx2"))))
#endif
}  // namespace

const NoiseKernels& baseline_kernels() { return baseline::table; }

const NoiseKernels* avx2_kernels() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") != 0) return &avx2::table;
#endif
  return nullptr;
}

namespace {

// Not a function-local static: its guard would cost a tenth of a noise call. Whoever asks before the
// second line has run gets the baseline, which gives the same bits.
constinit const NoiseKernels* best = &baseline::table;
[[maybe_unused]] const bool chosen = [] {
  if (avx2_kernels() != nullptr) best = avx2_kernels();
  return true;
}();

}  // namespace

const NoiseKernels& kernels() { return *best; }

}  // namespace durer::functions::simd

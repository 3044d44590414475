#include "functions/simd/noise_kernels.h"

#include <algorithm>

#include "functions/noise_cell.h"
#include "functions/simd/noise_lanes.h"

namespace durer::functions::simd {
namespace {

// The eight rows of a cell: number a + 2b + 4c for corner (a, b, c). Lanes i, j, k of `x`, `y` and
// `z` are the coordinates.
struct TableCorners {
  using Axis = TableAxis;
  const double* row[8];

  DURER_INLINE TableCorners(const NoiseLanes& x, int i, const NoiseLanes& y, int j,
                            const NoiseLanes& z, int k) {
    const std::uint32_t hx[2] = {permutation[x.index[i]], permutation[x.next_index[i]]};
    for (unsigned a = 0; a < 2; ++a) {
      const std::uint32_t hy[2] = {permutation[hx[a] ^ y.index[j]],
                                   permutation[hx[a] ^ y.next_index[j]]};
      for (unsigned b = 0; b < 2; ++b) {
        row[a + 2 * b] = row_at(row_offsets[hy[b] ^ z.index[k]]);
        row[a + 2 * b + 4] = row_at(row_offsets[hy[b] ^ z.next_index[k]]);
      }
    }
  }
};
struct GradientCorners {
  using Axis = GradientAxis;
  const double* row[8];

  DURER_INLINE GradientCorners(const NoiseLanes& x, int i, const NoiseLanes& y, int j,
                               const NoiseLanes& z, int k) {
    const GradientLattice& t = gradient_lattice();
    constexpr std::uint32_t mask = GradientAxis::mask;
    const std::uint32_t hx[2] = {t.p[x.index[i]], t.p[x.next_index[i]]};
    for (unsigned a = 0; a < 2; ++a) {
      const std::uint32_t hy[2] = {t.p[(hx[a] + y.index[j]) & mask],
                                   t.p[(hx[a] + y.next_index[j]) & mask]};
      for (unsigned b = 0; b < 2; ++b) {
        row[a + 2 * b] = t.gradients[(hy[b] + z.index[k]) & mask].c;
        row[a + 2 * b + 4] = t.gradients[(hy[b] + z.next_index[k]) & mask].c;
      }
    }
  }
};

/// The weight of a corner is separable, also with the dot product of its gradient folded in: lane 1
/// of the x factor is the slope's, and likewise lane 2 of y and lane 3 of z.
template <class Quad>
struct Weights {
  Quad x0, x1, y0, y1, z0, z1;

  explicit DURER_INLINE Weights(const Cell& cell)
      : x0(Quad::of(below(cell.x), below(cell.x) * cell.x.f, below(cell.x), below(cell.x))),
        x1(Quad::of(cell.x.s, cell.x.s * (cell.x.f - 1), cell.x.s, cell.x.s)),
        y0(Quad::of(below(cell.y), below(cell.y), below(cell.y) * cell.y.f, below(cell.y))),
        y1(Quad::of(cell.y.s, cell.y.s, cell.y.s * (cell.y.f - 1), cell.y.s)),
        z0(Quad::of(below(cell.z), below(cell.z), below(cell.z), below(cell.z) * cell.z.f)),
        z1(Quad::of(cell.z.s, cell.z.s, cell.z.s, cell.z.s * (cell.z.f - 1))) {}
  DURER_INLINE Weights(const NoiseLanes& x, int i, const NoiseLanes& y, int j, const NoiseLanes& z,
                       int k)
      : x0(Quad::template mixed<1>(x.below[i], x.below_slope[i])),
        x1(Quad::template mixed<1>(x.above[i], x.above_slope[i])),
        y0(Quad::template mixed<2>(y.below[j], y.below_slope[j])),
        y1(Quad::template mixed<2>(y.above[j], y.above_slope[j])),
        z0(Quad::template mixed<3>(z.below[k], z.below_slope[k])),
        z1(Quad::template mixed<3>(z.above[k], z.above_slope[k])) {}

  /// What value and gradients add over the eight corners; rows start `skip` numbers behind `row`.
  DURER_INLINE Quad parts(const double* const (&row)[8], int skip = 0) const {
    const auto edge = [&](int corner) DURER_LAMBDA_INLINE {
      return Quad::load(row[corner] + skip) * x0 + Quad::load(row[corner + 1] + skip) * x1;
    };
    return (edge(0) * y0 + edge(2) * y1) * z0 + (edge(4) * y0 + edge(6) * y1) * z1;
  }

 private:
  static DURER_INLINE double below(const CellAxis& a) { return 1 - a.s; }
};

// One noise generator over four points at a time. `Corners`: its lattice.
template <class Quad, class Corners>
struct Lattice {
  using Axis = typename Corners::Axis;
  using Register = typename Quad::Register;

  /// The interpolated sums of four points, of coordinates x, y and z; only `count` of them matter.
  static DURER_INLINE Quad four(const double* x, const double* y, const double* z, int count) {
    NoiseLanes lanes[3];
    fill<Register, Axis>(lanes[0], x);
    fill<Register, Axis>(lanes[1], y);
    fill<Register, Axis>(lanes[2], z);
    Quad parts[4];
    for (int i = 0; i < count; ++i) {
      const Corners corners(lanes[0], i, lanes[1], i, lanes[2], i);
      parts[i] = Weights<Quad>(lanes[0], i, lanes[1], i, lanes[2], i).parts(corners.row);
    }
    for (int i = count; i < 4; ++i) parts[i] = parts[0];
    return Quad::sums(parts[0], parts[1], parts[2], parts[3]);
  }
};

/// Vector noise of four points, by component.
template <class Quad>
struct VectorNoises {
  Quad x, y, z;

  /// Of coordinates `c`; only `count` of them matter.
  explicit DURER_INLINE VectorNoises(const double (&c)[3][4], int count) {
    NoiseLanes lanes[3];
    for (int axis = 0; axis < 3; ++axis) {
      fill<typename Quad::Register, TableAxis>(lanes[axis], c[axis]);
    }
    Quad parts[3][4];
    for (int i = 0; i < count; ++i) {
      const TableCorners corners(lanes[0], i, lanes[1], i, lanes[2], i);
      const Weights<Quad> weights(lanes[0], i, lanes[1], i, lanes[2], i);
      for (int k = 0; k < 3; ++k) parts[k][i] = weights.parts(corners.row, 16 * k);
    }
    for (int i = count; i < 4; ++i) {
      for (auto& part : parts) part[i] = part[0];
    }
    x = Quad::sums(parts[0][0], parts[0][1], parts[0][2], parts[0][3]);
    y = Quad::sums(parts[1][0], parts[1][1], parts[1][2], parts[1][3]);
    z = Quad::sums(parts[2][0], parts[2][1], parts[2][2], parts[2][3]);
  }
};

/// The three components of vector noise; the last lane is nothing.
template <class Quad>
DURER_INLINE Quad vector_noise(const Weights<Quad>& w, const double* const (&row)[8]) {
  const Quad a = w.parts(row, 0);
  const Quad b = w.parts(row, 16);
  const Quad c = w.parts(row, 32);
  return Quad::sums(a, b, c, c);
}
template <class Quad>
DURER_INLINE dvec3 to_vector(Quad q) {
  double c[4];
  q.store(c);
  return {c[0], c[1], c[2]};
}

DURER_INLINE double clamp01(double v) { return v < 0 ? 0 : v > 1 ? 1 : v; }

template <class Quad>
DURER_INLINE double noise_of(double x, double y, double z, int generator) {
  if (generator == 3) {
    const Cell cell = gradient_cell(gradient_lattice(), x, y, z);
    return clamp01(0.5 * (1.59 * Weights<Quad>(cell).parts(cell.row).sum() + 0.985));
  }
  const NoiseScale scale = noise_scale(generator);
  const Cell cell = table_cell(x, y, z);
  return clamp01((Weights<Quad>(cell).parts(cell.row).sum() + scale.offset) * scale.scale);
}

/// Noise at four points, of any generator.
template <class Quad>
DURER_INLINE Quad four_noises(const double* x, const double* y, const double* z, int generator,
                                int count) {
  const auto all = [](double v) DURER_LAMBDA_INLINE { return Quad::of(v, v, v, v); };
  if (generator == 3) {
    const Quad sums = Lattice<Quad, GradientCorners>::four(x, y, z, count);
    return (all(0.5) * (all(1.59) * sums + all(0.985))).clamped01();
  }
  const NoiseScale scale = noise_scale(generator);
  return ((Lattice<Quad, TableCorners>::four(x, y, z, count) + all(scale.offset)) * all(scale.scale))
      .clamped01();
}

template <class Quad>
DURER_INLINE void noise_many_of(const dvec3* p, std::size_t n, int generator, double* out) {
  for (std::size_t done = 0; done < n; done += 4) {
    const int count = n - done < 4 ? static_cast<int>(n - done) : 4;
    alignas(32) double c[3][4] = {};
    for (int i = 0; i < count; ++i) {
      for (int axis = 0; axis < 3; ++axis) c[axis][i] = p[done + i][axis];
    }
    alignas(32) double values[4];
    four_noises<Quad>(c[0], c[1], c[2], generator, count).store(values);
    for (int i = 0; i < count; ++i) out[done + i] = values[i];
  }
}

/// Four powers of lambda after another, from `next` on, which becomes the one after them.
template <class Quad>
DURER_INLINE Quad four_powers(double lambda, double& next) {
  const double a = next;
  const double b = a * lambda;
  const double c = b * lambda;
  const double d = c * lambda;
  next = d * lambda;
  return Quad::of(a, b, c, d);
}
/// Four copies of a coordinate, scaled.
template <class Quad>
DURER_INLINE void scaled(Quad scale, double x, double* out) {
  (scale * Quad::of(x, x, x, x)).store(out);
}

/// Noise of the next up to four octaves of `p`; `frequency` goes on to those behind.
template <class Quad>
DURER_INLINE Quad next_noises(const dvec3& p, double lambda, double& frequency, int generator,
                              int count) {
  const Quad scale = four_powers<Quad>(lambda, frequency);
  alignas(32) double c[3][4];
  for (int axis = 0; axis < 3; ++axis) scaled(scale, p[axis], c[axis]);
  return four_noises<Quad>(c[0], c[1], c[2], generator, count);
}
template <class Quad>
DURER_INLINE void noise_octaves_of(const dvec3& p, double lambda, int n, int generator, double* out) {
  double frequency = 1;
  for (int i = 0; i < n; i += 4) {
    next_noises<Quad>(p, lambda, frequency, generator, std::min(n - i, 4)).store(out + i);
  }
}

/// Only the first octave is clamped, and only by generators 2 and 3 (textures §2.7).
template <class Quad>
DURER_INLINE double turbulence_of(const dvec3& p, const Octaves& o, int generator) {
  const double scale = generator >= 2 ? 2.0 : 1.0;
  const double shift = generator >= 2 ? 0.5 : 0.0;
  double value = 0;
  double frequency = 1;
  double weight = 1;
  for (int i = 0; i < o.count; i += 4) {
    alignas(32) double n[4];
    const int count = std::min(o.count - i, 4);
    next_noises<Quad>(p, o.lambda, frequency, generator, count).store(n);
    for (int k = 0; k < count; ++k) {
      const double signal = scale * n[k] - shift;
      value += i + k == 0 ? clamp01(signal) : weight * signal;
      weight *= o.omega;
    }
  }
  return value;
}

template <class Quad>
DURER_INLINE dvec3 vnoise_of(const dvec3& p) {
  const Cell cell = table_cell(p.x, p.y, p.z);
  return to_vector(vector_noise(Weights<Quad>(cell), cell.row));
}
template <class Quad>
DURER_INLINE void vnoise_many_of(const dvec3* p, std::size_t n, dvec3* out) {
  for (std::size_t i = 0; i < n; ++i) out[i] = vnoise_of<Quad>(p[i]);
}

/// Calls visit(vector noise of an octave of `p`) for one after another.
template <class Quad, class Visit>
DURER_INLINE void for_vnoise_octaves(const dvec3& p, double lambda, int n, Visit visit) {
  double frequency = 1;
  for (int i = 0; i < n; i += 4) {
    const Quad scale = four_powers<Quad>(lambda, frequency);
    NoiseLanes lanes[3];
    for (int axis = 0; axis < 3; ++axis) {
      alignas(32) double c[4];
      scaled(scale, p[axis], c);
      fill<typename Quad::Register, TableAxis>(lanes[axis], c);
    }
    const int count = std::min(n - i, 4);
    for (int k = 0; k < count; ++k) {
      const TableCorners corners(lanes[0], k, lanes[1], k, lanes[2], k);
      visit(vector_noise(Weights<Quad>(lanes[0], k, lanes[1], k, lanes[2], k), corners.row));
    }
  }
}
template <class Quad>
DURER_INLINE dvec3 vturbulence_of(const dvec3& p, const Octaves& o) {
  Quad value = Quad::of(0, 0, 0, 0);
  double weight = 1;
  for_vnoise_octaves<Quad>(p, o.lambda, o.count, [&](Quad v) DURER_LAMBDA_INLINE {
    value = value + Quad::of(weight, weight, weight, weight) * v;
    weight *= o.omega;
  });
  return to_vector(value);
}
/// Up to four points, with a lane each: none is idle, whatever the number of octaves is.
template <class Quad>
DURER_INLINE void four_vturbulences(const dvec3* p, int count, const Octaves& o, dvec3* out) {
  alignas(32) double c[3][4] = {};
  for (int i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) c[axis][i] = p[i][axis];
  }
  const auto all = [](double v) DURER_LAMBDA_INLINE { return Quad::of(v, v, v, v); };
  const Quad place[3] = {Quad::load(c[0]), Quad::load(c[1]), Quad::load(c[2])};
  Quad sum[3] = {all(0), all(0), all(0)};
  double frequency = 1;
  double weight = 1;
  for (int octave = 0; octave < o.count; ++octave) {
    for (int axis = 0; axis < 3; ++axis) (all(frequency) * place[axis]).store(c[axis]);
    const VectorNoises<Quad> noises(c, count);
    sum[0] = sum[0] + all(weight) * noises.x;
    sum[1] = sum[1] + all(weight) * noises.y;
    sum[2] = sum[2] + all(weight) * noises.z;
    frequency *= o.lambda;
    weight *= o.omega;
  }
  for (int axis = 0; axis < 3; ++axis) sum[axis].store(c[axis]);
  for (int i = 0; i < count; ++i) out[i] = {c[0][i], c[1][i], c[2][i]};
}
template <class Quad>
DURER_INLINE void vturbulence_many_of(const dvec3* p, std::size_t n, const Octaves& o,
                                      dvec3* out) {
  std::size_t done = 0;
  for (; n - done >= 4; done += 4) four_vturbulences<Quad>(p + done, 4, o, out + done);
  if (n - done == 1) {
    out[done] = vturbulence_of<Quad>(p[done], o);
  } else if (n > done) {
    four_vturbulences<Quad>(p + done, static_cast<int>(n - done), o, out + done);
  }
}
/// Sum of the octaves' sizes, component by component, each half of the one before.
template <class Quad>
DURER_INLINE dvec3 vfolded_of(const dvec3& p, int n) {
  Quad value = Quad::of(0, 0, 0, 0);
  double weight = 1;
  for_vnoise_octaves<Quad>(p, 2, n, [&](Quad v) DURER_LAMBDA_INLINE {
    value = value + Quad::of(weight, weight, weight, weight) * v.abs();
    weight *= 0.5;
  });
  return to_vector(value);
}

}  // namespace

// One set of entry points: `target` is the attribute of each, `Quad` its register form.
#define DURER_NOISE_KERNELS(name, Quad, target)                                                  \
  namespace name {                                                                               \
  target double noise(double x, double y, double z, int g) {                                     \
    return noise_of<Quad>(x, y, z, g);                                                           \
  }                                                                                              \
  target void noise_many(const dvec3* p, std::size_t n, int g, double* out) {                    \
    noise_many_of<Quad>(p, n, g, out);                                                           \
  }                                                                                              \
  target dvec3 vnoise(const dvec3& p) { return vnoise_of<Quad>(p); }                             \
  target void vnoise_many(const dvec3* p, std::size_t n, dvec3* out) {                           \
    vnoise_many_of<Quad>(p, n, out);                                                             \
  }                                                                                              \
  target double turbulence(const dvec3& p, const Octaves& o, int g) {                            \
    return turbulence_of<Quad>(p, o, g);                                                         \
  }                                                                                              \
  target dvec3 vturbulence(const dvec3& p, const Octaves& o) {                                   \
    return vturbulence_of<Quad>(p, o);                                                           \
  }                                                                                              \
  target void vturbulence_many(const dvec3* p, std::size_t n, const Octaves& o, dvec3* out) {    \
    vturbulence_many_of<Quad>(p, n, o, out);                                                     \
  }                                                                                              \
  target void noise_octaves(const dvec3& p, double lambda, int n, int g, double* out) {          \
    noise_octaves_of<Quad>(p, lambda, n, g, out);                                                \
  }                                                                                              \
  target dvec3 vfolded(const dvec3& p, int n) { return vfolded_of<Quad>(p, n); }                 \
  constexpr NoiseKernels table{noise,      noise_many,  vnoise,           vnoise_many,           \
                               turbulence, vturbulence, vturbulence_many, noise_octaves,         \
                               vfolded};                                                         \
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

// Not a function-local static: its guard would cost a tenth of a noise call. Whoever asks before
// the second line has run gets the baseline, which gives the same bits.
constinit const NoiseKernels* best_kernels = &baseline::table;

namespace {

[[maybe_unused]] const bool chosen = [] {
  if (avx2_kernels() != nullptr) best_kernels = avx2_kernels();
  return true;
}();

}  // namespace

}  // namespace durer::functions::simd

#include "functions/simd/noise_kernels.h"

#include <algorithm>

#include "functions/simd/noise_lattice.h"
#include "functions/simd/processor.h"

namespace durer::functions::simd {
namespace {

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

/// What the generator makes of four interpolated sums, which `sums_in` gives for a kind of lattice.
template <class Quad, class SumsIn>
DURER_INLINE Quad noises_of(int generator, const SumsIn& sums_in) {
  const auto all = [](double v) DURER_LAMBDA_INLINE { return Quad::of(v, v, v, v); };
  if (generator == 3) {
    const Quad sums = sums_in.template operator()<GradientCorners>();
    return (all(0.5) * (all(1.59) * sums + all(0.985))).clamped01();
  }
  const NoiseScale scale = noise_scale(generator);
  const Quad sums = sums_in.template operator()<TableCorners>();
  return ((sums + all(scale.offset)) * all(scale.scale)).clamped01();
}
/// Noise at four points that are likely to lie together; only `count` of them matter.
template <class Quad>
DURER_INLINE Quad four_noises(Quad x, Quad y, Quad z, int generator, int count) {
  return noises_of<Quad>(generator, [&]<class Corners>() DURER_LAMBDA_INLINE {
    return lattice_sums<Corners>(x, y, z, count);
  });
}

/// Up to four points. Lanes that are left take the first.
template <class Quad>
struct FourPoints {
  Quad x, y, z;

  DURER_INLINE FourPoints(const dvec3* p, int count) {
    const dvec3& a = p[0];
    const dvec3& b = p[count > 1 ? 1 : 0];
    const dvec3& c = p[count > 2 ? 2 : 0];
    const dvec3& d = p[count > 3 ? 3 : 0];
    x = Quad::of(a.x, b.x, c.x, d.x);
    y = Quad::of(a.y, b.y, c.y, d.y);
    z = Quad::of(a.z, b.z, c.z, d.z);
  }
};
/// Calls visit(first, count) for groups of up to four among `n` points.
template <class Visit>
DURER_INLINE void by_fours(std::size_t n, const Visit& visit) {
  for (std::size_t done = 0; done < n; done += 4) {
    visit(done, n - done < 4 ? static_cast<int>(n - done) : 4);
  }
}

template <class Quad>
DURER_INLINE void noise_many_of(const dvec3* p, std::size_t n, int generator, double* out) {
  by_fours(n, [&](std::size_t first, int count) DURER_LAMBDA_INLINE {
    const FourPoints<Quad> at(p + first, count);
    alignas(32) double values[4];
    four_noises(at.x, at.y, at.z, generator, count).store(values);
    for (int i = 0; i < count; ++i) out[first + i] = values[i];
  });
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
  return noises_of<Quad>(generator, [&]<class Corners>() DURER_LAMBDA_INLINE {
    return FourApart<typename Corners::Axis, Quad>(c[0], c[1], c[2]).template sums<Corners>(count);
  });
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
/// Up to four vectors that have a lane each.
template <class Quad>
DURER_INLINE void put(const Quad& x, const Quad& y, const Quad& z, int count, dvec3* out) {
  alignas(32) double c[3][4];
  x.store(c[0]);
  y.store(c[1]);
  z.store(c[2]);
  for (int i = 0; i < count; ++i) out[i] = {c[0][i], c[1][i], c[2][i]};
}
template <class Quad>
DURER_INLINE void vnoise_many_of(const dvec3* p, std::size_t n, dvec3* out) {
  by_fours(n, [&](std::size_t first, int count) DURER_LAMBDA_INLINE {
    const FourPoints<Quad> at(p + first, count);
    const VectorNoises<Quad> noises(at.x, at.y, at.z, count);
    put(noises.x, noises.y, noises.z, count, out + first);
  });
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
      const TableCorners corners(Planes(lanes[0], k), Planes(lanes[1], k), Planes(lanes[2], k));
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
/// Calls visit(vector noises of an octave) for one octave of up to four points after another.
template <class Quad, class Visit>
DURER_INLINE void for_four_vnoises(const FourPoints<Quad>& at, int count, double lambda,
                                   int octaves, const Visit& visit) {
  double frequency = 1;
  for (int octave = 0; octave < octaves; ++octave, frequency *= lambda) {
    const Quad scale = Quad::all(&frequency);
    visit(VectorNoises<Quad>(scale * at.x, scale * at.y, scale * at.z, count));
  }
}
/// Up to four points, with a lane each: none is idle, whatever the number of octaves is.
template <class Quad>
DURER_INLINE void four_vturbulences(const dvec3* p, int count, const Octaves& o, dvec3* out) {
  constexpr double zero = 0;
  Quad x = Quad::all(&zero);
  Quad y = x;
  Quad z = x;
  double weight = 1;
  for_four_vnoises<Quad>(FourPoints<Quad>(p, count), count, o.lambda, o.count,
                         [&](const VectorNoises<Quad>& noises) DURER_LAMBDA_INLINE {
    x = x + Quad::all(&weight) * noises.x;
    y = y + Quad::all(&weight) * noises.y;
    z = z + Quad::all(&weight) * noises.z;
    weight *= o.omega;
  });
  put(x, y, z, count, out);
}
template <class Quad>
DURER_INLINE void vturbulence_many_of(const dvec3* p, std::size_t n, const Octaves& o,
                                      dvec3* out) {
  by_fours(n, [&](std::size_t first, int count) DURER_LAMBDA_INLINE {
    if (count == 1) {
      out[first] = vturbulence_of<Quad>(p[first], o);
    } else {
      four_vturbulences<Quad>(p + first, count, o, out + first);
    }
  });
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

template <class Quad>
DURER_INLINE void vfolded_many_of(const dvec3* p, std::size_t n, int octaves, dvec3* out) {
  by_fours(n, [&](std::size_t first, int count) DURER_LAMBDA_INLINE {
    constexpr double zero = 0;
    Quad x = Quad::all(&zero);
    Quad y = x;
    Quad z = x;
    double weight = 1;
    for_four_vnoises<Quad>(FourPoints<Quad>(p + first, count), count, 2, octaves,
                           [&](const VectorNoises<Quad>& noises) DURER_LAMBDA_INLINE {
      x = x + Quad::all(&weight) * noises.x.abs();
      y = y + Quad::all(&weight) * noises.y.abs();
      z = z + Quad::all(&weight) * noises.z.abs();
      weight *= 0.5;
    });
    put(x, y, z, count, out + first);
  });
}

/// Calls visit(octave, noises) for one octave of up to four points after another.
template <class Quad, class Visit>
DURER_INLINE void for_four_noises(const FourPoints<Quad>& at, int count, double lambda, int octaves,
                                  int generator, const Visit& visit) {
  double frequency = 1;
  for (int octave = 0; octave < octaves; ++octave, frequency *= lambda) {
    const Quad scale = Quad::all(&frequency);
    visit(octave, four_noises(scale * at.x, scale * at.y, scale * at.z, generator, count));
  }
}
template <class Quad>
DURER_INLINE void turbulence_many_of(const dvec3* p, std::size_t n, const Octaves& o,
                                     int generator, double* out) {
  const double scale = generator >= 2 ? 2.0 : 1.0;
  const double shift = generator >= 2 ? 0.5 : 0.0;
  by_fours(n, [&](std::size_t first, int count) DURER_LAMBDA_INLINE {
    constexpr double zero = 0;
    Quad value = Quad::all(&zero);
    double weight = 1;
    for_four_noises<Quad>(FourPoints<Quad>(p + first, count), count, o.lambda, o.count, generator,
                          [&](int octave, const Quad& noises) DURER_LAMBDA_INLINE {
      const Quad signal = Quad::all(&scale) * noises - Quad::all(&shift);
      value = value + (octave == 0 ? signal.clamped01() : Quad::all(&weight) * signal);
      weight *= o.omega;
    });
    alignas(32) double values[4];
    value.store(values);
    for (int i = 0; i < count; ++i) out[first + i] = values[i];
  });
}
template <class Quad>
DURER_INLINE void four_octaves_of(const dvec3* p, int count, double lambda, int octaves,
                                  int generator, double* out) {
  for_four_noises<Quad>(FourPoints<Quad>(p, count), count, lambda, octaves, generator,
                        [&](int octave, const Quad& noises) DURER_LAMBDA_INLINE {
    noises.store(out + 4 * octave);
  });
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
  target void turbulence_many(const dvec3* p, std::size_t n, const Octaves& o, int g,            \
                              double* out) {                                                     \
    turbulence_many_of<Quad>(p, n, o, g, out);                                                   \
  }                                                                                              \
  target void vfolded_many(const dvec3* p, std::size_t n, int octaves, dvec3* out) {             \
    vfolded_many_of<Quad>(p, n, octaves, out);                                                   \
  }                                                                                              \
  target void four_octaves(const dvec3* p, int count, double lambda, int octaves, int g,         \
                           double* out) {                                                        \
    four_octaves_of<Quad>(p, count, lambda, octaves, g, out);                                    \
  }                                                                                              \
  constexpr NoiseKernels table{noise,      noise_many,  vnoise,           vnoise_many,           \
                               turbulence, vturbulence, vturbulence_many, noise_octaves,         \
                               vfolded,    turbulence_many, vfolded_many, four_octaves};         \
  }

namespace {
DURER_NOISE_KERNELS(baseline, PairQuad, )
#ifdef __x86_64__
DURER_NOISE_KERNELS(avx2, WideQuad, DURER_AVX2)
#endif
}  // namespace

const NoiseKernels& baseline_kernels() { return baseline::table; }

const NoiseKernels* avx2_kernels() {
#ifdef __x86_64__
  if (durer::simd::has_avx2()) return &avx2::table;
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

#include "functions/simd/noise_bound_kernel.h"

#include <algorithm>
#include <cmath>

#include "functions/simd/processor.h"
#include "functions/simd/quad.h"

namespace durer::functions::simd {
namespace {

DURER_INLINE Ball between(double lo, double hi) { return {(lo + hi) / 2, (hi - lo) / 2}; }

/// The weighted mean a + s (b - a) for weights s in [0, 1].
DURER_INLINE Ball mix(const Ball& a, const Ball& b, const Ball& s) {
  return {a.m + s.m * (b.m - a.m),
          a.r + s.m * (b.r - a.r) + s.r * (std::abs(b.m - a.m) + a.r + b.r)};
}

DURER_INLINE Ball slope_of_smooth_step(const Ball& f) {
  const auto slope = [](double v) DURER_LAMBDA_INLINE { return 6 * v * (1 - v); };
  const double p = slope(f.m - f.r);
  const double q = slope(f.m + f.r);
  return between(std::min(p, q), std::abs(f.m - 0.5) <= f.r ? 1.5 : std::max(p, q));
}

/// Four balls side by side.
template <class Quad>
struct Balls {
  Quad m, r;
};
template <class Quad>
DURER_INLINE Quad all(double v) {
  return Quad::of(v, v, v, v);
}
template <class Quad>
DURER_INLINE Balls<Quad> mix(const Balls<Quad>& a, const Balls<Quad>& b, const Ball& s) {
  const Quad step = b.m - a.m;
  return {a.m + all<Quad>(s.m) * step,
          a.r + all<Quad>(s.m) * (b.r - a.r) + all<Quad>(s.r) * (step.abs() + a.r + b.r)};
}
/// Lanes 0 and 1, 2 and 3 by `s`, then both by `t`.
template <class Quad>
DURER_INLINE Ball mix(const Balls<Quad>& v, const Ball& s, const Ball& t) {
  const Ball low = mix(Ball{v.m.template at<0>(), v.r.template at<0>()},
                       Ball{v.m.template at<1>(), v.r.template at<1>()}, s);
  const Ball high = mix(Ball{v.m.template at<2>(), v.r.template at<2>()},
                        Ball{v.m.template at<3>(), v.r.template at<3>()}, s);
  return mix(low, high, t);
}

/// The corner functions c0 + c1 fx + c2 fy + c3 fz of four corners of a face, and their values at
/// the box's middle.
template <class Quad>
struct Face {
  Quad c0, c1, c2, c3;
  Quad v;
};

template <class Quad>
DURER_INLINE Face<Quad> face_of(const Cell& cell, const int (&corner)[4], const Ball (&f)[3]) {
  const double* const a = cell.row[corner[0]];
  const double* const b = cell.row[corner[1]];
  const double* const c = cell.row[corner[2]];
  const double* const d = cell.row[corner[3]];
  const auto bit = [&](int k) DURER_LAMBDA_INLINE {
    return Quad::of(corner[0] >> k & 1, corner[1] >> k & 1, corner[2] >> k & 1, corner[3] >> k & 1);
  };
  Face<Quad> r;
  r.c1 = Quad::of(a[1], b[1], c[1], d[1]);
  r.c2 = Quad::of(a[2], b[2], c[2], d[2]);
  r.c3 = Quad::of(a[3], b[3], c[3], d[3]);
  r.c0 = Quad::of(a[0], b[0], c[0], d[0]) - bit(0) * r.c1 - bit(1) * r.c2 - bit(2) * r.c3;
  r.v = r.c0 + all<Quad>(f[0].m) * r.c1 + all<Quad>(f[1].m) * r.c2 + all<Quad>(f[2].m) * r.c3;
  return r;
}
/// How far linear functions vary over the box.
template <class Quad>
DURER_INLINE Quad reach(const Quad& c1, const Quad& c2, const Quad& c3, const Ball (&f)[3]) {
  return c1.abs() * all<Quad>(f[0].r) + c2.abs() * all<Quad>(f[1].r) + c3.abs() * all<Quad>(f[2].r);
}

/// The value is a weighted mean of the corner functions; its slope along an axis is S' times a
/// weighted mean of their differences plus a weighted mean of their slopes. The mean value theorem
/// turns the slopes into an enclosure of the value.
template <class Quad>
DURER_INLINE NoiseBound bound_of(const Cell& cell, const Ball (&f)[3]) {
  Ball s[3];
  Ball s_middle[3];
  for (int axis = 0; axis < 3; ++axis) {
    s[axis] = between(smooth_step(f[axis].m - f[axis].r), smooth_step(f[axis].m + f[axis].r));
    s_middle[axis] = {smooth_step(f[axis].m), 0};
  }
  // Faces across each axis; their corners in the order of the other two axes.
  static constexpr int corners[3][2][4] = {
      {{0, 2, 4, 6}, {1, 3, 5, 7}}, {{0, 1, 4, 5}, {2, 3, 6, 7}}, {{0, 1, 2, 3}, {4, 5, 6, 7}}};
  static constexpr int others[3][2] = {{1, 2}, {0, 2}, {0, 1}};
  const Quad none = all<Quad>(0);

  NoiseBound bound;
  Ball range;
  Ball mean_value;
  double swing = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const Face<Quad> low = face_of<Quad>(cell, corners[axis][0], f);
    const Face<Quad> high = face_of<Quad>(cell, corners[axis][1], f);
    const Ball& u = s[others[axis][0]];
    const Ball& v = s[others[axis][1]];
    if (axis == 2) {
      const Balls<Quad> lows{low.v, reach(low.c1, low.c2, low.c3, f)};
      const Balls<Quad> highs{high.v, reach(high.c1, high.c2, high.c3, f)};
      range = mix(mix(lows, highs, s[2]), u, v);
      mean_value = mix(mix(Balls<Quad>{low.v, none}, Balls<Quad>{high.v, none}, s_middle[2]),
                       s_middle[0], s_middle[1]);
    }
    const Balls<Quad> step{high.v - low.v,
                           reach(high.c1 - low.c1, high.c2 - low.c2, high.c3 - low.c3, f)};
    const Ball change = mix(step, u, v);
    const Ball steepness = slope_of_smooth_step(f[axis]);
    const Quad& slope_low = axis == 0 ? low.c1 : axis == 1 ? low.c2 : low.c3;
    const Quad& slope_high = axis == 0 ? high.c1 : axis == 1 ? high.c2 : high.c3;
    const Ball slope =
        mix(mix(Balls<Quad>{slope_low, none}, Balls<Quad>{slope_high, none}, s[axis]), u, v);
    const double largest = std::abs(change.m) + change.r;
    const double m = change.m * steepness.m + slope.m;
    const double r = change.r * steepness.m + largest * steepness.r + slope.r;
    const double steepest = largest * (steepness.m + steepness.r) + std::abs(slope.m) + slope.r;
    bound.slope_lo[axis] = std::max(m - r, -steepest);
    bound.slope_hi[axis] = std::min(m + r, steepest);
    swing += std::min(std::abs(m) + r, steepest) * f[axis].r;
  }
  bound.lo = std::max(range.m - range.r, mean_value.m - swing);
  bound.hi = std::min(range.m + range.r, mean_value.m + swing);
  return bound;
}

NoiseBound baseline(const Cell& cell, const Ball (&f)[3]) { return bound_of<PairQuad>(cell, f); }
#ifdef __x86_64__
DURER_AVX2 NoiseBound avx2(const Cell& cell, const Ball (&f)[3]) {
  return bound_of<WideQuad>(cell, f);
}
#endif

using Kernel = NoiseBound (*)(const Cell&, const Ball (&)[3]);
constinit Kernel best = &baseline;
[[maybe_unused]] const bool chosen = [] {
#ifdef __x86_64__
  if (durer::simd::has_avx2()) best = &avx2;
#endif
  return true;
}();

}  // namespace

NoiseBound noise_bound(const Cell& cell, const Ball (&f)[3]) { return best(cell, f); }
NoiseBound noise_bound(const Cell& cell, const Ball (&f)[3], int set) {
  return set == 0 ? baseline(cell, f) : best(cell, f);
}

}  // namespace durer::functions::simd

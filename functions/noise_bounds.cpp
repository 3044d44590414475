// Bounds and derivatives of the scalar noise: what interval and gradient evaluation need.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "functions/noise.h"
#include "functions/noise_cell.h"
#include "functions/simd/noise_bound_kernel.h"

namespace durer::functions {
namespace {

using simd::Ball;

/// Covers the rounding of the value, the hair's breadth by which the cells of generators 1 and 2
/// overlap below zero (1e-10 times a gradient below 10), and slivers.
constexpr double pad = 3e-8;
/// A box that reaches into a cell by less than this is taken to end at its border: boxes are often
/// aligned with the lattice. Value and gradient are continuous there, and change little beyond.
constexpr double sliver = 4e-9;
/// A box over more cells is bounded by what is known in its middle: looking into each cell costs
/// more than it brings.
constexpr int max_cells = 2;

Cell cell_at(double x, double y, double z, NoiseGenerator generator) {
  return generator == 3 ? gradient_cell(gradient_lattice(), x, y, z) : table_cell(x, y, z);
}

/// A linear function of the position in the cell: c[0] + c[1] fx + c[2] fy + c[3] fz.
using Linear = std::array<double, 4>;

Linear corner_function(const Cell& cell, int corner) {
  const double* g = cell.row[corner];
  const int dx = corner & 1;
  const int dy = (corner >> 1) & 1;
  const int dz = corner >> 2;
  return {g[0] - dx * g[1] - dy * g[2] - dz * g[3], g[1], g[2], g[3]};
}

/// Range and slopes of the interpolated sum over a box inside one cell.
struct Sum {
  Interval v;
  Trend::Slopes d;
};
Sum hull(const Sum& a, const Sum& b) {
  Sum r{durer::hull(a.v, b.v), {}};
  for (int i = 0; i < 3; ++i) r.d[i] = durer::hull(a.d[i], b.d[i]);
  return r;
}

Sum sum_over(const Cell& cell, const Ball (&box)[3]) {
  const simd::NoiseBound b = simd::noise_bound(cell, box);
  Sum sum;
  if (b.lo <= b.hi) {
    sum.v = {b.lo, b.hi};
  } else {  // which only rounding can cause
    sum.v = {b.hi, b.lo};
  }
  for (int axis = 0; axis < 3; ++axis) {
    sum.d[axis] = {b.slope_lo[axis] - pad, b.slope_hi[axis] + pad};
  }
  return sum;
}

/// Parts of an axis that lie in one cell each, as coordinate of the cell and position in it.
struct AxisParts {
  int count = 0;
  std::array<double, max_cells> lower;
  std::array<double, max_cells> middle;
  std::array<double, max_cells> radius;

  [[nodiscard]] Ball f(int i) const { return {middle[i], radius[i]}; }
};
/// The floor of a number that is not large, without a call.
double floor_of(double v) {
  const double n = simd::to_int32(v);
  return n > v ? n - 1 : n;
}
AxisParts split(const Interval& x, double shift) {
  AxisParts parts;
  const double lo = x.lo + shift;
  const double hi = x.hi + shift;
  if (!(std::abs(lo) < 1e9 && std::abs(hi) < 1e9)) return parts;
  double first = floor_of(lo);
  double last = floor_of(hi);
  if (last > first && hi - last < sliver) --last;
  if (last > first && first + 1 - lo < sliver) ++first;
  if (!(last - first < max_cells)) return parts;
  parts.count = static_cast<int>(last - first) + 1;
  for (int i = 0; i < std::min(parts.count, max_cells); ++i) {
    const double n = first + i;
    parts.lower[i] = n - shift;
    const double from = std::max(lo - n, 0.0);
    const double to = std::min(hi - n, 1.0);
    parts.middle[i] = (from + to) / 2;
    parts.radius[i] = (to - from) / 2;
  }
  return parts;
}

Interval clamped_noise(const Interval& sum, NoiseGenerator generator) {
  const NoiseScale scale = noise_scale(generator);
  const Interval v = (sum + Interval(scale.offset)) * scale.scale;
  return {std::clamp(v.lo - pad, 0.0, 1.0), std::clamp(v.hi + pad, 0.0, 1.0)};
}

}  // namespace

// The largest that any choice of lattice rows for the eight corners of a cell gives anywhere in it,
// rounded up from 3.884 and 19.21, 1.903 and 9.41, 1.732 and 9.21 (test_noise_steepness.cpp searches them).
NoiseSteepness steepest_noise(NoiseGenerator generator) {
  if (generator == 3) return {1.74, 9.25};
  return generator == 2 ? NoiseSteepness{1.91, 9.45} : NoiseSteepness{3.9, 19.3};
}

namespace {

/// The sum over a box; nothing where the box spans too many cells, or lies beyond the lattice.
std::optional<Sum> sum_over_cells(const Interval& x, const Interval& y, const Interval& z,
                                  NoiseGenerator generator) {
  const double shift = generator == 3 ? 10000000.023157213 : 0.0;
  const AxisParts px = split(x, shift);
  const AxisParts py = split(y, shift);
  const AxisParts pz = split(z, shift);
  const int cells = px.count * py.count * pz.count;
  if (cells == 0 || cells > max_cells) return std::nullopt;

  Sum sum;
  bool first = true;
  for (int i = 0; i < px.count; ++i) {
    for (int j = 0; j < py.count; ++j) {
      for (int k = 0; k < pz.count; ++k) {
        const Cell cell =
            cell_at(px.lower[i] + 0.5, py.lower[j] + 0.5, pz.lower[k] + 0.5, generator);
        const Sum part = sum_over(cell, {px.f(i), py.f(j), pz.f(k)});
        sum = first ? part : hull(sum, part);
        first = false;
      }
    }
  }
  return sum;
}

/// Beyond the 32-bit lattice the kernel overflows, to NaN at last.
bool is_far(const Interval& a) { return !(a.lo > -2e9 && a.hi < 2e9); }

Interval unknown_noise(const Interval& x, const Interval& y, const Interval& z) {
  return {0, 1, x.nan || y.nan || z.nan || is_far(x) || is_far(y) || is_far(z)};
}

}  // namespace

namespace {

/// Beyond this radius, in cells, a ball around the middle bounds a box: it may reach into several
/// cells, and costs no more than a point. Below it, the box's own bounds are much closer.
constexpr double small_ball = 0.1;

double square(double v) { return v * v; }

/// From the value in the middle, and how far it can change until the corners.
Interval noise_in_ball(const Interval& x, const Interval& y, const Interval& z, double radius,
                       NoiseGenerator generator) {
  Interval r = unknown_noise(x, y, z);
  const double reach = steepest_noise(generator).slope * radius + pad;
  if (r.nan || !(reach < 1)) return r;
  const double middle = noise(x.mid(), y.mid(), z.mid(), generator);
  return {std::max(middle - reach, 0.0), std::min(middle + reach, 1.0)};
}

}  // namespace

Interval noise(Interval x, Interval y, Interval z, NoiseGenerator generator) {
  if (x.is_point() && y.is_point() && z.is_point()) {
    return noise(dvec3(x.lo, y.lo, z.lo), generator);
  }
  const double radius = std::sqrt(square(x.radius()) + square(y.radius()) + square(z.radius()));
  if (!(radius < small_ball)) return noise_in_ball(x, y, z, radius, generator);
  const std::optional<Sum> sum = sum_over_cells(x, y, z, generator);
  if (!sum) return noise_in_ball(x, y, z, radius, generator);
  Interval r = clamped_noise(sum->v, generator);
  r.nan = x.nan || y.nan || z.nan;
  return r;
}

bool is_any_noise(const Trend& x, const Trend& y, const Trend& z, NoiseGenerator generator) {
  const Interval px = x.range();
  const Interval py = y.range();
  const Interval pz = z.range();
  if (unknown_noise(px, py, pz).nan) return false;
  const double radius2 = square(px.radius()) + square(py.radius()) + square(pz.radius());
  return square(steepest_noise(generator).slope) * radius2 >= 1;
}

namespace {

/// A formula with the value `v` and these slopes along its three arguments.
Trend change_of(const Interval& v, const Trend::Slopes& slopes,
                const std::array<const Trend*, 3>& arguments) {
  Ranges sum;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Trend& a = *arguments[axis];
    if (trend_detail::is_constant(a)) continue;
    if (!a.is_bounded()) return Trend::erratic(v);
    sum = sum + a.all() * slopes[axis];
  }
  return Trend(sum, v);
}

}  // namespace

namespace {

/// Noise over a box, from value and slopes in its middle.
Trend noise_around(const std::array<const Trend*, 3>& arguments, NoiseGenerator generator) {
  std::array<Interval, 3> box;
  dvec3 middle;
  dvec3 reach;
  for (std::size_t k = 0; k < 3; ++k) {
    box[k] = arguments[k]->range();
    middle[static_cast<int>(k)] = box[k].mid();
    reach[static_cast<int>(k)] = box[k].radius();
  }
  Interval v = unknown_noise(box[0], box[1], box[2]);
  if (v.nan) return Trend::erratic(v);
  const auto [steepest, bend] = steepest_noise(generator);
  const double radius2 = square(reach.x) + square(reach.y) + square(reach.z);
  const double radius = std::sqrt(radius2);
  const double swing = steepest * radius + pad;
  const Interval any{-steepest, steepest};
  Trend::Slopes slopes{any, any, any};
  if (swing < 1) {
    const Dual m = noise(Dual(middle.x, {1, 0, 0}), Dual(middle.y, {0, 1, 0}),
                         Dual(middle.z, {0, 0, 1}), generator);
    const bool clamped = m.v <= 0 || m.v >= 1;
    const double linear = std::abs(m.d.x) * reach.x + std::abs(m.d.y) * reach.y +
                          std::abs(m.d.z) * reach.z + bend * radius2 / 2 + pad;
    const double change = clamped ? swing : std::min(swing, linear);
    v = {std::max(m.v - change, 0.0), std::min(m.v + change, 1.0)};
    const double turn = bend * radius + pad;
    for (std::size_t k = 0; k < 3 && !clamped; ++k) {
      const double d = m.d[static_cast<int>(k)];
      slopes[k] = {std::max(d - turn, -steepest), std::min(d + turn, steepest)};
      if (v.lo <= 0 || v.hi >= 1) slopes[k] = hull(slopes[k], 0.0);
    }
  }
  return change_of(v, slopes, arguments);
}

/// True if the arguments are linear functions of the first axis alone: points of a line.
bool are_on_line(const std::array<const Trend*, 3>& arguments) {
  for (const Trend* a : arguments) {
    const Trend::Slopes d{a->slope(0), a->slope(1), a->slope(2)};
    if (!(d[0].lo == d[0].hi && d[1].lo == 0 && d[1].hi == 0 && d[2].lo == 0 && d[2].hi == 0)) {
      return false;
    }
  }
  return true;
}

/// Noise along a part of a line, from value and slope in its middle.
Trend noise_along(const std::array<const Trend*, 3>& arguments, NoiseGenerator generator) {
  dvec3 middle;
  dvec3 direction;
  double radius2 = 0;  // half the part's length, squared
  for (int k = 0; k < 3; ++k) {
    const Interval p = arguments[static_cast<std::size_t>(k)]->range();
    middle[k] = p.mid();
    direction[k] = arguments[static_cast<std::size_t>(k)]->slope(0).lo;
    const double r = p.radius();
    radius2 += r * r;
  }
  const double speed = std::sqrt(square(direction.x) + square(direction.y) + square(direction.z));
  const double radius = std::sqrt(radius2);
  const double half = radius / speed;  // in units of |direction|
  const auto [slope_limit, bend] = steepest_noise(generator);
  const double steepest = slope_limit * speed;
  const double reach = slope_limit * radius + pad;
  Interval v{0, 1};
  Interval slope{-steepest, steepest};
  if (reach < 1) {
    const Dual at_middle =
        noise(Dual(middle.x, {direction.x, 0, 0}), Dual(middle.y, {direction.y, 0, 0}),
              Dual(middle.z, {direction.z, 0, 0}), generator);
    const double d = at_middle.d.x;
    const double turn = bend * radius * speed + pad * speed;
    double swing = std::min(reach, std::abs(d) * half + bend * radius2 / 2 + pad);
    const bool clamped = at_middle.v <= 0 || at_middle.v >= 1;
    if (clamped) swing = reach;
    v = {std::max(at_middle.v - swing, 0.0), std::min(at_middle.v + swing, 1.0)};
    if (!clamped) slope = {std::max(d - turn, -steepest), std::min(d + turn, steepest)};
    if (v.lo <= 0 || v.hi >= 1) slope = hull(slope, 0.0);
  }
  return {v, {slope, 0.0, 0.0}};
}

}  // namespace

Trend noise(const Trend& x, const Trend& y, const Trend& z, NoiseGenerator generator) {
  if (are_on_line({&x, &y, &z})) {
    const Interval v = unknown_noise(x.range(), y.range(), z.range());
    if (!v.nan && !(x.range().is_point() && y.range().is_point() && z.range().is_point())) {
      return noise_along({&x, &y, &z}, generator);
    }
  }
  const Interval px = x.range();
  const Interval py = y.range();
  const Interval pz = z.range();
  if (px.is_point() && py.is_point() && pz.is_point()) {
    return noise(dvec3(px.lo, py.lo, pz.lo), generator);
  }
  const std::optional<Sum> sum = sum_over_cells(px, py, pz, generator);
  if (!sum) return noise_around({&x, &y, &z}, generator);
  Interval v = clamped_noise(sum->v, generator);
  v.nan = px.nan || py.nan || pz.nan;
  const double scale = noise_scale(generator).scale;
  // Where the value is clamped it is flat.
  const bool clamped = v.lo <= 0 || v.hi >= 1;
  Trend::Slopes slopes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    slopes[axis] = sum->d[axis] * Interval(scale);
    if (clamped) slopes[axis] = hull(slopes[axis], 0.0);
  }
  return change_of(v, slopes, {&x, &y, &z});
}

Dual noise(const Dual& x, const Dual& y, const Dual& z, NoiseGenerator generator) {
  const double value = noise(dvec3(x.v, y.v, z.v), generator);
  if (!(value > 0 && value < 1)) return value;
  const Cell cell = cell_at(x.v, y.v, z.v, generator);
  const double f[3] = {cell.x.f, cell.y.f, cell.z.f};
  const double s[3] = {cell.x.s, cell.y.s, cell.z.s};
  dvec3 slope{0.0};
  for (int k = 0; k < 8; ++k) {
    double w[3];
    double dw[3];
    for (int i = 0; i < 3; ++i) {
      const bool upper = ((k >> i) & 1) != 0;
      w[i] = upper ? s[i] : 1 - s[i];
      dw[i] = (upper ? 6 : -6) * f[i] * (1 - f[i]);
    }
    const Linear g = corner_function(cell, k);
    const double v = g[0] + g[1] * f[0] + g[2] * f[1] + g[3] * f[2];
    slope.x += dw[0] * w[1] * w[2] * v + w[0] * w[1] * w[2] * g[1];
    slope.y += w[0] * dw[1] * w[2] * v + w[0] * w[1] * w[2] * g[2];
    slope.z += w[0] * w[1] * dw[2] * v + w[0] * w[1] * w[2] * g[3];
  }
  slope *= noise_scale(generator).scale;
  return {value, slope.x * x.d + slope.y * y.d + slope.z * z.d};
}

}  // namespace durer::functions

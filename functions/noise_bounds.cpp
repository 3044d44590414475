// Bounds and derivatives of the scalar noise: what interval and gradient evaluation need.
#include <array>

#include "functions/noise.h"
#include "functions/noise_cell.h"

namespace durer::functions {
namespace {

/// Covers the rounding of the value and the hair's breadth by which the cells of generators 1 and 2
/// overlap below zero (1e-10 times a gradient below 10).
constexpr double pad = 1e-8;
/// A box over more cells than this is bounded by the range of the noise.
constexpr int max_cells_per_axis = 3;

Cell cell_at(double x, double y, double z, NoiseGenerator generator) {
  return generator == 3 ? gradient_cell(gradient_lattice(), x, y, z) : table_cell(x, y, z);
}

/// A linear function of the position in the cell: c[0] + c[1] fx + c[2] fy + c[3] fz.
using Linear = std::array<double, 4>;
using Box = std::array<Interval, 3>;

Linear corner_function(const Cell& cell, int corner) {
  const double* r = cell.row[corner];
  const double at_origin = r[0] - (corner & 1) * r[1] - ((corner >> 1) & 1) * r[2] - (corner >> 2) * r[3];
  return {at_origin, r[1], r[2], r[3]};
}
Interval over(const Linear& f, const Box& box) {
  return Interval(f[0]) + f[1] * box[0] + f[2] * box[1] + f[3] * box[2];
}
Interval slope_of_smooth_step(const Interval& f) {
  const auto slope = [](double v) { return 6 * v * (1 - v); };
  const double p = slope(f.lo);
  const double q = slope(f.hi);
  return {std::min(p, q), f.lo <= 0.5 && f.hi >= 0.5 ? 1.5 : std::max(p, q)};
}

/// Weighted mean of two ranges with the weight S somewhere in a range.
Interval mix(const Interval& a, const Interval& b, const Interval& s) {
  return narrowed(hull(a, b), a * (Interval(1) - s) + b * s);
}
Interval mix(const std::array<Interval, 4>& v, const Interval& s, const Interval& t) {
  return mix(mix(v[0], v[1], s), mix(v[2], v[3], s), t);
}

/// The interpolated sum over a box inside one cell. Its value is a weighted mean of the corner
/// functions; its slope along an axis is S' times a weighted mean of their differences plus a
/// weighted mean of their slopes. The mean value theorem turns the slopes into an enclosure.
Interval sum_over(const Cell& cell, const Box& box) {
  std::array<Linear, 8> corner;
  for (int k = 0; k < 8; ++k) corner[k] = corner_function(cell, k);
  Box s;
  Box centre;
  for (int axis = 0; axis < 3; ++axis) {
    s[axis] = {smooth_step(box[axis].lo), smooth_step(box[axis].hi)};
    centre[axis] = box[axis].mid();
  }
  const auto trilinear = [](const std::array<Interval, 8>& v, const Box& w) {
    return mix(mix({v[0], v[1], v[2], v[3]}, w[0], w[1]), mix({v[4], v[5], v[6], v[7]}, w[0], w[1]),
               w[2]);
  };
  std::array<Interval, 8> values;
  for (int k = 0; k < 8; ++k) values[k] = over(corner[k], box);
  const Interval range = trilinear(values, s);

  for (int k = 0; k < 8; ++k) values[k] = over(corner[k], centre);
  Box s_centre;
  for (int axis = 0; axis < 3; ++axis) s_centre[axis] = smooth_step(centre[axis].lo);
  Interval mean_value = trilinear(values, s_centre);
  for (int axis = 0; axis < 3; ++axis) {
    const int step = 1 << axis;
    std::array<Interval, 4> difference;
    int n = 0;
    for (int k = 0; k < 8; ++k) {
      values[k] = corner[k][axis + 1];
      if ((k & step) != 0) continue;
      Linear d;
      for (int i = 0; i < 4; ++i) d[i] = corner[k + step][i] - corner[k][i];
      difference[n++] = over(d, box);
    }
    const Interval change = mix(difference, s[axis == 0 ? 1 : 0], s[axis == 2 ? 1 : 2]);
    const double radius = box[axis].radius();
    mean_value += (slope_of_smooth_step(box[axis]) * change + trilinear(values, s)) *
                  Interval(-radius, radius);
  }
  return narrowed(range, mean_value);
}

/// Parts of an axis that lie in one cell each, as {coordinate of the cell, range of f}.
struct AxisParts {
  int count = 0;
  std::array<double, max_cells_per_axis> lower{};
  std::array<Interval, max_cells_per_axis> f{};
};
AxisParts split(const Interval& x, double shift) {
  AxisParts parts;
  const double first = std::floor(x.lo + shift);
  const double last = std::floor(x.hi + shift);
  if (!(last - first < max_cells_per_axis) || !(std::abs(first) < 1e9)) return parts;
  parts.count = static_cast<int>(last - first) + 1;
  for (int i = 0; i < std::min(parts.count, max_cells_per_axis); ++i) {
    const double n = first + i;
    parts.lower[i] = n - shift;
    parts.f[i] = {std::max(x.lo + shift - n, 0.0), std::min(x.hi + shift - n, 1.0)};
  }
  return parts;
}

Interval clamped_noise(const Interval& sum, NoiseGenerator generator) {
  const NoiseScale scale = noise_scale(generator);
  const Interval v = (sum + Interval(scale.offset)) * scale.scale;
  return {std::clamp(v.lo - pad, 0.0, 1.0), std::clamp(v.hi + pad, 0.0, 1.0)};
}

}  // namespace

Interval noise(Interval x, Interval y, Interval z, NoiseGenerator generator) {
  if (x.is_point() && y.is_point() && z.is_point()) {
    return noise(dvec3(x.lo, y.lo, z.lo), generator);
  }
  const double shift = generator == 3 ? 10000000.023157213 : 0.0;
  const AxisParts px = split(x, shift);
  const AxisParts py = split(y, shift);
  const AxisParts pz = split(z, shift);
  const bool nan = x.nan || y.nan || z.nan;
  // Beyond the 32-bit lattice the kernel overflows, to NaN at last.
  const auto far = [](const Interval& a) { return !(a.lo > -2e9 && a.hi < 2e9); };
  if (px.count * py.count * pz.count == 0) return {0, 1, nan || far(x) || far(y) || far(z)};

  Interval sum;
  bool first = true;
  for (int i = 0; i < px.count; ++i) {
    for (int j = 0; j < py.count; ++j) {
      for (int k = 0; k < pz.count; ++k) {
        const Cell cell =
            cell_at(px.lower[i] + 0.5, py.lower[j] + 0.5, pz.lower[k] + 0.5, generator);
        const Interval part = sum_over(cell, {px.f[i], py.f[j], pz.f[k]});
        sum = first ? part : hull(sum, part);
        first = false;
      }
    }
  }
  Interval r = clamped_noise(sum, generator);
  r.nan = nan;
  return r;
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

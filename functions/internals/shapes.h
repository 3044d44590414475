// Distance-like shapes: balls, boxes, rings, helices, weaves (builtin-functions §4, §4.1).
#pragma once

#include "functions/internals/common.h"

namespace durer::functions::internals {

template <class T>
T f_comma(const Args<T>& a) {
  const T x = x_off_axis(a, 0.0001);
  const T& s = a.p[0];
  const T z2 = sqr(a.z);
  const T y2 = sqr(a.y);
  const T angle = atan2(a.z, x);
  const T d = sqrt(sqr(x + s / 4) + z2);
  const T tail = min(a.z, T(cos(angle / 2) * s / 2 - sqrt(sqr(d - 3 * s / 4) + y2)));
  const T head = s / 2 - sqrt(sqr(x - s / 2) + y2 + z2);
  return -max(tail, head);
}
template <class T>
T f_ellipsoid(const Args<T>& a) {
  return sqrt(sqr(a.p[0] * a.x) + sqr(a.p[1] * a.y) + sqr(a.p[2] * a.z));
}
template <class T>
T f_helical_torus(const Args<T>& a) {
  const auto& [x0, y, z, p, context] = a;
  const T x = x_off_axis(a, 1e-6);
  const T r = rho(a);
  const T phi = atan2(x, z);
  const T from_ring = r - p[0];
  const T tau = atan2(from_ring, y);
  const T d = sqrt(sqr(from_ring) + sqr(y));
  const T turn = positive_mod(T(phi * p[1] + tau * p[2]), T(2 * pi)) - pi;
  const T groove = atan2(T(turn * p[8]), T(d - p[5]));
  const T h = cos(groove * p[7] + phi * p[9]) * p[3] + p[4];
  const T outer = p[4] + p[5] - p[0] - r;
  const T inner = h - min(T(sqrt(sqr(d - p[5]) + sqr(turn) * p[6])), T(d + p[5]));
  return -max(outer, inner);
}
template <class T>
T f_helix1(const Args<T>& a) {
  const auto& [x0, y, z, p, context] = a;
  const T x = x_off_axis(a, 1e-6);
  const T r = rho(a);
  const T turn = positive_mod(T(atan2(z, x) * p[0] + y * p[1] * p[0]), T(2 * pi));
  const T v = (turn - pi) / p[4] / (p[1] * p[0]);
  const T u = r - p[3];
  const auto straight = either(eq(p[5], T(1)), eq(p[6], T(0)));
  const T angle = p[6] * (pi / 180);
  const T u2 = lazily(
      straight, [&] { return u; }, [&] { return T(u * cos(angle) - v * sin(angle)); });
  const T v2 = lazily(
      straight, [&] { return v; }, [&] { return T(u * sin(angle) + v * cos(angle)); });
  return -p[2] + min(T(p[3] + r), cross_section(u2, v2, p[5]));
}
template <class T>
T f_helix2(const Args<T>& a) {
  const auto& [x, y, z, p, context] = a;
  const T t = y * p[1];
  const T c = cos(t);
  const T s = sin(t);
  const T dx = x - p[3] * c;
  const T dz = z - p[3] * s;
  return cross_section(T(dx * c + dz * s), T(-dx * s + dz * c), p[5]) - p[2];
}

/// Offsets from the nearest centre of a hexagonal grid, folded into one sixth by the angle.
template <class T>
struct HexOffset {
  T a, b, angle;
};
template <class T>
HexOffset<T> hex_offset(const Args<T>& args) {
  const double half_width = std::sqrt(3.0) / 2;
  const T a = abs(fmod(abs(args.x), T(2 * half_width)) - half_width);
  const T b = abs(fmod(abs(args.y), T(3)) - 1.5);
  const T a2 = half_width - a;
  const T b2 = 1.5 - b;
  const auto swap = lt(sqr(a2) + sqr(b2), sqr(a) + sqr(b));
  const T u = where(swap, a2, a);
  const T v = where(swap, b2, b);
  return {u, v, atan2(v, u)};
}
template <class T>
T f_hex_x(const Args<T>& args) {
  const auto [a, b, angle] = hex_offset(args);
  return where(lt(angle, T(pi / 6)), a, T(std::cos(pi / 3) * a + std::sin(pi / 3) * b));
}
template <class T>
T f_hex_y(const Args<T>& args) {
  const auto [a, b, angle] = hex_offset(args);
  return where(lt(angle, T(pi / 6)), b, T(abs(-std::sin(pi / 3) * a + std::cos(pi / 3) * b)));
}
template <class T>
T f_mesh1(const Args<T>& a) {
  const T& x = a.x;
  const T& y = a.y;
  const T& z = a.z;
  const T* const p = a.p;
  const auto offset = [&](const T& q, const T& d) {
    return T(abs(positive_mod(q, T(2 * d)) - d) * p[2]);
  };
  const T wave_z = p[3] * cos(pi * z / p[1]);
  const T wave_x = p[3] * cos(pi * x / p[0]);
  const auto thread = [&](const T& height, const T& side) {
    return T(sqrt(sqr(height * p[4]) + sqr(side)));
  };
  const T along_z =
      min(thread(T(y - wave_z), offset(x, p[0])), thread(T(y + wave_z), offset(T(x - p[0]), p[0])));
  const T along_x =
      min(thread(T(y + wave_x), offset(z, p[1])), thread(T(y - wave_x), offset(T(z - p[1]), p[1])));
  return min(along_z, along_x);
}
template <class T>
T f_ph(const Args<T>& a) {
  return atan2(rho(a), a.y);
}
/// The quartic of y with coefficients p[first]... .
template <class T>
T quartic_of_y(const Args<T>& a, int first) {
  const T* c = a.p + first;
  const T y2 = sqr(a.y);
  return c[0] + c[1] * a.y + c[2] * y2 + c[3] * y2 * a.y + c[4] * sqr(y2);
}
template <class T>
T f_poly4(const Args<T>& a) {
  return rho(a) - max(T(-5), quartic_of_y(a, 0));
}
template <class T>
T f_polytubes(const Args<T>& a) {
  double tubes = 0;
  const bool uniform = is_uniform(a.p[0], tubes);
  if constexpr (std::is_same_v<T, Pack>) {
    if (!uniform) return by_lane<6>(a, [](const auto& b) { return f_polytubes(b); });
  } else if constexpr (std::is_same_v<T, Interval>) {
    if (!uniform) return {0, 10000, true};
  } else if constexpr (std::is_same_v<T, Trend>) {
    if (!uniform) return Trend::erratic({0, 10000, true});
  }
  const T r = quartic_of_y(a, 1);
  T best(10000);
  for (int i = 0; i < static_cast<int>(std::min(truncated32(tubes), max_terms)); ++i) {
    const double angle = 2 * pi * i / tubes;
    best = min(best, T(sqrt(sqr(a.x - r * std::sin(angle)) + sqr(a.z - r * std::cos(angle)))));
  }
  return best;
}
template <class T>
T f_quantum(const Args<T>& a) {
  const T x = x_off_axis(a, 1e-6);
  const T r2 = sqr(x) + sqr(a.z);
  const T c = cos(atan2(T(sqrt(r2)), a.y));
  const T q = 2 * sqrt(r2 + sqr(a.y));
  const T t = sqr(q) * exp(-0.33333333 * q) * (3 * sqr(c) - 1);
  return -0.1 * (sqr(t) - 12);
}
template <class T>
T f_r(const Args<T>& a) {
  return radius(a);
}
template <class T>
T f_rounded_box(const Args<T>& a) {
  const T zero(0);
  const T& r = a.p[0];
  const T dx = max(zero, T(abs(a.x) - (a.p[1] - r)));
  const T dy = max(zero, T(abs(a.y) - (a.p[2] - r)));
  const T dz = max(zero, T(abs(a.z) - (a.p[3] - r)));
  return sqrt(sqr(dx) + sqr(dy) + sqr(dz)) - r - 1e-6;
}
template <class T>
T f_sphere(const Args<T>& a) {
  return radius(a) - a.p[0];
}
template <class T>
T f_spiral(const Args<T>& a) {
  const auto& [x0, y, z, p, context] = a;
  const T x = x_off_axis(a, 1e-6);
  const T w = fmod(T(rho(a) + p[0] * atan2(z, x) / (2 * pi)), p[0]) - p[0] / 2;
  const T d = cross_section(w, y, p[5]);
  const T r = sqrt(sqr(x) + sqr(y) + sqr(z));
  return -min(T(p[2] - r), T(p[1] - min(d, r)));
}
/// Positive inside.
template <class T>
T f_superellipsoid(const Args<T>& a) {
  const T& e = a.p[0];
  const T& n = a.p[1];
  const T ring = pow(T(pow(abs(a.x), 2 / e) + pow(abs(a.y), 2 / e)), e / n);
  return 1 - pow(T(ring + pow(abs(a.z), 2 / n)), n * 0.5);
}
template <class T>
T f_th(const Args<T>& a) {
  return atan2(a.x, a.z);
}
template <class T>
T f_torus(const Args<T>& a) {
  return sqrt(sqr(rho(a) - a.p[0]) + sqr(a.y)) - a.p[1];
}

}  // namespace durer::functions::internals

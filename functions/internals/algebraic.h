// Algebraic surfaces: one polynomial each, times a field strength (builtin-functions §4).
#pragma once

#include "functions/internals/common.h"

namespace durer::functions::internals {

template <class T>
T f_bicorn(const Args<T>& a) {
  const T r2 = rho2(a);
  const T k = sqr(a.p[1]);
  return field(a, T(sqr(a.y) * (k - r2) - sqr(r2 + 2 * a.p[1] * a.y - k)));
}
template <class T>
T f_bifolia(const Args<T>& a) {
  return field(a, T(-(sqr(square_sum(a)) - a.p[1] * rho2(a) * a.y)));
}
template <class T>
T f_boy_surface(const Args<T>& a) {
  const double sqrt2 = std::numbers::sqrt2;
  const auto& [x, y, z, p, context] = a;
  const T w = 1 - z;
  const T x2 = sqr(x);
  const T y2 = sqr(y);
  const T z2 = sqr(z);
  const T q = x2 + y2;
  const T z4 = 4 * sqr(z2);
  const T v = 64 * cube(w) * cube(z) - 48 * sqr(w) * z2 * (3 * x2 + 3 * y2 + 2 * z2) +
              12 * w * z * (27 * sqr(q) - 24 * z2 * q + 36 * sqrt2 * y * z * (y2 - 3 * x2) + z4) +
              (9 * x2 + 9 * y2 - 2 * z2) *
                  (-81 * sqr(q) - 72 * z2 * q + 108 * sqrt2 * x * z * (x2 - 3 * y2) + z4);
  return field(a, T(p[1] * v));
}
template <class T>
T f_crossed_trough(const Args<T>& a) {
  return field(a, T(sqr(a.x) * sqr(a.z) - a.y));
}
template <class T>
T f_cubic_saddle(const Args<T>& a) {
  return field(a, T(-(cube(a.x) - cube(a.y) - a.z)));
}
template <class T>
T f_cushion(const Args<T>& a) {
  const auto& [x, y, z, p, context] = a;
  const T x2 = sqr(x);
  const T y2 = sqr(y);
  const T z2 = sqr(z);
  return field(a, T(x2 * z2 - sqr(z2) - 2 * x2 * z + 2 * cube(z) + x2 - z2 - sqr(x2 - z) - sqr(y2) -
                    2 * x2 * y2 - y2 * z2 + 2 * y2 * z + y2));
}
template <class T>
T f_devils_curve(const Args<T>& a) {
  const T x2 = sqr(a.x);
  const T y2 = sqr(a.y);
  const T z2 = sqr(a.z);
  return field(a, T(-(sqr(x2) + 2 * x2 * z2 - 0.36 * x2 - sqr(y2) + 0.25 * y2 + sqr(z2))));
}
template <class T>
T f_dupin_cyclid(const Args<T>& a) {
  const T& major = a.p[1];
  const T& minor = a.p[2];
  const T& dx = a.p[3];
  const T& dy = a.p[4];
  const T k = sqr(a.p[5]);
  const T c2 = sqr(dx);
  const T a2 = sqr(minor);
  const T b2 = sqr(dy);
  const T d2 = sqr(major);
  const T S = square_sum(a);
  const T plane = a.x * dx + a.y * dy;
  const T v = (a2 - b2 - sqr(dx + major)) * (a2 - b2 - sqr(dx - major)) * sqr(S) +
              2 * k * ((-b2 - c2 + a2 + d2) * (2 * plane - k) - 4 * dy * a2 * a.y) * S +
              4 * sqr(k) * plane * (plane - k) + 4 * sqr(k) * d2 * sqr(a.y) + sqr(sqr(k));
  return field(a, T(-v));
}
/// Below |z| = 0.2 the denominators hold 0.2, of either side; the square of z is the true one.
template <class T>
T f_enneper(const Args<T>& a) {
  const T z = where(lt(abs(a.z), T(0.2)), T(0.2), a.z);
  const T d = sqr(a.y) - sqr(a.x);
  const T u = d / (2 * z) + 2 * sqr(a.z) / 9;
  const T v = d / (4 * z);
  return field(a, T(-(cube(u) - 6 * sqr(v))));
}
template <class T>
T f_folium_surface(const Args<T>& a) {
  return field(
      a, T((sqr(a.y) + sqr(a.z)) * (1 + (a.p[2] - 4 * a.p[1]) * a.x) + sqr(a.x) * (1 + a.p[2])));
}
template <class T>
T f_glob(const Args<T>& a) {
  return field(a, T(0.5 * a.x * fourth(a.x) + 0.5 * fourth(a.x) - (sqr(a.y) + sqr(a.z))));
}
template <class T>
T f_heart(const Args<T>& a) {
  const T x2 = sqr(a.x);
  const T y2 = sqr(a.y);
  return field(a,
               T(-(cube(T(2 * x2 + y2 + sqr(a.z) - 1)) - 0.1 * x2 * cube(a.z) - y2 * cube(a.z))));
}
template <class T>
T f_hunt_surface(const Args<T>& a) {
  return field(a, T(-(4 * cube(T(square_sum(a) - 13)) +
                      27 * sqr(3 * sqr(a.x) + sqr(a.y) - 4 * sqr(a.z) - 12))));
}
template <class T>
T f_hyperbolic_torus(const Args<T>& a) {
  const T P = sqr(a.p[1]);
  const T Q = sqr(a.p[2]);
  const T x2 = sqr(a.x);
  const T y2 = sqr(a.y);
  const T z2 = sqr(a.z);
  return field(a, T(-(sqr(x2) + 2 * x2 * y2 - 2 * x2 * z2 - 2 * (P + Q) * x2 + sqr(y2) -
                      2 * y2 * z2 + 2 * (P - Q) * y2 + sqr(z2) + 2 * (P + Q) * z2 + sqr(P - Q))));
}
template <class T>
T f_kampyle_of_eudoxus(const Args<T>& a) {
  const T x2 = sqr(a.x);
  const T c2 = sqr(a.p[2]);
  return field(a, T(-(sqr(a.y) + sqr(a.z) - c2 * sqr(x2) + c2 * sqr(a.p[1]) * x2)));
}
template <class T>
T f_klein_bottle(const Args<T>& a) {
  const T S = square_sum(a);
  const T m = S - 2 * a.y - 1;
  return field(a, T(-((S + 2 * a.y - 1) * (sqr(m) - 8 * sqr(a.z)) + 16 * a.x * a.z * m)));
}
template <class T>
T f_kummer_surface_v1(const Args<T>& a) {
  const T x2 = sqr(a.x);
  const T y2 = sqr(a.y);
  const T z2 = sqr(a.z);
  return field(a,
               T(-(sqr(x2) + sqr(y2) + sqr(z2) - x2 - y2 - z2 - x2 * y2 - x2 * z2 - y2 * z2 + 1)));
}
template <class T>
T f_kummer_surface_v2(const Args<T>& a) {
  const T x2 = sqr(a.x);
  const T y2 = sqr(a.y);
  const T z2 = sqr(a.z);
  return field(a, T(-(sqr(x2) + sqr(y2) + sqr(z2) + a.p[1] * (x2 + y2 + z2) +
                      a.p[2] * (x2 * y2 + x2 * z2 + y2 * z2) + a.p[3] * a.x * a.y * a.z - 1)));
}
template <class T>
T f_lemniscate_of_gerono(const Args<T>& a) {
  return field(a, T(-(fourth(a.x) - sqr(a.x) + sqr(a.y) + sqr(a.z))));
}
template <class T>
T f_mitre(const Args<T>& a) {
  const T y2 = sqr(a.y);
  return field(a, T(-(4 * sqr(a.x) * square_sum(a) - y2 * (1 - y2 - sqr(a.z)))));
}
template <class T>
T f_nodal_cubic(const Args<T>& a) {
  return field(a, T(-(cube(a.y) + cube(a.z) - 6 * a.y * a.z)));
}
template <class T>
T f_odd(const Args<T>& a) {
  return f_cushion(a);
}
template <class T>
T f_ovals_of_cassini(const Args<T>& a) {
  const T P = sqr(a.p[1]);
  return field(a, T(-(sqr(square_sum(a) + P) - a.p[3] * P * rho2(a) - sqr(a.p[2]))));
}
template <class T>
T f_paraboloid(const Args<T>& a) {
  return field(a, T(-(sqr(a.x) - a.y + sqr(a.z))));
}
template <class T>
T f_parabolic_torus(const Args<T>& a) {
  const T P = sqr(a.p[1]);
  const T Q = sqr(a.p[2]);
  const T x2 = sqr(a.x);
  const T y2 = sqr(a.y);
  return field(a, T(-(sqr(x2) + 2 * x2 * y2 - 2 * x2 * a.z - (P + Q) * x2 + sqr(y2) - 2 * y2 * a.z +
                      (P - Q) * y2 + sqr(a.z) + (P + Q) * a.z + sqr(P - Q))));
}
template <class T>
T f_pillow(const Args<T>& a) {
  return field(a, T(fourth(a.x) + fourth(a.y) + fourth(a.z) - square_sum(a)));
}
/// The sign is that of a field strength of the other sign, unlike its neighbours.
template <class T>
T f_piriform(const Args<T>& a) {
  return -clamped(T(-a.p[0] * (fourth(a.x) - cube(a.x) + sqr(a.y) + sqr(a.z))), T(10));
}
template <class T>
T f_quartic_paraboloid(const Args<T>& a) {
  return field(a, T(-(fourth(a.x) + fourth(a.z) - a.y)));
}
template <class T>
T f_quartic_saddle(const Args<T>& a) {
  return field(a, T(-(fourth(a.x) - fourth(a.z) - a.y)));
}
template <class T>
T f_quartic_cylinder(const Args<T>& a) {
  const T r2 = rho2(a);
  const T w2 = sqr(a.p[2]);
  return field(a, T(-(r2 * sqr(a.y) + w2 * r2 - w2 * sqr(a.p[1]))));
}
template <class T>
T f_steiners_roman(const Args<T>& a) {
  const T x2 = sqr(a.x);
  const T y2 = sqr(a.y);
  const T z2 = sqr(a.z);
  return field(a, T(-(x2 * y2 + x2 * z2 + y2 * z2 + a.x * a.y * a.z)));
}
template <class T>
T f_strophoid(const Args<T>& a) {
  const T f2 = sqr(a.p[3]);
  return field(
      a, T(-((a.p[2] - a.x) * (sqr(a.y) + sqr(a.z)) - f2 * a.p[1] * sqr(a.x) - f2 * cube(a.x))));
}
template <class T>
T f_torus2(const Args<T>& a) {
  const T P = sqr(a.p[1]);
  const T Q = sqr(a.p[2]);
  return field(
      a, T(-(sqr(square_sum(a)) - 2 * (P + Q) * rho2(a) + 2 * (P - Q) * sqr(a.y) + sqr(P - Q))));
}
template <class T>
T f_torus_gumdrop(const Args<T>& a) {
  const T x2 = sqr(a.x);
  const T q = sqr(a.y) + sqr(a.z);
  return field(a, T(-(4 * (sqr(x2) + sqr(q)) + 17 * x2 * q - 20 * square_sum(a) + 17)));
}
template <class T>
T f_umbrella(const Args<T>& a) {
  return field(a, T(-(sqr(a.x) - a.y * sqr(a.z))));
}
template <class T>
T f_witch_of_agnesi(const Args<T>& a) {
  return field(a, T(-(a.p[1] * (a.y - 1) + rho2(a) * a.y)));
}

}  // namespace durer::functions::internals

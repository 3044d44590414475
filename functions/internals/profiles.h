// Plane curves swept along z, or turned about y when their switch is on (builtin-functions §1, §4).
#pragma once

#include "functions/internals/common.h"

namespace durer::functions::internals {

template <class T>
T f_algbr_cyl1(const Args<T>& a) {
  const auto [u, y] = profile(a, 2);
  const T x = abs(u);
  return -clamped(T(-a.p[0] * (cube(x) - sqr(x) + sqr(y))), a.p[1]);
}
template <class T>
T f_algbr_cyl2(const Args<T>& a) {
  const auto [x, y] = profile(a, 2);
  const T y2 = sqr(y);
  return clamped(T(-a.p[0] * (2 * fourth(x) - 3 * sqr(x) * y + y2 - 2 * cube(y) + sqr(y2))),
                 a.p[1]);
}
template <class T>
T f_algbr_cyl3(const Args<T>& a) {
  const auto [x, y] = profile(a, 2);
  const T x2 = sqr(x);
  const T y2 = sqr(y);
  return clamped(T(-a.p[0] * (sqr(x2) + x2 * y2 - 2 * x2 * y - x * y2 + y2)), a.p[1]);
}
template <class T>
T f_algbr_cyl4(const Args<T>& a) {
  const auto [x, y] = profile(a, 2);
  const T x2 = sqr(x);
  const T y2 = sqr(y);
  return clamped(T(-a.p[0] * (sqr(x2) + sqr(y2) + 2 * x2 * y2 + 3 * x2 * y - cube(y))), a.p[1]);
}
template <class T>
T f_devils_curve_2d(const Args<T>& a) {
  const auto [x, y] = profile(a, 3);
  const T x2 = sqr(x);
  const T y2 = sqr(y);
  return field(a, T(-(x2 * (x2 - sqr(a.p[1])) - y2 * (y2 - sqr(a.p[2])))));
}
template <class T>
T f_folium_surface_2d(const Args<T>& a) {
  const auto [x, y] = profile(a, 3);
  return field(a, T(-(sqr(y) * (1 + (a.p[2] - 4 * a.p[1]) * x) + sqr(x) * (1 + a.p[2]))));
}
/// The dimple is multiplied by the closeness here, not squared as in the solid of the same name.
template <class T>
T f_kampyle_of_eudoxus_2d(const Args<T>& a) {
  const auto [x, y] = profile(a, 3);
  const T x2 = sqr(x);
  const T c2 = sqr(a.p[2]);
  return field(a, T(-(sqr(y) - c2 * sqr(x2) + c2 * (a.p[1] * a.p[2]) * x2)));
}
template <class T>
T f_lemniscate_of_gerono_2d(const Args<T>& a) {
  const auto [x, y] = profile(a, 3);
  const T x2 = sqr(x);
  const T w2 = sqr(a.p[2]);
  return field(a, T(-(sqr(y) - w2 * sqr(a.p[1]) * x2 + w2 * sqr(x2))));
}
template <class T>
T f_piriform_2d(const Args<T>& a) {
  const auto [x, y] = profile(a, 4);
  const T f2 = sqr(a.p[3]);
  return field(a, T(-(sqr(y) - a.p[1] * f2 * cube(x) - a.p[2] * f2 * fourth(x))));
}
template <class T>
T f_strophoid_2d(const Args<T>& a) {
  const auto [x, y] = profile(a, 4);
  const T f2 = sqr(a.p[3]);
  return field(a, T(-((a.p[2] - x) * sqr(y) - f2 * a.p[1] * sqr(x) - f2 * cube(x))));
}
template <class T>
T f_witch_of_agnesi_2d(const Args<T>& a) {
  const auto [x, y] = profile(a, 3);
  return field(a, T(-(sqr(a.p[1]) * y + sqr(x) * y - a.p[2])));
}

}  // namespace durer::functions::internals

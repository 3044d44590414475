// Sums of exponential and polynomial humps (builtin-functions §4).
#pragma once

#include "functions/internals/common.h"

namespace durer::functions::internals {

/// Three flattened humps, one across each axis, of eccentricity p[0] and inverse size p[1].
template <class T>
struct Ellipsoids {
  T e1, e2, e3;
};
template <class T>
Ellipsoids<T> crossed_ellipsoids(const Args<T>& a) {
  const T& e = a.p[0];
  const T& k = a.p[1];
  const T x2 = sqr(a.x);
  const T y2 = sqr(a.y);
  const T z2 = sqr(a.z);
  return {exp(-k * (e * x2 + e * y2 + z2)), exp(-k * (e * x2 + y2 + e * z2)),
          exp(-k * (x2 + e * y2 + e * z2))};
}

template <class T>
T f_blob(const Args<T>& a) {
  const auto& [x, y, z, p, context] = a;
  const T one(1);
  const T around = sqr(y) + sqr(z);
  const T u = min(one, T((sqr(x + p[0] / 2) + around) * sqr(p[2])));
  const T v = min(one, T((sqr(x - p[0] / 2) + around) * sqr(p[4])));
  return -(p[1] * sqr(1 - u) + p[3] * sqr(1 - v));
}
template <class T>
T f_blob2(const Args<T>& a) {
  const auto& [x, y, z, p, context] = a;
  const T around = sqr(y) + sqr(z);
  return p[3] - p[2] * (exp(-p[1] * (sqr(x) + around)) + exp(-p[1] * (sqr(x - p[0]) + around)));
}
template <class T>
T f_cross_ellipsoids(const Args<T>& a) {
  const auto [e1, e2, e3] = crossed_ellipsoids(a);
  return a.p[3] - a.p[2] * max(max(e1, e2), e3);
}
template <class T>
T f_flange_cover(const Args<T>& a) {
  const auto [e1, e2, e3] = crossed_ellipsoids(a);
  return a.p[3] - a.p[2] * (e1 + e2 + e3);
}
template <class T>
T f_isect_ellipsoids(const Args<T>& a) {
  const auto [e1, e2, e3] = crossed_ellipsoids(a);
  return a.p[3] - a.p[2] * min(min(e1, e2), e3);
}
template <class T>
T f_spikes(const Args<T>& a) {
  const auto [e1, e2, e3] = crossed_ellipsoids(a);
  return -a.p[2] * (a.p[4] * exp(-a.p[3] * square_sum(a)) - (e1 + e2 + e3));
}
template <class T>
T f_spikes_2d(const Args<T>& a) {
  const auto& [x, y, z, p, context] = a;
  return y - p[0] * cos(p[1] * x) * cos(p[2] * z) * exp(-p[3] * rho2(a));
}

}  // namespace durer::functions::internals

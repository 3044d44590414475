// What the formulas of the internal functions share (builtin-functions §1).
#pragma once

#include "functions/number.h"

namespace durer::functions {

/// The arguments of an internal function: a point and up to ten extra parameters.
template <class T>
struct Args {
  const T& x;
  const T& y;
  const T& z;
  const T* p;
  const Context& context;
};

/// The lanes of a batch one by one, for formulas whose course depends on their parameters.
template <int extra, class F>
[[nodiscard]] Pack by_lane(const Args<Pack>& a, F f) {
  Pack r;
  for (int lane = 0; lane < Pack::lanes; ++lane) {
    double p[extra];
    for (int i = 0; i < extra; ++i) p[i] = a.p[i].v[lane];
    r.v[lane] = f(Args<double>{a.x.v[lane], a.y.v[lane], a.z.v[lane], p, a.context});
  }
  return r;
}

inline constexpr double pi = std::numbers::pi;
/// The most terms a sum with a counted parameter adds up: hostile counts must not hang a picture.
inline constexpr double max_terms = 10000;

template <class T>
[[nodiscard]] T clamped(const T& v, const T& limit) {
  return min(limit, max(v, -limit));
}
/// C(v): the polynomials times their field strength, limited so that they are flat far away.
template <class T>
[[nodiscard]] T field(const Args<T>& a, const T& v) {
  return clamped(T(a.p[0] * v), T(10));
}
template <class T>
[[nodiscard]] T cube(const T& v) {
  return v * sqr(v);
}
template <class T>
[[nodiscard]] T fourth(const T& v) {
  return sqr(sqr(v));
}
/// x² + y² + z², its root, and the distance from the y axis squared and plain.
template <class T>
[[nodiscard]] T square_sum(const Args<T>& a) {
  return sqr(a.x) + sqr(a.y) + sqr(a.z);
}
template <class T>
[[nodiscard]] T radius(const Args<T>& a) {
  return sqrt(square_sum(a));
}
template <class T>
[[nodiscard]] T rho2(const Args<T>& a) {
  return sqr(a.x) + sqr(a.z);
}
template <class T>
[[nodiscard]] T rho(const Args<T>& a) {
  return sqrt(rho2(a));
}
/// x, moved off the y axis by a hair where the point lies on it, for angles about that axis.
template <class T>
[[nodiscard]] T x_off_axis(const Args<T>& a, double hair) {
  return where(both(eq(a.x, T(0)), eq(a.z, T(0))), T(hair), a.x);
}

/// Plane coordinates of a curve that is swept along z or, with the switch on, turned about y.
template <class T>
struct Profile {
  T x, y;
};
/// Switch, offset and angle in degrees are p[first], p[first + 1], p[first + 2].
template <class T>
[[nodiscard]] Profile<T> profile(const Args<T>& a, int first) {
  return {lazily(lt(T(0), a.p[first]),
                 [&] {
                   const T angle = a.p[first + 2] * (pi / 180);
                   return T((rho(a) - a.p[first + 1]) * cos(angle) - a.y * sin(angle));
                 },
                 [&] { return a.x; }),
          lazily(lt(T(0), a.p[first]),
                 [&] {
                   const T angle = a.p[first + 2] * (pi / 180);
                   return T(a.y * cos(angle) + (rho(a) - a.p[first + 1]) * sin(angle));
                 },
                 [&] { return a.y; })};
}

/// Distance from the middle of a cross section: round for c = 1, square for 0, rounded between.
template <class T>
[[nodiscard]] T cross_section(const T& u, const T& v, const T& c) {
  return lazily(
      eq(c, T(1)), [&] { return T(sqrt(sqr(u) + sqr(v))); },
      [&] {
        return lazily(
            eq(c, T(0)), [&] { return T(max(abs(u), abs(v))); },
            [&] { return T(pow(pow(abs(u), 2 / c) + pow(abs(v), 2 / c), c * 0.5)); });
      });
}

}  // namespace durer::functions

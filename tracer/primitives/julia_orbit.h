// Orbits of Julia sets, over the kind of number that they are followed with: one point, or several.
// What is not needed to tell where an orbit goes is left out.
#pragma once

#include "functions/simd/inline.h"
#include "tracer/primitives/julia_set.h"

namespace durer::tracer {

/// A quaternion, seen from where squares and cubes do: its real part, the squared length of its
/// imaginary part i, and i · c.
template <class T>
struct QuaternionOrbit {
  T x, v, d;

  /// What one step needs to know of the parameter.
  struct Rule {
    T c;  // its real part
    T k;  // squared length of the imaginary part
    explicit DURER_INLINE Rule(const JuliaSet& set)
        : c(set.c.x), k(set.c.y * set.c.y + set.c.z * set.c.z + set.c.w * set.c.w) {}
  };
  /// From a point of the slice.
  static DURER_INLINE QuaternionOrbit start(const JuliaSet& set, const T& x, const T& y, const T& z,
                                            const T& w) {
    return {x, y * y + z * z + w * w, y * set.c.y + z * set.c.z + w * set.c.w};
  }
  [[nodiscard]] DURER_INLINE T norm2() const { return x * x + v; }

  /// What steps depend on: the product of the squared norms before.
  using Product = T;
  [[nodiscard]] DURER_INLINE Product first_product() const { return T(1); }
  [[nodiscard]] DURER_INLINE Product multiplied(const Product& p, const T& n2, std::uint32_t) const {
    return p * n2;
  }

  DURER_INLINE void square(const Rule& r) {
    const T x2 = x * x;
    const T p = (x + x) * d;
    const T m = x2 * 4.0 * v;
    x = (x2 - v) + r.c;
    turn(r, p, m);
  }
  DURER_INLINE void cube(const Rule& r) {
    const T x2 = x * x;
    const T f = x2 * 3.0 - v;
    const T p = f * d;
    const T m = f * f * v;
    x = x * (x2 - v * 3.0) + r.c;
    turn(r, p, m);
  }

 private:
  /// The imaginary part i becomes f i + that of the parameter; p = f d, m = f² v.
  DURER_INLINE void turn(const Rule& r, const T& p, const T& m) {
    d = p + r.k;
    v = m + (p + d);
  }
};

/// A hypercomplex number: a pair of complex ones, which are multiplied one by one.
template <class T>
struct HypercomplexOrbit {
  T ax, ay, bx, by;

  using Rule = HypercomplexOrbit;
  static DURER_INLINE Rule rule(const JuliaSet& set) {
    return {T(set.c.x - set.c.w), T(set.c.y + set.c.z), T(set.c.x + set.c.w), T(set.c.y - set.c.z)};
  }
  static DURER_INLINE HypercomplexOrbit start(const JuliaSet&, const T& x, const T& y, const T& z,
                                              const T& w) {
    return {x - w, y + z, x + w, y - z};
  }
  [[nodiscard]] DURER_INLINE T norm2() const {
    return ((ax * ax + ay * ay) + (bx * bx + by * by)) * 0.5;
  }

  /// What steps depend on: the product of the numbers before, the second not counted twice.
  using Product = HypercomplexOrbit;
  [[nodiscard]] DURER_INLINE Product first_product() const { return *this; }
  [[nodiscard]] DURER_INLINE Product multiplied(const Product& p, const T&, std::uint32_t i) const {
    return i > 0 ? p.times(*this) : p;
  }
  DURER_INLINE void square(const Rule& r) {
    const T ap = (ax + ax) * ay;
    const T bp = (bx + bx) * by;
    ax = (ax * ax - ay * ay) + r.ax;
    bx = (bx * bx - by * by) + r.bx;
    ay = ap + r.ay;
    by = bp + r.by;
  }
  DURER_INLINE HypercomplexOrbit times(const HypercomplexOrbit& o) const {
    return {ax * o.ax - ay * o.ay, ax * o.ay + ay * o.ax, bx * o.bx - by * o.by,
            bx * o.by + by * o.bx};
  }
};
/// Its four components.
[[nodiscard]] inline Four four(const HypercomplexOrbit<double>& q) {
  return {0.5 * (q.ax + q.bx), 0.5 * (q.ay + q.by), 0.5 * (q.ay - q.by), 0.5 * (q.bx - q.ax)};
}

/// Calls f(orbit, step) for the orbit of a point of the slice; step(orbit) takes it one step on.
template <class T, class F>
DURER_INLINE auto with_orbit(const JuliaSet& set, const T& x, const T& y, const T& z, F f) {
  const T w = x * set.slice.x + y * set.slice.y + z * set.slice.z + set.slice_at;
  if (set.hypercomplex) {  // whose cube is a square in the oracle
    using Orbit = HypercomplexOrbit<T>;
    const typename Orbit::Rule rule = Orbit::rule(set);
    return f(Orbit::start(set, x, y, z, w),
             [&](Orbit& q) DURER_LAMBDA_INLINE { q.square(rule); });
  }
  using Orbit = QuaternionOrbit<T>;
  const typename Orbit::Rule rule(set);
  const Orbit start = Orbit::start(set, x, y, z, w);
  if (set.function == JuliaFunction::sqr) {
    return f(start, [&](Orbit& q) DURER_LAMBDA_INLINE { q.square(rule); });
  }
  return f(start, [&](Orbit& q) DURER_LAMBDA_INLINE { q.cube(rule); });
}

}  // namespace durer::tracer

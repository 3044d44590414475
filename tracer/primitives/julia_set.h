// Julia sets in four dimensions, as the oracle iterates them (objects §10.12).
#pragma once

#include <complex>
#include <cstdint>

#include "base/vec.h"

namespace durer::tracer {

/// A quaternion or a hypercomplex number.
struct Four {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 0;

  friend Four operator+(Four a, Four b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
};
[[nodiscard]] inline double norm2(Four q) { return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w; }

/// In the order of the language's words, see interpreter/fractals.cpp.
enum class JuliaFunction : std::uint8_t {
  sqr,
  cube,
  exp,
  reciprocal,
  sin,
  asin,
  sinh,
  asinh,
  cos,
  acos,
  cosh,
  acosh,
  tan,
  atan,
  tanh,
  atanh,
  ln,
  pwr
};

/// The points from which iterating q := f(q) + c does not escape.
struct JuliaSet {
  Four c;
  bool hypercomplex = false;
  JuliaFunction function = JuliaFunction::sqr;
  std::complex<double> power;
  std::uint32_t iterations = 20;
  double smallest_step = 0.05;
  dvec3 slice{0.0};  // w = slice · p + slice_at: the space that is shown
  double slice_at = 0;
  double radius = 2;   // all of the set lies within
  double escape2 = 4;  // squared norm from which there is no return

  [[nodiscard]] Four at(dvec3 p) const {
    return {p.x, p.y, p.z, slice.x * p.x + slice.y * p.y + slice.z * p.z + slice_at};
  }
  [[nodiscard]] bool contains(dvec3 p) const;
  /// How far one may go from p in the unit direction d; none where p is inside.
  struct Look {
    bool inside;
    double step;
  };
  [[nodiscard]] Look look(dvec3 p, dvec3 d) const;
  /// True if the function multiplies only: julia_orbit.h and julia_lanes.h are for these.
  [[nodiscard]] bool is_polynomial() const {
    return function == JuliaFunction::sqr || function == JuliaFunction::cube;
  }
  /// The step where an orbit of quaternions escapes after `i` steps, with squared norm n2; product2 is
  /// that of the squared norms before.
  [[nodiscard]] double step_quaternion(std::uint32_t i, double product2, double n2) const;
  /// The same for hypercomplex numbers, `product` being that of the factors before.
  [[nodiscard]] double step_hypercomplex(std::uint32_t i, Four product, Four q, dvec3 d) const;
  /// Out of the set, any length.
  [[nodiscard]] dvec3 normal(dvec3 p) const;

 private:
  [[nodiscard]] Four start(dvec3 p) const;
  [[nodiscard]] Look look_function(Four q, dvec3 d) const;
  [[nodiscard]] dvec3 normal_quaternion(Four q) const;
  [[nodiscard]] Four next(Four q) const;
  [[nodiscard]] Four factor(Four q) const;
};

}  // namespace durer::tracer

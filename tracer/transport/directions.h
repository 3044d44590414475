// Random directions, and how dense they are, per steradian.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/vec.h"

namespace durer::tracer {

/// The unit direction at an angle to the unit vector `axis`, turned about it by `phi` radians.
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6 (1), 2017.
[[nodiscard]] inline dvec3 direction_about(dvec3 axis, double cosine, double phi) {
  const double sign = std::copysign(1.0, axis.z);
  const double a = -1 / (sign + axis.z);
  const double b = axis.x * axis.y * a;
  const dvec3 x(1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
  const dvec3 y(b, sign + axis.y * axis.y * a, -axis.y);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return sine * std::cos(phi) * x + sine * std::sin(phi) * y + cosine * axis;
}

/// Density (e + 1) / 2π · cos^e about an axis: 1 is Lambert's law.
[[nodiscard]] inline double power_density(double cosine, double exponent) {
  if (cosine <= 0) return 0;
  return (exponent + 1) / (2 * std::numbers::pi) * std::pow(cosine, exponent);
}
[[nodiscard]] inline dvec3 power_direction(dvec3 axis, double exponent, dvec2 u) {
  return direction_about(axis, std::pow(1 - u.x, 1 / (exponent + 1)), 2 * std::numbers::pi * u.y);
}

/// Alike in all directions: density 1 / 4π.
inline constexpr double sphere_density = 1 / (4 * std::numbers::pi);
[[nodiscard]] inline dvec3 sphere_direction(dvec2 u) {
  return direction_about({0, 0, 1}, 1 - 2 * u.x, 2 * std::numbers::pi * u.y);
}

}  // namespace durer::tracer

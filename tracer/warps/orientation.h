// What the warps share that wrap a plane around a body (textures §4.3).
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tracer/warps/warp_type.h"

namespace durer::tracer::warps {

/// The angle of (x, z) about the y axis, 0…2π, from the x axis towards z.
[[nodiscard]] inline double angle_about_y(double x, double z) {
  if (z == 0) return x > 0 ? 0 : std::numbers::pi;
  const double a = std::acos(x / std::sqrt(x * x + z * z));
  return z > 0 ? a : 2 * std::numbers::pi - a;
}

/// Where the plane's coordinates (u, v, w) go if w is to be the direction `to`.
[[nodiscard]] inline dvec3 oriented(dvec3 p, dvec3 to) {
  if (to == dvec3(0, 0, 1)) return p;
  return {to.x * p.z + (to.y + to.z) * p.x, (to.x + to.z) * p.y - to.y * p.z,
          -to.x * p.x + to.y * p.y + to.z * p.z};
}

/// How much the plane grows at a distance.
[[nodiscard]] inline double distance_scale(double distance, float exponent) {
  return exponent == 0 ? 1 : std::pow(distance, static_cast<double>(exponent));
}

/// `orientation` and `dist_exp`.
struct Wrapping {
  dvec3 orientation{0, 0, 1};
  float dist_exp = 0;

  void prepare() { orientation = glm::normalize(orientation); }

 protected:
  [[nodiscard]] dvec3 wrapped(double u, double v, double distance) const {
    return oriented({u, v, distance}, orientation);
  }
  [[nodiscard]] double scale(double distance) const { return distance_scale(distance, dist_exp); }
};

}  // namespace durer::tracer::warps

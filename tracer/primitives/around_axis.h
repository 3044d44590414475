// Surfaces of revolution around the y axis: where a line is, and what it meets, as seen from there.
#pragma once

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/ray.h"
#include "base/vec.h"

namespace durer::tracer {

/// The angle around the y axis as a part of the whole turn, [0, 1) (objects §14).
[[nodiscard]] inline double turn_around_y(dvec3 p) {
  if (p.x * p.x + p.z * p.z <= epsilon) return 0;
  const double turn = std::atan2(p.z, p.x) / (2 * std::numbers::pi);
  return turn < 0 ? turn + 1 : turn;
}

/// A line, measured from its point nearest to the y axis: there the distance from the axis grows
/// with the square of s, and nothing is lost if the ray begins far away. s is t - middle.
struct LineAroundY {
  double middle;   // t of the nearest point
  double y;        // its height
  double near2;    // its squared distance from the axis
  double across2;  // squared distance from the axis: near2 + across2 · s²
  double up;       // height: y + up · s

  explicit LineAroundY(const Ray& ray) {
    across2 = ray.d.x * ray.d.x + ray.d.z * ray.d.z;
    up = ray.d.y;
    const bool upright = across2 <= 1e-20 * up * up;
    if (upright) across2 = 0;
    middle = upright ? -ray.o.y / up : -(ray.o.x * ray.d.x + ray.o.z * ray.d.z) / across2;
    y = ray.o.y + middle * up;
    const double beside = ray.o.x * ray.d.z - ray.o.z * ray.d.x;
    near2 = upright ? ray.o.x * ray.o.x + ray.o.z * ray.o.z : beside * beside / across2;
  }
  [[nodiscard]] double distance2(double s) const { return near2 + across2 * s * s; }
  /// True if the line is as good as level.
  [[nodiscard]] bool level() const { return up * up <= 1e-12 * across2; }
};

}  // namespace durer::tracer

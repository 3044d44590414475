// Canonical frames of round primitives.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "base/transform.h"

namespace durer::tracer {

/// The map that scales the plane across the z axis by `across` and lengths along it by `along`,
/// turns z to `axis` (unit) by the shortest way, and moves the origin to `base`. Its inverse is
/// exact, not computed. Scales must not be 0. Bounding boxes show that the oracle turns this way.
inline Transform frame_along(dvec3 base, dvec3 axis, double across, double along) {
  const double off2 = axis.x * axis.x + axis.y * axis.y;
  const bool parallel = std::abs(axis.z) > 1 - epsilon || off2 == 0;
  const double f = parallel ? 0 : (1 - axis.z) / off2;  // 1 / (1 + z), without its cancellation
  const dvec3 u = parallel ? dvec3(1, 0, 0)
                           : dvec3(axis.z + axis.y * axis.y * f, -axis.x * axis.y * f, -axis.x);
  const dvec3 v = parallel ? glm::cross(axis, u)
                           : dvec3(-axis.x * axis.y * f, axis.z + axis.x * axis.x * f, -axis.y);
  Transform m;
  m.forward = {u * across, v * across, axis * along, base};
  Affine& back = m.backward;
  back.x = {u.x / across, v.x / across, axis.x / along};
  back.y = {u.y / across, v.y / across, axis.y / along};
  back.z = {u.z / across, v.z / across, axis.z / along};
  back.t = -back.vector(base);
  return m;
}

}  // namespace durer::tracer

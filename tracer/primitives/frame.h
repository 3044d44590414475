// Canonical frames of round primitives.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "base/transform.h"

namespace durer::tracer {

/// The map that takes the z axis to `axis` (unit), scales the plane across it by `across` and
/// lengths along it by `along`, and the origin to `base`. Its inverse is exact, not computed.
/// Scales must not be 0; they may be negative.
inline Transform frame_along(dvec3 base, dvec3 axis, double across, double along) {
  // The world axis farthest from `axis` gives a well-conditioned perpendicular.
  const dvec3 a = glm::abs(axis);
  const dvec3 helper = a.x <= a.y && a.x <= a.z ? dvec3(1, 0, 0)
                       : a.y <= a.z             ? dvec3(0, 1, 0)
                                                : dvec3(0, 0, 1);
  const dvec3 u = glm::normalize(glm::cross(helper, axis));
  const dvec3 v = glm::cross(axis, u);
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

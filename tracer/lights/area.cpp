// Lamps of some extent: where their samples are (shading §6.6).
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/lights/light.h"

namespace durer::tracer {
// A lamp that turns has edges of one length at right angles to `l`.
AreaGrid::AreaGrid(const scene::LightArea& a, dvec3 l) : area(&a), u_axis(a.u), v_axis(a.v) {
  if (!a.orient) return;
  const dvec3 aside = std::abs(std::abs(l.z) - 1) < 0.01 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  const dvec3 x = glm::normalize(glm::cross(l, aside));
  const dvec3 y = glm::normalize(glm::cross(l, x));
  const double length = glm::length(a.u);
  u_axis = length * x;
  v_axis = length * y;
}

dvec2 AreaGrid::reach() const {
  // Jitter moves samples by half a step, circles by the shift of their middle.
  const auto along_side = [this](int samples) {
    if (samples < 2) return area->circular ? 0.001 : 0.0;
    return 0.501 + (area->jitter ? 0.5 / (samples - 1) : 0);
  };
  return {along_side(area->n1), along_side(area->n2)};
}

}  // namespace durer::tracer

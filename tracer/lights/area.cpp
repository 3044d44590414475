// Lamps of some extent: where their samples are (shading §6.6).
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "tracer/lights/light.h"

namespace durer::tracer {
namespace {

// -1/2…1/2 along one side; a single sample is in the middle.
double along(double index, int samples) { return samples > 1 ? index / (samples - 1) - 0.5 : 0; }

// The edges of the area; a lamp that turns has edges of one length at right angles to `l`.
std::pair<dvec3, dvec3> axes(const scene::LightArea& area, dvec3 l) {
  if (!area.orient) return {area.u, area.v};
  const dvec3 aside = std::abs(std::abs(l.z) - 1) < 0.01 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  const dvec3 x = glm::normalize(glm::cross(l, aside));
  const dvec3 y = glm::normalize(glm::cross(l, x));
  const double length = glm::length(area.u);
  return {length * x, length * y};
}

}  // namespace

dvec3 area_offset(const scene::LightArea& area, double u, double v, dvec3 l) {
  double a = along(u, area.n1);
  double b = along(v, area.n2);
  if (area.circular) {
    // Squares become circles. The middle is moved a little, where there is no direction.
    a += 0.001;
    b += 0.001;
    const double scale = std::max(std::abs(a), std::abs(b)) / std::sqrt(a * a + b * b);
    a *= scale;
    b *= scale;
  }
  const auto [u_axis, v_axis] = axes(area, l);
  return a * u_axis + b * v_axis;
}

AreaExtent area_extent(const scene::LightArea& area, dvec3 l) {
  // Jitter moves samples by half a step, circles by the shift of their middle.
  const auto reach = [&](int samples) {
    if (samples < 2) return area.circular ? 0.001 : 0.0;
    return 0.501 + (area.jitter ? 0.5 / (samples - 1) : 0);
  };
  const auto [u_axis, v_axis] = axes(area, l);
  return {reach(area.n1) * u_axis, reach(area.n2) * v_axis};
}

}  // namespace durer::tracer

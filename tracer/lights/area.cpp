// Lamps of some extent: where their samples are (shading §6.6).
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/lights/light.h"

namespace durer::tracer {
namespace {

// -1/2…1/2 along one side; a single sample is in the middle.
double along(double index, int samples) { return samples > 1 ? index / (samples - 1) - 0.5 : 0; }

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
  if (!area.orient) return a * area.u + b * area.v;
  const dvec3 aside = std::abs(std::abs(l.z) - 1) < 0.01 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  const dvec3 x = glm::normalize(glm::cross(l, aside));
  const dvec3 y = glm::normalize(glm::cross(l, x));
  return glm::length(area.u) * (a * x + b * y);
}

}  // namespace durer::tracer

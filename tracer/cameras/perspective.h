#pragma once

#include <glm/geometric.hpp>

#include "base/ray.h"
#include "scene/scene.h"

namespace durer::tracer {

/// All rays start at one point (shading §2.4).
struct PerspectiveCamera {
  static constexpr bool one_origin = true;

  explicit PerspectiveCamera(const scene::Camera& c)
      : location(c.location), direction(c.direction), right(c.right), up(c.up) {}

  /// u to the right, v upwards, both -1/2…1/2 over the whole picture.
  [[nodiscard]] Ray ray(double u, double v) const {
    return {location, glm::normalize(direction + u * right + v * up)};
  }

  dvec3 location;
  dvec3 direction;
  dvec3 right;
  dvec3 up;
};

}  // namespace durer::tracer

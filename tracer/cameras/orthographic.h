#pragma once

#include <glm/geometric.hpp>

#include "base/ray.h"
#include "scene/scene.h"

namespace durer::tracer {

/// All rays are parallel (shading §2.4).
struct OrthographicCamera {
  static constexpr bool one_origin = false;

  explicit OrthographicCamera(const scene::Camera& c)
      : location(c.location), direction(glm::normalize(c.direction)), right(c.right), up(c.up) {}

  /// u to the right, v upwards, both -1/2…1/2 over the whole picture.
  [[nodiscard]] Ray ray(double u, double v) const {
    return {location + u * right + v * up, direction};
  }

  dvec3 location;
  dvec3 direction;  // unit
  dvec3 right;
  dvec3 up;
};

}  // namespace durer::tracer

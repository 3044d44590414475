#pragma once

#include <array>
#include <glm/geometric.hpp>

#include "base/ray.h"
#include "functions/evaluate.h"
#include "scene/scene.h"

namespace durer::tracer {

/// Rays begin where three functions of the place in the picture say, and go where three others say
/// (shading §12). Functions that are missing are those of a perspective camera.
class UserDefinedCamera {
 public:
  static constexpr bool one_origin = false;

  UserDefinedCamera(const scene::Camera& c, functions::NoiseGenerator noise)
      : camera_(&c) {
    workspace_.context.noise_generator = noise;
  }

  /// u to the right, v upwards, both -1/2…1/2 over the whole picture. Where the functions give no
  /// direction the ray sees nothing.
  [[nodiscard]] Ray ray(double u, double v) {
    const scene::Camera& c = *camera_;
    Ray ray{c.location, c.direction + u * c.right + v * c.up};
    if (c.location_functions[0] != nullptr) {
      ray.o = c.transform->point(at(c.location_functions, u, v));
    }
    if (c.direction_functions[0] != nullptr) {
      ray.d = c.transform->vector(at(c.direction_functions, u, v));
    }
    ray.d = glm::normalize(ray.d);
    return ray;
  }

 private:
  [[nodiscard]] dvec3 at(const std::array<functions::FunctionRef, 3>& f, double u, double v) {
    const std::array place{u, v};
    return {functions::evaluate(*f[0], place, workspace_),
            functions::evaluate(*f[1], place, workspace_),
            functions::evaluate(*f[2], place, workspace_)};
  }

  const scene::Camera* camera_;
  functions::Workspace workspace_;
};

}  // namespace durer::tracer

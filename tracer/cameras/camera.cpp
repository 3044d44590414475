#include "tracer/cameras/camera.h"

#include <array>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace durer::tracer {

namespace cameras {
#define DURER_ENTRY(name) extern const CameraType name##_camera;
#include "scene/cameras.def"
#undef DURER_ENTRY
}  // namespace cameras

const CameraType& camera_type(scene::Camera::Kind kind) {
  static constexpr std::array types{
#define DURER_ENTRY(name) &cameras::name##_camera,
#include "scene/cameras.def"
#undef DURER_ENTRY
  };
  return *types[static_cast<std::size_t>(kind)];
}

Camera::Camera(const scene::Camera& c)
    : type(&camera_type(c.kind)),
      in(&c),
      unit_right(glm::normalize(c.right)),
      unit_up(glm::normalize(c.up)),
      unit_direction(glm::normalize(c.direction)),
      width(glm::length(c.right)),
      height(glm::length(c.up)),
      angle(glm::radians(c.angle_deg)),
      vertical_angle(glm::radians(c.vertical_angle_deg)) {}

}  // namespace durer::tracer

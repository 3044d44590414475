// The written state of a camera (shading §2.1).
#pragma once

#include <optional>
#include <string>

#include "base/transform.h"
#include "scene/scene.h"

namespace durer::interpreter {

/// What the items of `camera { … }` say. Angle, look_at and transformations are worked out at the
/// end, whatever their order (shading §2.2).
struct CameraSpec {
  scene::Camera::Kind kind = scene::Camera::Kind::perspective;
  dvec3 location{0.0};
  dvec3 direction{0, 0, 1};
  dvec3 right{1.33, 0, 0};
  dvec3 up{0, 1, 0};
  dvec3 sky{0, 1, 0};
  std::optional<dvec3> look_at;
  std::optional<double> angle_deg;
  std::optional<double> vertical_angle_deg;  // spherical
  int cylinder_type = 1;
  bool right_or_up_given = false;
  std::optional<dvec3> focal_point;
  Boxed<scene::Lens> lens;
  Boxed<scene::Normal> normal;
  Boxed<scene::MeshCamera> mesh;
  Transform transform;
  std::array<functions::FunctionRef, 3> location_functions;
  std::array<functions::FunctionRef, 3> direction_functions;
  scene::OriginId origin = 0;
  Span span;
};

}  // namespace durer::interpreter

// From a place in the picture to the ray that looks there (shading §2).
#pragma once

#include "base/ray.h"
#include "functions/evaluate.h"
#include "scene/camera.h"

namespace durer::tracer {

/// A place in the picture.
struct PictureSpot {
  double u = 0;  // -1/2…1/2 over the whole picture, to the right
  double v = 0;  // -1/2…1/2, upwards
  double x = 0;  // the same in pixels: whole numbers are their centres, y goes down
  double y = 0;
  int width = 1;  // of the picture, pixels
  int height = 1;
  int turn = 0;  // which of several rays
};

struct CameraRay {
  Ray ray;           // of any length
  dvec2 plane{0.0};  // where the camera's own bumps are looked up
};

struct Camera;

/// What makes a kind of camera; one file each, listed in scene/cameras.def.
struct CameraType {
  /// False: there is no ray, and nothing is seen.
  bool (*ray)(const Camera& camera, const PictureSpot& spot, functions::Workspace& workspace,
              CameraRay& out);
  bool one_origin = true;  // all rays start at the camera's location
};

[[nodiscard]] const CameraType& camera_type(scene::Camera::Kind kind);

/// Of a pinhole.
inline void perspective_ray(const scene::Camera& camera, double u, double v, CameraRay& out) {
  const dvec3 d = camera.direction + u * camera.right + v * camera.up;
  out.ray.o = camera.location;
  out.ray.d.x = d.x;
  out.ray.d.y = d.y;
  out.ray.d.z = d.z;
  out.plane.x = u;
  out.plane.y = v;
}

/// A camera with everything worked out that does not depend on the place. `in` must outlive it.
struct Camera {
  explicit Camera(const scene::Camera& in);

  [[nodiscard]] bool ray(const PictureSpot& spot, functions::Workspace& workspace,
                         CameraRay& out) const {
    if (in->kind == scene::Camera::Kind::perspective) {  // by far the most
      perspective_ray(*in, spot.u, spot.v, out);
      return true;
    }
    return type->ray(*this, spot, workspace, out);
  }
  /// A direction in the camera's own axes, which need not be at right angles.
  [[nodiscard]] dvec3 along(double across, double upwards, double ahead) const {
    return across * unit_right + upwards * unit_up + ahead * unit_direction;
  }

  const CameraType* type;
  const scene::Camera* in;
  dvec3 unit_right;
  dvec3 unit_up;
  dvec3 unit_direction;
  double width;   // length of `right`
  double height;  // length of `up`
  double angle;   // radians
  double vertical_angle;
};

}  // namespace durer::tracer

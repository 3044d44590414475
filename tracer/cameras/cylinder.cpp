// The picture is part of a cylinder around the camera: upright (1, 3) or lying (2, 4), seen from a
// point (1, 2) or at right angles to its axis (3, 4).
#include <cmath>

#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  const bool upright = c.in->cylinder_type % 2 == 1;
  const bool from_axis = c.in->cylinder_type > 2;
  const double a = upright ? at.u * c.angle : at.u * c.width;
  const double b = upright ? at.v * c.height : at.v * c.angle;
  out.plane = {a, b};
  const dvec3 along_axis = upright ? b * c.unit_up : a * c.unit_right;
  out.ray = {c.in->location, upright ? c.along(std::sin(a), 0, std::cos(a))
                                     : c.along(0, std::sin(b), std::cos(b))};
  (from_axis ? out.ray.o : out.ray.d) += along_axis;
  return true;
}

}  // namespace

extern constinit const CameraType cylinder_camera{ray, false};

}  // namespace durer::tracer::cameras

// Angles are proportional to distances along both axes.
#include <cmath>

#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  const double a = at.u * c.angle;
  const double b = at.v * c.angle * c.height / c.width;
  out = {{c.in->location, c.along(std::sin(a), std::sin(b), std::cos(a) * std::cos(b))}, {a, b}};
  return true;
}

}  // namespace

extern constinit const CameraType ultra_wide_angle_camera{ray};

}  // namespace durer::tracer::cameras

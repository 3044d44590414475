// Half a turn, whatever the angle; upwards it is the tangent that is seen.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  constexpr double infinitely_high = 2e10;
  const scene::Camera& in = *c.in;
  const double a = (0.5 - at.u) * std::numbers::pi;
  const double b = std::numbers::pi * at.v;
  double height = std::tan(b);
  if (std::abs(std::numbers::pi / 2 - std::abs(b)) < epsilon) height = b > 0 ? infinitely_high : -infinitely_high;
  out = {{in.location, std::cos(a) * in.right + height * in.up + std::sin(a) * in.direction},
         {a, b}};
  return true;
}

}  // namespace

extern constinit const CameraType panoramic_camera{ray};

}  // namespace durer::tracer::cameras

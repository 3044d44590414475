// Rays begin where three functions of the place in the picture say, and go where three others say
// (shading §12). Functions that are missing are those of a perspective camera.
#include <array>

#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

using Functions = std::array<functions::FunctionRef, 3>;

dvec3 value(const Functions& f, const PictureSpot& at, functions::Workspace& workspace) {
  const std::array place{at.u, at.v};
  return {functions::evaluate(*f[0], place, workspace), functions::evaluate(*f[1], place, workspace),
          functions::evaluate(*f[2], place, workspace)};
}

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace& workspace, CameraRay& out) {
  const scene::Camera& in = *c.in;
  out = {{in.location, in.direction + at.u * in.right + at.v * in.up}, {at.u, at.v}};
  if (in.location_functions[0] != nullptr) {
    out.ray.o = in.transform->point(value(in.location_functions, at, workspace));
  }
  if (in.direction_functions[0] != nullptr) {
    out.ray.d = in.transform->vector(value(in.direction_functions, at, workspace));
  }
  return true;
}

}  // namespace

extern constinit const CameraType user_defined_camera{ray, false};

}  // namespace durer::tracer::cameras

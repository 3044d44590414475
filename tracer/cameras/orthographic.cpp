// All rays are parallel.
#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  const scene::Camera& in = *c.in;
  out = {{in.location + at.u * in.right + at.v * in.up, in.direction}, {at.u, at.v}};
  return true;
}

}  // namespace

extern constinit const CameraType orthographic_camera{ray, false};

}  // namespace durer::tracer::cameras

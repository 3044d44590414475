// A pinhole.
#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  const scene::Camera& in = *c.in;
  out = {{in.location, in.direction + at.u * in.right + at.v * in.up}, {at.u, at.v}};
  return true;
}

}  // namespace

extern constinit const CameraType perspective_camera{ray};

}  // namespace durer::tracer::cameras

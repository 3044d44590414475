// A pinhole.
#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  perspective_ray(*c.in, at.u, at.v, out);
  return true;
}

}  // namespace

extern constinit const CameraType perspective_camera{ray};

}  // namespace durer::tracer::cameras

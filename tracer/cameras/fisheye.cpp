// Angles from the centre are proportional to distances in the picture; outside of the circle there is
// nothing.
#include "tracer/cameras/dome.h"
#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  const DomePoint p = dome_point(2 * at.u * c.width, 2 * at.v * c.height);
  if (p.radius > 1) return false;
  out = dome_ray(c, p, p.radius * c.angle / 2);
  return true;
}

}  // namespace

extern constinit const CameraType fisheye_camera{ray};

}  // namespace durer::tracer::cameras

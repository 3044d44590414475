// For domes of cinemas: a fisheye that is cut off below (shading §2.4). The constants describe their
// lens.
#include "tracer/cameras/dome.h"
#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  constexpr double aspect_of_film = 1.283458;
  const double aspect = c.width / c.height;
  double a = 2 * at.u;
  double b = 2 * at.v;
  if (aspect > aspect_of_film) {
    a *= aspect / aspect_of_film;
    b = (b - 1) / aspect_of_film + 1;
  } else if (aspect > 1) {
    b = (b - 1) / aspect + 1;
  } else {
    b /= aspect;
  }
  const DomePoint p = dome_point(a, b);
  if (p.radius > 1) return false;
  const double r = p.radius;
  if (r > 1) return false;
  const double tilt = r * (1.411269 + r * r * (-0.09439 + r * r * 0.25674));
  const double lowest = std::tan(0.75 * std::numbers::pi) * std::cos(tilt);
  if (std::sin(p.around) * std::sin(tilt) < lowest) return false;
  out = dome_ray(c, p, tilt);
  return true;
}

}  // namespace

extern constinit const CameraType omnimax_camera{ray};

}  // namespace durer::tracer::cameras

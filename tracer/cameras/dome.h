// What fisheye and omnimax share: the picture as a disc, its centre straight ahead.
#pragma once

#include <cmath>
#include <numbers>

#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {

/// Polar coordinates of a point of the disc.
struct DomePoint {
  double radius = 0;
  double around = 0;  // radians, from the right upwards
};

inline DomePoint dome_point(double a, double b) {
  const double radius = std::sqrt(a * a + b * b);
  if (radius == 0) return {};
  const double up = std::asin(b / radius);
  return {radius, a >= 0 ? up : std::numbers::pi - up};
}

/// The ray that is `tilt` radians off the centre.
inline CameraRay dome_ray(const Camera& c, const DomePoint& p, double tilt) {
  const double s = std::sin(tilt);
  return {{c.in->location,
           c.along(std::cos(p.around) * s, std::sin(p.around) * s, std::cos(tilt))},
          {p.around, tilt}};
}

}  // namespace durer::tracer::cameras

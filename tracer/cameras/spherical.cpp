// Longitude and latitude: a full turn by half a one, or whatever the angles say.
#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

dvec3 turned(dvec3 v, dvec3 axis, double angle) {
  const double c = std::cos(angle);
  return c * v + std::sin(angle) * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis;
}

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  const double longitude = at.u * c.angle;
  const double latitude = at.v * c.vertical_angle;
  const dvec3 up = turned(c.in->direction, c.unit_right, -latitude);
  out = {{c.in->location, turned(up, c.unit_up, longitude)}, {longitude, latitude}};
  return true;
}

}  // namespace

extern constinit const CameraType spherical_camera{ray};

}  // namespace durer::tracer::cameras

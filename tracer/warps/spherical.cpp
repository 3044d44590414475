#include "tracer/warps/orientation.h"

namespace durer::tracer::warps {
namespace {

// The plane around the origin: x goes round, y from pole to pole, z is the distance (textures §4.3).
struct Spherical : Wrapping {
  static constexpr std::array operands{
      keyword<&Spherical::orientation>("orientation", "side of the plane that lies outside"),
      keyword<&Spherical::dist_exp>("dist_exp", "how the distance scales the plane"),
  };
  dvec3 operator()(dvec3 p) const {
    const double r = glm::length(p);
    if (r == 0) return p;
    const dvec3 q = p / r;
    const bool pole = q.x == 0 && q.z == 0;
    const double u = pole ? 0 : angle_about_y(q.x, q.z) / (2 * std::numbers::pi);
    const double v = 0.5 + std::asin(q.y) / std::numbers::pi;
    const double s = scale(r);
    return wrapped(u * s, v * s, r);
  }
};

}  // namespace

extern constinit const WarpType spherical_warp =
    describe_warp<Spherical>("spherical", "Wraps a plane around a sphere.");

}  // namespace durer::tracer::warps

#include "tracer/warps/orientation.h"

namespace durer::tracer::warps {
namespace {

// The plane around a ring about the y axis (textures §4.3).
struct Toroidal {
  dvec3 orientation{0, 0, 1};
  float dist_exp = 0;
  float major_radius = 1;

  static constexpr std::array operands{
      keyword<&Toroidal::orientation>("orientation", "side of the plane that lies outside"),
      keyword<&Toroidal::dist_exp>("dist_exp", "how the distance scales the plane"),
      keyword<&Toroidal::major_radius>("major_radius", "radius of the ring"),
  };
  void prepare() { orientation = glm::normalize(orientation); }

  dvec3 operator()(dvec3 p) const {
    const double axis = std::sqrt(p.x * p.x + p.z * p.z);
    if (axis == 0) return p;
    const double u = angle_about_y(p.x, p.z) / (2 * std::numbers::pi);
    const double x = axis - major_radius;
    const double r = std::sqrt(x * x + p.y * p.y);
    double turn = std::acos(-x / r);
    if (p.y > 0) turn = 2 * std::numbers::pi - turn;
    const double s = distance_scale(r, dist_exp);
    return oriented({u * s, turn / (2 * std::numbers::pi) * s, r}, orientation);
  }
};

}  // namespace

extern constinit const WarpType toroidal_warp =
    describe_warp<Toroidal>("toroidal", "Wraps a plane around a torus.");

}  // namespace durer::tracer::warps

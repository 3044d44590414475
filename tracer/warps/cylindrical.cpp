#include "tracer/warps/orientation.h"

namespace durer::tracer::warps {
namespace {

// The plane around the y axis: x goes round, y stays, z is the distance (textures §4.3).
struct Cylindrical : Wrapping {
  static constexpr std::array operands{
      keyword<&Cylindrical::orientation>("orientation", "side of the plane that lies outside"),
      keyword<&Cylindrical::dist_exp>("dist_exp", "how the distance scales the plane"),
  };
  dvec3 operator()(dvec3 p) const {
    const double r = std::sqrt(p.x * p.x + p.z * p.z);
    if (r == 0) return p;
    const double u = angle_about_y(p.x, p.z) / (2 * std::numbers::pi);
    return wrapped(u * scale(r), p.y, r);
  }
};

}  // namespace

extern constinit const WarpType cylindrical_warp =
    describe_warp<Cylindrical>("cylindrical", "Wraps a plane around a cylinder.");

}  // namespace durer::tracer::warps

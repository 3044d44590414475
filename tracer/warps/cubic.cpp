#include <cmath>

#include "tracer/warps/warp_type.h"

namespace durer::tracer::warps {
namespace {

// The six faces of a cube, unfolded into a cross in the unit square (textures §4.3).
struct Cubic {
  dvec3 operator()(dvec3 p) const {
    const dvec3 a(std::abs(p.x), std::abs(p.y), std::abs(p.z));
    if (p.x >= 0 && p.x >= a.y && p.x >= a.z) return face(0.75 - across(p.z / a.x), p.y, a.x);
    if (p.y >= 0 && p.y >= a.x && p.y >= a.z) {
      return {0.25 + across(p.x / a.y), 1 - up(p.z / a.y), a.y};
    }
    if (p.z >= 0 && p.z >= a.x && p.z >= a.y) return face(0.25 + across(p.x / a.z), p.y, a.z);
    if (p.x < 0 && -p.x >= a.y && -p.x >= a.z) return face(across(p.z / a.x), p.y, a.x);
    if (p.y < 0 && -p.y >= a.x && -p.y >= a.z) {
      return {0.25 + across(p.x / a.y), up(p.z / a.y), a.y};
    }
    return face(1 - across(p.x / a.z), p.y, a.z);
  }

 private:
  // From -1…1 on a face to its part of the square: a quarter wide, a third high.
  static double across(double t) { return (t + 1) / 8; }
  static double up(double t) { return (t + 1) / 6; }
  // One of the four faces in the middle row.
  static dvec3 face(double u, double v, double size) {
    return {u, 1.0 / 3 + up(v / size), size};
  }
};

}  // namespace

extern constinit const WarpType cubic_warp =
    describe_warp<Cubic>("cubic", "Unfolds a cube into the unit square.");

}  // namespace durer::tracer::warps

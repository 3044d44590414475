#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/floor.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Cushions in unit cubes, as a pattern and as a normal (textures §5.2, §13.2).
struct Quilted {
  float control0 = 1;
  float control1 = 1;

  static constexpr std::array operands{
      keyword<&Quilted::control0>("control0", "steepness at the seams"),
      keyword<&Quilted::control1>("control1", "steepness at the tops"),
  };
  static constexpr std::array samples{
      Sample{{0.5, 0.5, 0.5}, 0},
      Sample{{0.75, 0.5, 0.5}, 0.05563010404427},
      Sample{{-3, 0.1, 7.2}, 0.45027489012338},
  };
  double operator()(dvec3 p) const {
    const dvec3 u = glm::abs(bulge(p));
    return (u.x + u.y + u.z) / 3;
  }
  dvec3 perturb(dvec3 p, dvec3 n, double amount) const { return n + amount * bulge(p); }

 private:
  // From the middle of the unit cube around p outwards, as long as the cushion is steep.
  dvec3 bulge(dvec3 p) const {
    const dvec3 u = p - dvec3(whole(p.x), whole(p.y), whole(p.z)) - 0.5;
    const double t = glm::length(u);
    const double r = 1 - t;
    const double k = (t * t * t + 3 * t * r * r * control0 + 3 * t * t * r * control1) * 1.154700538;
    return k * u;
  }
  // floor() that steps down at negative whole numbers.
  static double whole(double x) { return x >= 0 ? floored(x) : -floored(-x) - 1; }
};


}  // namespace

extern constinit const PatternType quilted_pattern =
    describe_pattern<Quilted>("quilted", "Cushions in unit cubes.",
                              {.default_map = black_to_white, .unwrapped = true});

}  // namespace durer::tracer::patterns

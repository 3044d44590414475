#include <cmath>

#include "base/floor.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// floor() that steps down at negative whole numbers; the reference's tiling depends on it.
double floor_below(double x) { return x >= 0 ? floored(x) : -floored(-x) - 1; }

// Hexagons of three kinds in the xz plane, constant along y (textures §6.2). Half-unit columns and
// h-unit rows repeat every six; the cells that a slanted edge crosses are split along a diagonal.
struct Hexagon {
  static constexpr std::array samples{
      Sample{{0.1, 0, 0.1}, 0},
      Sample{{0.1, 0, 1.0}, 1},
      Sample{{1.2, 0, 0.1}, 2},
      Sample{{-1.2, 5, 0.1}, 2},
  };
  double operator()(dvec3 p) const {
    const double x = std::abs(p.x);
    const double z = p.z < 0 ? 5.196152424 - std::abs(p.z) : p.z;
    double u = x / 0.5;
    double v = z / 0.866025404;
    u -= 6 * floor_below(u / 6);
    v -= 6 * floor_below(v / 6);
    const int a = static_cast<int>(floored(u)) % 6;
    const int b = static_cast<int>(floored(v)) % 6;
    static constexpr std::array outer{0, 1, 1, 2, 2, 0};
    static constexpr std::array inner{2, 2, 0, 0, 1, 1};
    if (a == 0 || a == 5) return outer[b];
    if (a == 2 || a == 3) return inner[b];
    return diagonal(u - a, v - b, (a + b) % 2 != 0, b);
  }

 private:
  static double diagonal(double s, double t, bool rising, int row) {
    static constexpr std::array below{0, 2, 1, 0, 2, 1};
    static constexpr std::array above{2, 1, 0, 2, 1, 0};
    if (rising) s = 1 - s;
    if (s == 0) s = 0.0001;
    return t < s ? below[row] : above[row];
  }
};

constexpr std::array default_list{entry(0, 0, 0, 1), entry(1, 0, 1, 0), entry(2, 1, 0, 0)};

}  // namespace

extern constinit const PatternType hexagon_pattern =
    describe_pattern<Hexagon>("hexagon", "Hexagons of three kinds in the xz plane.",
                              {.list_size = 3, .default_map = default_list});

}  // namespace durer::tracer::patterns

#include <cmath>
#include <numbers>

#include "base/floor.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Equilateral triangles of unit side in the xz plane; six around each corner (textures §6.3).
struct Triangular {
  static constexpr std::array samples{
      Sample{{0.5, 0, 0.3}, 0},
      Sample{{0.1, 0, 0.8}, 1},
      Sample{{0.9, 0, 0.8}, 3},
  };
  double operator()(dvec3 p) const {
    constexpr double root3 = std::numbers::sqrt3;
    double x = p.x - 3 * floored(p.x / 3);
    double z = p.z - root3 * floored(p.z / root3);
    const int column = static_cast<int>(floored(x));
    x -= column;
    const bool lower = z < root3 / 2;
    if (!lower) z = root3 - z;
    const int n = turned(kind(x, z), column);
    return lower ? n : 5 - n;
  }

 private:
  // Which part of a rhombus row: below both slanted edges, or beyond the left or right one.
  static int kind(double x, double z) {
    if (x == 0 || x == 1) return 1;
    const bool left = z / x < std::numbers::sqrt3;
    const bool right = z / (1 - x) < std::numbers::sqrt3;
    if (left && right) return 0;
    return left ? 3 : 1;
  }
  static int turned(int n, int column) {
    const int steps = 2 * column;
    return n % 2 != 0 ? (n + steps) % 6 : (6 + n - steps) % 6;
  }
};

constexpr std::array default_list{
    entry(0, 1, 0, 0), entry(1, 0, 1, 0), entry(2, 0, 0, 1),
    entry(3, 1, 1, 0), entry(4, 0, 1, 1), entry(5, 1, 0, 1),
};

}  // namespace

extern constinit const PatternType triangular_pattern =
    describe_pattern<Triangular>("triangular", "Triangles of six kinds in the xz plane.",
                                 {.list_size = 6, .default_map = default_list});

}  // namespace durer::tracer::patterns

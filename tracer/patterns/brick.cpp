#include <cmath>

#include "base/floor.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

double fraction(double x) { return x - floored(x); }

// A wall of bricks (1) with mortar joints (0), every second course shifted by half a brick, in all
// three directions (textures §6.1).
struct Brick {
  dvec3 size{8, 3, 4.5};  // brick with one joint, pattern units
  double mortar = 0.5;    // width of the joint, pattern units; single precision in the language
  dvec3 joint{0.0};       // the same as a share of a brick

  static constexpr std::array operands{
      keyword<&Brick::size>("brick_size", "size of a brick with its joints"),
      keyword<&Brick::mortar>("mortar", "width of the joints"),
  };
  static constexpr std::array samples{
      Sample{{0, 0, 0}, 1},   Sample{{2, 1, 2}, 0}, Sample{{2, 2.7, 2}, 0},
      Sample{{4.1, 1, 3}, 1}, Sample{{4, 4, 3}, 1}, Sample{{3.7, 4, 2}, 0},
  };

  void prepare() {
    mortar = static_cast<float>(static_cast<float>(mortar) - 2 * epsilon);
    joint = mortar / size;
  }

  double operator()(dvec3 p) const {
    const dvec3 q = p + (epsilon + mortar);
    if (fraction(q.y / size.y) <= joint.y) return 0;
    const bool shifted = fraction(q.y / (2 * size.y)) > 0.5;
    const double x = fraction(q.x / size.x + (shifted ? 0.5 : 0.0));
    const double z = fraction(q.z / size.z + (shifted ? 0.0 : 0.5));
    return x <= joint.x || z <= joint.z ? 0 : 1;
  }
};

constexpr std::array default_list{entry(0, 0.5F, 0.5F, 0.5F), entry(1, 0.6F, 0.15F, 0.15F)};

}  // namespace

extern constinit const PatternType brick_pattern = describe_pattern<Brick>(
    "brick", "Mortar and bricks.", {.list_size = 2, .default_map = default_list});

}  // namespace durer::tracer::patterns

#include <algorithm>
#include <cmath>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// 1 on the y axis, falling to 0 at distance 1 (textures §5).
struct Cylindrical {
  static constexpr std::array samples{
      Sample{{0, 9, 0}, 1},
      Sample{{0.3, 0, 0.4}, 0.5},
      Sample{{1, 0, 1}, 0},
  };
  double operator()(dvec3 p) const { return std::max(0.0, 1 - std::sqrt(p.x * p.x + p.z * p.z)); }
};

}  // namespace

extern constinit const PatternType cylindrical_pattern = describe_pattern<Cylindrical>(
    "cylindrical", "A column along the y axis.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

#include <algorithm>
#include <cmath>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// 1 at the origin, falling to 0 on the faces of the cube of side 2 (textures §5).
struct Boxed {
  static constexpr std::array samples{
      Sample{{0, 0, 0}, 1},
      Sample{{0.25, -0.5, 0.1}, 0.5},
      Sample{{0, 0, 3}, 0},
  };
  double operator()(dvec3 p) const {
    return std::max(0.0, 1 - std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
  }
};

}  // namespace

extern constinit const PatternType boxed_pattern =
    describe_pattern<Boxed>("boxed", "A cube around the origin.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

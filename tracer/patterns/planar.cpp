#include <algorithm>
#include <cmath>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// 1 on the plane y = 0, falling to 0 at distance 1 (textures §5).
struct Planar {
  static constexpr std::array samples{
      Sample{{5, 0, 7}, 1},
      Sample{{0, -0.25, 0}, 0.75},
      Sample{{0, 2, 0}, 0},
  };
  double operator()(dvec3 p) const { return std::max(0.0, 1 - std::abs(p.y)); }
};

}  // namespace

extern constinit const PatternType planar_pattern =
    describe_pattern<Planar>("planar", "A sheet on the xz plane.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

#include <algorithm>
#include <glm/geometric.hpp>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// 1 at the origin, falling to 0 at distance 1 (textures §5).
struct Spherical {
  static constexpr std::array samples{
      Sample{{0, 0, 0}, 1},
      Sample{{0, 0.3, 0.4}, 0.5},
      Sample{{1, 1, 1}, 0},
  };
  double operator()(dvec3 p) const { return std::max(0.0, 1 - glm::length(p)); }
};

}  // namespace

extern constinit const PatternType spherical_pattern = describe_pattern<Spherical>(
    "spherical", "A ball around the origin.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

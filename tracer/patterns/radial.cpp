#include <cmath>
#include <numbers>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// One turn about the y axis, from 0 to 1; a quarter is added so that it starts towards -x
// (textures §5).
struct Radial {
  static constexpr std::array samples{
      Sample{{0, 0, 0}, 0.25},
      Sample{{0, 5, 1}, 0.75},
      Sample{{0.5, 0, 0}, 1},
      Sample{{0.0005, 0, 0.0009}, 0.25},
  };
  double operator()(dvec3 p) const {
    constexpr double axis = 0.001;  // the axis itself has no direction
    if (std::abs(p.x) < axis && std::abs(p.z) < axis) return 0.25;
    return 0.25 + (std::atan2(p.x, p.z) + std::numbers::pi) / (2 * std::numbers::pi);
  }
};

constexpr std::array default_map{
    entry(0, 0, 1, 1),
    entry(0.333F, 1, 1, 0),
    entry(0.666F, 1, 0, 1),
    entry(1, 0, 1, 1),
};

}  // namespace

extern constinit const PatternType radial_pattern =
    describe_pattern<Radial>("radial", "A turn around the y axis.", {.default_map = default_map});

}  // namespace durer::tracer::patterns

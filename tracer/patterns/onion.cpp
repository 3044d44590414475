#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Shells of thickness 1 around the origin, each a ramp outwards (textures §5).
struct Onion {
  static constexpr std::array samples{
      Sample{{0, 0, 0}, 0},
      Sample{{0, 0.25, 0}, 0.25},
      Sample{{0, 3, 4.5}, 0.408326913195984},
  };
  double operator()(dvec3 p) const { return std::fmod(glm::length(p), 1); }
};

}  // namespace

extern constinit const PatternType onion_pattern =
    describe_pattern<Onion>("onion", "Concentric shells.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

#include <cmath>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Spots on a cubic lattice of period 2π: ((sin x + sin y + sin z) / 3)² (textures §5).
struct Leopard {
  static constexpr std::array samples{
      Sample{{0, 0, 0}, 0},
      Sample{{1.5707963267948966, 1.5707963267948966, 1.5707963267948966}, 1},
  };
  double operator()(dvec3 p) const {
    const double s = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3;
    return s * s;
  }
};

}  // namespace

extern constinit const PatternType leopard_pattern =
    describe_pattern<Leopard>("leopard", "Round spots.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

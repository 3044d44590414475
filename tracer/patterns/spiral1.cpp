#include "tracer/patterns/spiral.h"

namespace durer::tracer::patterns {
namespace {

// Arms that grow outwards (textures §5.3).
struct Spiral1 : SpiralPattern {
  static constexpr std::array operands{
      positional<&Spiral1::arms>("arms", "number of arms"),
  };
  static constexpr std::array samples{
      Sample{{0, 0, 0.25}, 0.25},
      Sample{{0.5, 0, 0}, 0.75},
  };
  double operator()(dvec3 p) const { return arm(p, radius(p)); }
};

}  // namespace

extern constinit const PatternType spiral1_pattern =
    describe_pattern<Spiral1>("spiral1", "Spiral arms.",
                             {.wave = scene::Wave::triangle, .default_map = black_to_white});

}  // namespace durer::tracer::patterns

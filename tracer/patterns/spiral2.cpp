#include "tracer/patterns/spiral.h"

namespace durer::tracer::patterns {
namespace {

// The same, crossed by rings (textures §5.3).
struct Spiral2 : SpiralPattern {
  static constexpr std::array operands{
      positional<&Spiral2::arms>("arms", "number of arms"),
  };
  static constexpr std::array samples{
      Sample{{0, 0, 0.25}, 0.5},
      Sample{{0.25, 0, 0}, 1.5},
  };
  double operator()(dvec3 p) const {
    const double r = radius(p);
    return functions::triangle(r) + functions::triangle(arm(p, r));
  }
};

}  // namespace

extern constinit const PatternType spiral2_pattern =
    describe_pattern<Spiral2>("spiral2", "Spiral arms, crossed by rings.",
                             {.wave = scene::Wave::triangle, .default_map = black_to_white});

}  // namespace durer::tracer::patterns

#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// A ramp of period 1 along a direction (textures §5). Negative values are wrapped by the pipeline.
struct Gradient {
  dvec3 direction{1, 0, 0};

  static constexpr std::array operands{
      positional<&Gradient::direction>("direction", "where the ramp goes; its length is ignored"),
  };
  static constexpr std::array samples{
      Sample{{0.25, 7, 0}, 0.25},
      Sample{{-0.25, 0, 0}, -0.25},
      Sample{{1, 0, 0}, 1},
      Sample{{2.5, 0, 0}, 0.5},
  };

  void prepare() { direction /= glm::length(direction); }

  double operator()(dvec3 p) const {
    const double r = glm::dot(p, direction);
    return r > 1 ? std::fmod(r, 1) : r;
  }
};

}  // namespace

extern constinit const PatternType gradient_pattern = describe_pattern<Gradient>(
    "gradient", "A ramp along a direction.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

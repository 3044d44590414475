#include <cmath>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Rings around the z axis; turbulence shifts them along x and y (textures §5).
struct Wood {
  dvec2 amount{0.0};  // x and y of `turbulence`
  functions::Octaves octaves{};

  static constexpr std::array samples{
      Sample{{0.3, 0.4, 7}, 0.5},
      Sample{{-3, 0, 2}, 3},
  };
  void prepare(const PatternContext& context) {
    amount = {context.turbulence.x, context.turbulence.y};
    octaves = context.octaves;
  }
  double operator()(dvec3 p) const {
    double x = p.x;
    double y = p.y;
    if (amount.x != 0 || amount.y != 0) {
      const dvec3 d = functions::vturbulence(p, octaves);
      x += functions::cycloidal((p.x + d.x) * amount.x);
      y += functions::cycloidal((p.y + d.y) * amount.y);
    }
    return std::sqrt(x * x + y * y);
  }
};

constexpr std::array default_map{
    entry(0.6F, 0.666F, 0.312F, 0.2F),
    entry(0.6F, 0.4F, 0.1333F, 0.066F),
};

}  // namespace

extern constinit const PatternType wood_pattern = describe_pattern<Wood>(
    "wood", "Rings around the z axis.",
    {.wave = scene::Wave::triangle, .default_map = default_map, .own_turbulence = true});

}  // namespace durer::tracer::patterns

#include <cmath>
#include <cstdint>

#include "base/floor.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Unit squares in the xz plane; four around each corner, all different (textures §6).
struct Square {
  static constexpr std::array samples{
      Sample{{0.5, 3, 0.5}, 0},  Sample{{0.5, 0, 1.5}, 1},  Sample{{1.5, 0, 1.5}, 2},
      Sample{{1.5, 0, -0.5}, 2}, Sample{{-0.5, 0, 0.5}, 3},
  };
  double operator()(dvec3 p) const {
    const auto odd = [](double x) { return (static_cast<std::int64_t>(floored(x)) & 1) != 0; };
    if (odd(p.x)) return odd(p.z) ? 2 : 3;
    return odd(p.z) ? 1 : 0;
  }
};

constexpr std::array default_list{
    entry(0, 1, 0, 0),
    entry(1, 0, 1, 0),
    entry(2, 0, 0, 1),
    entry(3, 1, 1, 0),
};

}  // namespace

extern constinit const PatternType square_pattern =
    describe_pattern<Square>("square", "Unit squares of four kinds in the xz plane.",
                             {.list_size = 4, .default_map = default_list});

}  // namespace durer::tracer::patterns

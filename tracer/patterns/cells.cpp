#include <cmath>

#include "base/floor.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// A random number for every unit cube (textures §5).
struct Cells {
  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.711818915326},
      Sample{{-1.5, 2.25, 7.75}, 0.124025915982},
      Sample{{123.4, -56.7, 8.9}, 0.978487308603},
  };
  double operator()(dvec3 p) const {
    const auto cell = [](double x) {
      return static_cast<int>(static_cast<std::int64_t>(floored(x + epsilon)));
    };
    return functions::uniform_table(
        static_cast<unsigned>(functions::hash3(cell(p.x), cell(p.y), cell(p.z))));
  }
};

}  // namespace

extern constinit const PatternType cells_pattern =
    describe_pattern<Cells>("cells", "Unit cubes of random value.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

#include <cmath>
#include <cstdint>

#include "base/floor.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Unit cubes of two kinds, 0 at the origin's cube (textures §6). The small shift keeps surfaces
// that lie exactly on a lattice plane in one cube.
struct Checker {
  static constexpr std::array samples{
      Sample{{0.5, 0.5, 0.5}, 0}, Sample{{1.5, 0.5, 0.5}, 1},  Sample{{0.5, -0.5, 0.5}, 1},
      Sample{{-1, -1, -1}, 1},    Sample{{-1e-11, 0.5, 0}, 0}, Sample{{-1e-9, 0.5, 0}, 1},
  };
  double operator()(dvec3 p) const {
    const auto cell = [](double x) { return static_cast<std::int64_t>(floored(x + epsilon)); };
    return static_cast<double>((cell(p.x) + cell(p.y) + cell(p.z)) & 1);
  }
};

constexpr std::array default_list{entry(0, 0, 0, 1), entry(1, 0, 1, 0)};

}  // namespace

extern constinit const PatternType checker_pattern = describe_pattern<Checker>(
    "checker", "Unit cubes of two kinds.", {.list_size = 2, .default_map = default_list});

}  // namespace durer::tracer::patterns

#include <glm/common.hpp>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// The six pyramids between the origin and the faces of a cube around it: +x +y +z -x -y -z
// (textures §6.4).
struct Cubic {
  static constexpr std::array samples{
      Sample{{2, 1, -1}, 0},     Sample{{0, 1, 0}, 1},  Sample{{0, 0.5, 1}, 2},
      Sample{{-1, 0.5, 0.5}, 3}, Sample{{0, -1, 0}, 4}, Sample{{0, 0, -1}, 5},
      Sample{{0, 0, 0}, 0},
  };
  double operator()(dvec3 p) const {
    const dvec3 a = glm::abs(p);
    if (p.x >= 0 && p.x >= a.y && p.x >= a.z) return 0;
    if (p.y >= 0 && p.y >= a.x && p.y >= a.z) return 1;
    if (p.z >= 0 && p.z >= a.x && p.z >= a.y) return 2;
    if (p.x < 0 && p.x <= -a.y && p.x <= -a.z) return 3;
    if (p.y < 0 && p.y <= -a.x && p.y <= -a.z) return 4;
    return 5;
  }
};

constexpr std::array default_list{
    entry(0, 1, 0, 0), entry(1, 0, 1, 0), entry(2, 0, 0, 1),
    entry(3, 1, 1, 0), entry(4, 0, 1, 1), entry(5, 1, 0, 1),
};

}  // namespace

extern constinit const PatternType cubic_pattern = describe_pattern<Cubic>(
    "cubic", "Six pyramids that make up space.", {.list_size = 6, .default_map = default_list});

}  // namespace durer::tracer::patterns

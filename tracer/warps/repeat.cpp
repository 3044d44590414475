#include <cmath>

#include "tracer/warps/warp_type.h"

namespace durer::tracer::warps {
namespace {

// One slab of space again and again, shifted or mirrored at every turn (textures §4.3).
struct Repeat {
  dvec3 step{0.0};
  dvec3 offset{0.0};
  dvec3 flip{0.0};

  static constexpr std::array operands{
      positional<&Repeat::step>("step", "axis and width"),
      keyword<&Repeat::offset>("offset", "shift at every turn"),
      keyword<&Repeat::flip>("flip", "axes that are mirrored at every second turn"),
  };
  static std::optional<std::string> validate(std::span<const double> args) {
    const int axes = (args[0] != 0) + (args[1] != 0) + (args[2] != 0);
    if (axes == 1) return {};
    return axes == 0 ? "`repeat` needs a direction: one component other than 0"
                     : "`repeat` goes along one axis; use several warps for more";
  }
  dvec3 operator()(dvec3 p) const {
    const int axis = step.x != 0 ? 0 : step.y != 0 ? 1 : 2;
    const auto width = static_cast<float>(step[axis]);
    const auto turn = static_cast<float>(std::floor(p[axis] / width));
    p[axis] -= turn * width;
    if (static_cast<std::int64_t>(turn) & 1) {
      for (int i = 0; i < 3; ++i) {
        if (flip[i] != 0) p[i] = -p[i];
      }
      if (flip[axis] != 0) p[axis] += width;
    }
    return p + static_cast<double>(turn) * offset;
  }
};

}  // namespace

extern constinit const WarpType repeat_warp =
    describe_warp<Repeat>("repeat", "Repeats a slab of space.");

}  // namespace durer::tracer::warps

#include "tracer/warps/orientation.h"

namespace durer::tracer::warps {
namespace {

// One plane through all of space: z is the same everywhere (textures §4.3).
struct Planar {
  dvec3 orientation{0, 0, 1};
  float offset = 0;

  static constexpr std::array operands{
      optional_positional<&Planar::orientation>("orientation", "normal of the plane"),
      optional_positional<&Planar::offset>("offset", "where the plane lies"),
  };
  void prepare() { orientation = glm::normalize(orientation); }
  dvec3 operator()(dvec3 p) const { return oriented({p.x, p.y, offset}, orientation); }
};

}  // namespace

extern constinit const WarpType planar_warp =
    describe_warp<Planar>("planar", "Flattens space into a plane.");

}  // namespace durer::tracer::warps

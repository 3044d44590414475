#include "tracer/primitives/describe.h"
#include "tracer/primitives/frame.h"
#include "tracer/primitives/tube.h"

namespace durer::tracer {
namespace {

// Round cylinder between two points (objects §10.3). Canonical: radius 1, z in [0, 1].
struct Cylinder {
  dvec3 base{0.0};
  dvec3 cap{0, 1, 0};
  double radius = 1;
  bool open = false;

  static constexpr std::array params{
      positional<&Cylinder::base>("base", "centre of one end"),
      positional<&Cylinder::cap>("cap", "centre of the other end"),
      positional<&Cylinder::radius>("radius", "radius; any sign, 0 is invisible"),
      flag<&Cylinder::open>("open", "the wall without its caps"),
  };

  static std::vector<Cylinder> samples() {
    return {{dvec3(0.0), {1, 2, 0.5}, 0.5, false},
            {{0, -1, 0}, {0, 1, 0}, 1, false},
            {{2, 0, 0}, {-3, 0, 0}, 0.1, true},
            {{0, 0, 5}, {0.1, 0, 5}, -4, false}};
  }

  [[nodiscard]] std::optional<std::string> problem() const {
    if (glm::distance(base, cap) < epsilon) return "the two ends of a cylinder must differ";
    return std::nullopt;
  }
  [[nodiscard]] std::optional<Framed<Tube>> shape() const {
    if (radius == 0) return std::nullopt;
    const double length = glm::distance(base, cap);
    return Framed<Tube>{{0, open},
                        frame_along(base, (cap - base) / length, std::abs(radius), length)};
  }
};

}  // namespace

extern constinit const PrimitiveType cylinder_primitive =
    describe<Cylinder>("cylinder", "A round cylinder: two ends, radius.");

}  // namespace durer::tracer

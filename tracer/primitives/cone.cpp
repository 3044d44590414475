#include "tracer/primitives/describe.h"
#include "tracer/primitives/frame.h"
#include "tracer/primitives/tube.h"

namespace durer::tracer {
namespace {

// Part of a round cone between two points (objects §10.3). Canonical: the larger end at z = 0
// with radius 1. Radii of opposite sign make an hourglass.
struct Cone {
  dvec3 base{0.0};
  double base_radius = 1;
  dvec3 cap{0, 1, 0};
  double cap_radius = 0;
  bool open = false;

  static constexpr std::array params{
      positional<&Cone::base>("base", "centre of one end"),
      positional<&Cone::base_radius>("base_radius", "radius at that end"),
      positional<&Cone::cap>("cap", "centre of the other end"),
      positional<&Cone::cap_radius>("cap_radius", "radius at the other end"),
      flag<&Cone::open>("open", "the wall without its caps"),
  };

  static std::vector<Cone> samples() {
    return {{dvec3(0.0), 1, {0, 2, 0}, 0.3, false},  {{1, 1, 1}, 0, {3, 0, 2}, 1, false},
            {{0, 0, -1}, 0.5, {0, 0, 1}, 2, true},   {{0, -1, 0}, 1, {0, 1, 0}, -0.5, false},
            {{0, -1, 0}, 1, {0, 1, 0}, 0.99, false}, {{0, -1, 0}, -1, {0, 1, 0}, -0.5, false}};
  }

  [[nodiscard]] std::optional<std::string> problem() const {
    if (glm::distance(base, cap) < epsilon) return "the two ends of a cone must differ";
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Framed<Tube>> shape() const {
    dvec3 large = base;
    dvec3 small = cap;
    double r_large = base_radius;
    double r_small = cap_radius;
    if (r_small > r_large) std::swap(large, small), std::swap(r_large, r_small);
    // The oracle makes a cylinder of two negative radii: its taper test compares signed numbers.
    if (r_large < 0) r_small = r_large = -r_large;
    if (!(r_large > 0)) return std::nullopt;
    const double length = glm::distance(small, large);
    return Framed<Tube>{{(r_small - r_large) / r_large, open},
                        frame_along(large, (small - large) / length, r_large, length)};
  }
};

}  // namespace

extern constinit const PrimitiveType cone_primitive =
    describe<Cone>("cone", "Part of a round cone: two ends and the radius at each.");

}  // namespace durer::tracer

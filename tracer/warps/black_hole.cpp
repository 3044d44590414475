#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "functions/noise.h"
#include "tracer/warps/warp_type.h"

namespace durer::tracer::warps {
namespace {

// A ball that draws points inwards or pushes them out, once or on a lattice (textures §4.3).
struct BlackHole {
  dvec3 centre{0.0};
  float radius = 1;
  float strength = 1;
  float falloff = 2;
  float type = 0;  // others have no effect
  bool inverse = false;
  dvec3 repeat{0.0};
  dvec3 turbulence{0.0};

  static constexpr std::array operands{
      positional<&BlackHole::centre>("center", "centre"),
      positional<&BlackHole::radius>("radius", "radius"),
      keyword<&BlackHole::strength>("strength", "how much points are moved"),
      keyword<&BlackHole::falloff>("falloff", "how fast the effect fades away from the centre"),
      keyword<&BlackHole::inverse>("inverse", "pushes instead of pulling"),
      keyword<&BlackHole::type>("type", "0; others have no effect"),
      keyword<&BlackHole::repeat>("repeat", "distances of a lattice of holes"),
      keyword<&BlackHole::turbulence>("turbulence", "how far holes of a lattice are out of place"),
  };

  // Every hole of a lattice has to fit its own cell.
  void prepare() {
    if (!repeats()) return;
    for (int i = 0; i < 3; ++i) {
      if (repeat[i] < epsilon) {
        repeat[i] = 0;
        continue;
      }
      centre[i] = std::max(centre[i], static_cast<double>(radius));
      repeat[i] = std::max(repeat[i], centre[i] + radius + turbulence[i]);
    }
  }

  dvec3 operator()(dvec3 p) const {
    if (type != 0) return p;
    const dvec3 d = p - centre_near(p);
    const double length = glm::length(d);
    if (length >= radius) return p;
    const double depth = (radius - length) / radius;
    const double m = std::min(1.0, strength * std::pow(depth, static_cast<double>(falloff)));
    return p + (inverse ? -m : m) * d;
  }

 private:
  bool repeats() const { return repeat != dvec3(0.0); }

  dvec3 centre_near(dvec3 p) const {
    if (!repeats()) return centre;
    dvec3 cell(0.0);
    for (int i = 0; i < 3; ++i) {
      if (repeat[i] >= epsilon) cell[i] = std::floor(p[i] / repeat[i]);
    }
    dvec3 c = centre;
    if (turbulence != dvec3(0.0)) {
      const auto whole = [](double x) { return static_cast<int>(static_cast<std::int64_t>(x)); };
      const auto s =
          static_cast<unsigned>(functions::hash3(whole(cell.x), whole(cell.y), whole(cell.z)));
      for (int i = 0; i < 3; ++i) {
        c[i] += functions::uniform_table(s + static_cast<unsigned>(i)) * turbulence[i];
      }
    }
    return c + repeat * cell;
  }
};

}  // namespace

extern constinit const WarpType black_hole_warp =
    describe_warp<BlackHole>("black_hole", "Draws points to a centre.");

}  // namespace durer::tracer::warps

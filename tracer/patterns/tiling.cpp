#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tracer/patterns/pattern_type.h"
#include "tracer/patterns/penrose.h"
#include "tracer/patterns/tiling_borders.h"
#include "tracer/patterns/tilings.h"

namespace durer::tracer::patterns {
namespace {

constexpr double root3 = std::numbers::sqrt3;
constexpr double h = root3 / 2;

/// Kinds of tiles whose flat middle is raised a little, to stand clear of the border of the kind
/// below: value = max(least, k / n + raised / n + …).
struct Lift {
  int tiling;
  int kind;
  double raised;  // added before the division by the number of kinds
  double least;   // of the result, likewise
};
constexpr std::array lifts{
    Lift{7, 1, 0, 1.000000000002}, Lift{8, 2, 1e-7, 0},   Lift{9, 2, 0, 2.0000001},
    Lift{14, 4, 1e-6, 0},          Lift{15, 1, 2e-8, 0},  Lift{16, 2, 0, 2.0000001},
    Lift{17, 1, 1e-6, 0},          Lift{17, 2, 1e-6, 0},  Lift{17, 5, 0, 5.000001},
    Lift{19, 2, 0, 2.000001},      Lift{20, 2, 0, 2.000001}, Lift{21, 4, 0, 4.000001},
    Lift{21, 5, 0, 5.000001},      Lift{23, 2, 1e-6, 0},  Lift{24, 4, 1e-6, 0},
};

/// Dodecagons and triangles, by folding the plane (textures §9.2).
double dodecagons(double x, double z) {
  double k = 0;
  x = floor_mod(x, 2 + root3);
  z = floor_mod(z, 3 + 2 * root3);
  if (z > root3 + 1.5) {
    z -= root3 + 1.5;
    x += (x < 1 + h ? 1 : -1) * (1 + h);
  }
  if (x > 1 + h) x = 2 + root3 - x;
  if (z > 1 + h) {
    z = 2 + root3 - z;
    k = 1;
  }
  double d2 = x + root3 * z - h - 0.5;
  if (d2 < 0) {
    const double turned = (1 + root3) / 4 + x / 2 - h * z;
    z = (3 + root3) / 4 - h * x - z / 2;
    x = turned;
    d2 = -d2;
  }
  const double d3 = root3 * (z + root3 * x - h - 0.5);
  if (d3 < 0) return (std::max(d3, -1.0) + 1 + k) / 3;
  return (3.0000001 - std::min({3 * z, 3 * x, root3 * d2, d3, 1.0})) / 3;
}

// Tilings of the xz plane: 0 in the middle of the first kind of tile, rising towards its border, and
// so on for every kind (textures §9).
struct TilingPattern {
  double number = 1;
  const Tiling* tiling = nullptr;

  static constexpr std::array operands{
      positional<&TilingPattern::number>("type", "which tiling, 1 to 27"),
  };
  static constexpr std::array samples{
      Sample{{0.5, 7, 0.5}, 0},
      Sample{{0.25, 7, 0.5}, 0.5},
  };

  void prepare() {
    const int n = static_cast<int>(number);
    number = n;
    if (n < 22 || n == 23 || n == 24) tiling = &tiling_of(n == 12 ? 11 : n);
  }

  double operator()(dvec3 p) const {
    if (const auto v = value_on_mirror(static_cast<int>(number), {p.x, p.z})) return *v;
    switch (static_cast<int>(number)) {
      case 12: return regular({std::abs(floor_mod(p.x, 6) - 3), std::abs(floor_mod(p.z, 6) - 3)});
      case 22: return dodecagons(p.x, p.z);
      case 25: return penrose_pentagons(p.x, p.z);
      case 26: return penrose_kites(p.x, p.z);
      case 27: return penrose_rhombs(p.x, p.z);
      default: return regular({p.x, p.z});
    }
  }

 private:
  [[nodiscard]] double regular(dvec2 p) const {
    Tiling::Place place = tiling->at(p);
    place.kind = kind_by_folding(static_cast<int>(number), p).value_or(place.kind);
    double v = place.kind + std::max(0.0, 1 - tiling->steepness * place.depth);
    for (const Lift& lift : lifts) {
      if (lift.tiling == static_cast<int>(number) && lift.kind == place.kind) {
        v = std::max(v + lift.raised, lift.least);
      }
    }
    return v / tiling->kinds;
  }
};

std::optional<std::string> check_tiling(std::span<const double> args) {
  const double n = std::trunc(args[0]);
  if (!(n >= 1 && n <= 27)) return "there are tilings 1 to 27";
  return {};
}

constexpr PatternType checked(PatternType type) {
  type.validate = &check_tiling;
  return type;
}

}  // namespace

extern constinit const PatternType tiling_pattern = checked(describe_pattern<TilingPattern>(
    "tiling", "Regular tilings of the plane.", {.default_map = black_to_white}));

}  // namespace durer::tracer::patterns

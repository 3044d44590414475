#include "tracer/patterns/crackle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Distances to the nearest random points, weighted, or noise at the nearest one (textures §5.1).
struct Crackle {
  bool solid = false;
  float offset = 0;
  dvec3 form{-1, 1, 0};
  dvec3 metric{2, 2, 2};  // its x; a vector because it may be written as one
  functions::NoiseGenerator generator = 2;

  static constexpr std::array operands{
      keyword<&Crackle::solid>("solid", "one value in each cell"),
      keyword<&Crackle::form>("form", "weights of the three smallest distances"),
      keyword<&Crackle::metric>("metric", "exponent of the distances"),
      keyword<&Crackle::offset>("offset", "added to the distances"),
  };
  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.102799521802},
      Sample{{-1.5, 2.25, 7.75}, 0.244286441802},
      Sample{{123.4, -56.7, 8.9}, 0.275341406851},
  };
  void prepare(const PatternContext& context) { generator = context.noise_generator; }

  double operator()(dvec3 p) const {
    const Nearest nearest = search(p);
    if (solid) return functions::noise(nearest.point, generator);
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += form[i] * length(nearest.power[static_cast<std::size_t>(i)]);
    return std::clamp(sum, 0.0, 1.0);
  }

 private:
  struct Nearest {
    std::array<double, 3> power;  // distances to the power of the metric, ascending
    dvec3 point{0.0};
  };

  double power(double x) const {
    const double exponent = metric.x;
    return exponent == 2 ? x * x : exponent == 1 ? std::abs(x) : std::pow(std::abs(x), exponent);
  }
  double length(double d) const {
    const double exponent = metric.x;
    if (offset != 0) d += std::pow(static_cast<double>(offset), exponent);
    return exponent == 2 ? std::sqrt(d) : exponent == 1 ? d : std::pow(d, 1 / exponent);
  }
  // The least power that one coordinate adds for a point in a cube `step` cubes away.
  double gap(double f, int step) const {
    if (step == 0 || metric.x <= 0) return 0;
    return power(step > 0 ? step - f : f - step - 1);
  }

  Nearest search(dvec3 p) const {
    constexpr double far = std::numeric_limits<double>::infinity();
    Nearest out{{far, far, far}, p};
    const std::int64_t x = crackle_cell(p.x);
    const std::int64_t y = crackle_cell(p.y);
    const std::int64_t z = crackle_cell(p.z);
    const dvec3 f = p - dvec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    for (const CrackleCube& c : crackle_cubes) {
      if (gap(f.x, c.x) + gap(f.y, c.y) + gap(f.z, c.z) > out.power[2]) continue;
      const dvec3 q = crackle_point(x + c.x, y + c.y, z + c.z);
      const double d = power(q.x - p.x) + power(q.y - p.y) + power(q.z - p.z);
      if (d < out.power[0]) {
        out = {{d, out.power[0], out.power[1]}, q};
      } else if (d < out.power[1]) {
        out.power = {out.power[0], d, out.power[1]};
      } else {
        out.power[2] = std::min(out.power[2], d);
      }
    }
    return out;
  }
};

}  // namespace

extern constinit const PatternType crackle_pattern =
    describe_pattern<Crackle>("crackle", "Cracks between random cells.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

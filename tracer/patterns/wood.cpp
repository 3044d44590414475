#include <algorithm>
#include <cmath>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Rings around the z axis; turbulence shifts them along x and y (textures §5).
struct Wood {
  dvec2 amount{0.0};  // x and y of `turbulence`
  functions::Octaves octaves{};

  static constexpr std::array samples{
      Sample{{0.3, 0.4, 7}, 0.5},
      Sample{{-3, 0, 2}, 3},
  };
  void prepare(const PatternContext& context) {
    amount = {context.turbulence.x, context.turbulence.y};
    octaves = context.octaves;
  }
  double operator()(dvec3 p) const {
    if (amount.x == 0 && amount.y == 0) return radius(p.x, p.y);
    return shifted(p, functions::vturbulence(p, octaves));
  }
  void evaluate(std::span<const dvec3> points, double* values) const {
    std::array<dvec3, 16> d;
    for (; !points.empty(); points = points.subspan(std::min(d.size(), points.size()))) {
      const auto some = points.first(std::min(d.size(), points.size()));
      if (amount.x == 0 && amount.y == 0) {
        for (const dvec3& p : some) *values++ = radius(p.x, p.y);
        continue;
      }
      functions::vturbulence(some, octaves, std::span(d).first(some.size()));
      for (std::size_t i = 0; i < some.size(); ++i) *values++ = shifted(some[i], d[i]);
    }
  }

 private:
  static double radius(double x, double y) { return std::sqrt(x * x + y * y); }
  double shifted(const dvec3& p, const dvec3& d) const {
    return radius(p.x + functions::cycloidal((p.x + d.x) * amount.x),
                  p.y + functions::cycloidal((p.y + d.y) * amount.y));
  }
};

constexpr std::array default_map{
    entry(0.6F, 0.666F, 0.312F, 0.2F),
    entry(0.6F, 0.4F, 0.1333F, 0.066F),
};

}  // namespace

extern constinit const PatternType wood_pattern = describe_pattern<Wood>(
    "wood", "Rings around the z axis.",
    {.wave = scene::Wave::triangle, .default_map = default_map, .own_turbulence = true});

}  // namespace durer::tracer::patterns

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// How steep a surface is, and optionally how high (textures §8.1).
struct Slope {
  dvec3 direction{0, 1, 0};
  float low = 0;
  float high = 0;
  dvec3 altitude{0.0};  // 0: heights do not count
  float low_altitude = 0;
  float high_altitude = 0;
  bool to_point = false;  // `direction` is a point to look at

  static constexpr std::array operands{
      positional<&Slope::direction>("direction", "where up is"),
      positional<&Slope::low>("low_slope", "slope that gives 0"),
      positional<&Slope::high>("high_slope", "slope that gives 1"),
      positional<&Slope::altitude>("altitude", "where higher places are"),
      positional<&Slope::low_altitude>("low_altitude", "altitude that gives 0"),
      positional<&Slope::high_altitude>("high_altitude", "altitude that gives 1"),
      positional<&Slope::to_point>("point_at", "the direction is a point to look at"),
  };
  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};

  double operator()(dvec3 p, const SurfaceView* view) const {
    if (view == nullptr) return 0;
    const dvec3 up = glm::normalize(to_point ? direction - view->p : direction);
    const double s = std::clamp(glm::dot(view->n, up), -1.0, 1.0);
    const double slope = ranged((std::asin(s) * 2 / std::numbers::pi + 1) / 2, low, high);
    // Rounded to single precision, so a share may be a little more than all: then slopes of 1, such
    // as those of level ground, come out as 0.
    const double steep = to_point ? 1 : glm::length(direction);
    const double size = glm::length(altitude);
    const double share = steep / static_cast<float>(steep + size);
    double v = share * slope;
    if (size > 0) {
      v += (1 - share) * ranged(glm::dot(p, altitude / size), low_altitude, high_altitude);
    }
    return v >= 1 && v < 1 + epsilon ? v - epsilon : wrapped(v);
  }

 private:
  static double ranged(double v, double low, double high) {
    return high != low ? (v - low) / (high - low) : v;
  }
  static double wrapped(double v) {
    v = std::fmod(v, 1);
    return v < 0 ? v + 1 : v;
  }
};

}  // namespace

extern constinit const PatternType slope_pattern =
    describe_pattern<Slope>("slope", "How steep a surface is.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

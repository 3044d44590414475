#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// The angle between the view and the surface (textures §8.2).
struct Aoi {
  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};

  double operator()(dvec3, const SurfaceView* view) const {
    if (view == nullptr) return 0;
    const double c = std::clamp(glm::dot(glm::normalize(view->n), view->d), -1.0, 1.0);
    return std::acos(c) / std::numbers::pi;
  }
};

}  // namespace

extern constinit const PatternType aoi_pattern = describe_pattern<Aoi>(
    "aoi", "The angle at which a surface is seen.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

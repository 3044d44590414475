// All the ways from a point to an area, as shapes see them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/bounds.h"
#include "base/transform.h"

namespace durer::tracer {

/// The convex hull of `points`; `apex` lies near those of them where the ways begin.
struct ShaftHull {
  dvec3 apex{0.0};
  std::array<dvec3, 8> points;

  [[nodiscard]] ShaftHull moved(const Affine& map) const {
    ShaftHull h;
    h.apex = map.point(apex);
    for (std::size_t i = 0; i < points.size(); ++i) h.points[i] = map.point(points[i]);
    return h;
  }
  [[nodiscard]] Bounds3 bounds() const {
    Bounds3 b;
    for (const dvec3 p : points) b.add(p);
    return b;
  }

  /// True if all of it lies before the plane through `origin` at `support` along `m`, which is not of
  /// unit length: dot(m, p - origin) > support, by more than rounding could feign.
  [[nodiscard]] bool beyond(dvec3 origin, dvec3 m, double support) const {
    double least = std::numeric_limits<double>::infinity();
    double size = 0;
    for (const dvec3 p : points) {
      const dvec3 way = p - origin;
      least = std::min(least, glm::dot(m, way));
      size = std::max(size, glm::dot(way, way));
    }
    const double most = std::max(size, glm::dot(origin, origin)) * glm::dot(m, m);
    return least > support + 1e-9 * std::sqrt(most);
  }
};

}  // namespace durer::tracer

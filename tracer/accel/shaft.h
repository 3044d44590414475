// All the ways from a point to an area at once [Haines and Wallace, "Shaft Culling for Efficient
// Ray-Traced Radiosity", 1991].
#pragma once

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "base/bounds.h"
#include "base/vec.h"
#include "tracer/accel/half_space.h"
#include "tracer/primitives/shaft_hull.h"

namespace durer::tracer {

/// A pyramid without its tip: what is nearer to `apex` than `begin` world units is outside, or at
/// least a part of that is.
class Shaft {
 public:
  /// `half_u`, `half_v`: from the parallelogram's `centre` to its edges.
  Shaft(dvec3 apex, dvec3 centre, dvec3 half_u, dvec3 half_v, double begin) : apex_(apex) {
    const std::array corners{centre - half_u - half_v, centre + half_u - half_v,
                             centre + half_u + half_v, centre - half_u + half_v};
    std::array<dvec3, 4> ways;
    double longest = 0;  // of the ways to anywhere in the area
    for (std::size_t i = 0; i < 4; ++i) {
      ways[i] = corners[i] - apex;
      longest = std::max(longest, glm::length(ways[i]));
    }
    const double share = longest > 0 ? begin / longest : 0;
    for (std::size_t i = 0; i < 4; ++i) {
      hull_.points[i] = corners[i];
      hull_.points[i + 4] = apex + share * ways[i];
      const dvec3 side = glm::cross(ways[i], ways[(i + 1) % 4]);
      sides_[i] = glm::dot(side, centre - apex) < 0 ? -side : side;  // inwards
    }
    hull_.apex = apex;
    box_ = hull_.bounds();
  }

  [[nodiscard]] const Bounds3& box() const { return box_; }
  [[nodiscard]] const ShaftHull& hull() const { return hull_; }
  /// It lies in these.
  [[nodiscard]] std::array<HalfSpace, 4> half_spaces() const {
    return {{{apex_, sides_[0]}, {apex_, sides_[1]}, {apex_, sides_[2]}, {apex_, sides_[3]}}};
  }

  /// False if nothing inside of `b` can be in the shaft. It may be true for boxes that are near.
  [[nodiscard]] bool meets(const Bounds3& b) const {
    for (int i = 0; i < 3; ++i) {
      if (b.hi[i] < box_.lo[i] || b.lo[i] > box_.hi[i]) return false;
    }
    for (const dvec3& n : sides_) {
      // The corner of the box that lies farthest inwards.
      const dvec3 corner(n.x > 0 ? b.hi.x : b.lo.x, n.y > 0 ? b.hi.y : b.lo.y,
                         n.z > 0 ? b.hi.z : b.lo.z);
      if (glm::dot(n, corner - apex_) < 0) return false;
    }
    return true;
  }

 private:
  dvec3 apex_;
  ShaftHull hull_;
  Bounds3 box_;
  std::array<dvec3, 4> sides_;  // normals, of any length
};

}  // namespace durer::tracer

// All the ways from a piece of a line to a point: a triangle.
#pragma once

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "base/bounds.h"
#include "base/vec.h"

namespace durer::tracer {

/// A triangle in space, as what boxes are held against.
class Sheet {
 public:
  explicit Sheet(const std::array<dvec3, 3>& corners) : corners_(corners) {
    for (const dvec3& c : corners_) box_.add(c);
    normal_ = glm::cross(corners_[1] - corners_[0], corners_[2] - corners_[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      sides_[i] = glm::cross(normal_, corners_[(i + 1) % 3] - corners_[i]);  // inwards
    }
  }

  [[nodiscard]] const std::array<dvec3, 3>& corners() const { return corners_; }

  /// False if nothing inside of `b` can be in the triangle. It may be true for boxes that are near.
  [[nodiscard]] bool meets(const Bounds3& b) const {
    for (int i = 0; i < 3; ++i) {
      if (b.hi[i] < box_.lo[i] || b.lo[i] > box_.hi[i]) return false;
    }
    if (beyond(b, corners_[0], normal_) || beyond(b, corners_[0], -normal_)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (beyond(b, corners_[i], sides_[i])) return false;
    }
    return true;
  }

 private:
  // True if all of the box lies behind the plane through `p`, as `n` looks.
  static bool beyond(const Bounds3& b, dvec3 p, dvec3 n) {
    const dvec3 farthest(n.x > 0 ? b.hi.x : b.lo.x, n.y > 0 ? b.hi.y : b.lo.y,
                         n.z > 0 ? b.hi.z : b.lo.z);
    return glm::dot(n, farthest - p) < 0;
  }

  std::array<dvec3, 3> corners_;
  Bounds3 box_;
  dvec3 normal_;  // of any length, as those of the sides
  std::array<dvec3, 3> sides_;
};

}  // namespace durer::tracer

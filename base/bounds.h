#pragma once

#include <algorithm>
#include <limits>

#include "base/transform.h"
#include "base/vec.h"

namespace durer {

/// Axis-aligned box, closed. Empty when some lo > hi. Unbounded sides lie at ±`unbounded`.
struct Bounds3 {
  dvec3 lo{std::numeric_limits<double>::infinity()};
  dvec3 hi{-std::numeric_limits<double>::infinity()};

  [[nodiscard]] static Bounds3 everything() { return {dvec3(-unbounded), dvec3(unbounded)}; }
  [[nodiscard]] bool empty() const { return lo.x > hi.x || lo.y > hi.y || lo.z > hi.z; }
  /// True if any side reaches ±`unbounded`: such objects stay outside the hierarchy.
  [[nodiscard]] bool infinite() const {
    for (int i = 0; i < 3; ++i) {
      if (lo[i] <= -unbounded || hi[i] >= unbounded) return true;
    }
    return false;
  }
  [[nodiscard]] bool contains(dvec3 p) const {
    return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y && p.z >= lo.z && p.z <= hi.z;
  }
  void add(dvec3 p) {
    for (int i = 0; i < 3; ++i) {
      lo[i] = std::min(lo[i], p[i]);
      hi[i] = std::max(hi[i], p[i]);
    }
  }
  void add(const Bounds3& b) {
    for (int i = 0; i < 3; ++i) {
      lo[i] = std::min(lo[i], b.lo[i]);
      hi[i] = std::max(hi[i], b.hi[i]);
    }
  }
  [[nodiscard]] Bounds3 intersection(const Bounds3& b) const {
    Bounds3 r;
    for (int i = 0; i < 3; ++i) {
      r.lo[i] = std::max(lo[i], b.lo[i]);
      r.hi[i] = std::min(hi[i], b.hi[i]);
    }
    return r;
  }
  /// Box of the eight transformed corners; everything() stays everything().
  [[nodiscard]] Bounds3 transformed(const Affine& m) const {
    if (empty() || infinite()) return empty() ? *this : everything();
    Bounds3 r;
    for (int i = 0; i < 8; ++i) {
      r.add(m.point(
          {(i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y, (i & 4) != 0 ? hi.z : lo.z}));
    }
    return r;
  }
};

}  // namespace durer

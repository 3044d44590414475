// A small bounding-box hierarchy in double precision, for questions that Embree does not answer:
// which boxes hold a point, which boxes does a piece of a line meet.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/bounds.h"
#include "base/ray.h"

namespace durer::tracer {

class BoxTree {
 public:
  BoxTree() = default;
  /// Boxes must be finite; empty ones are never found. All are grown().
  explicit BoxTree(std::span<const Bounds3> boxes);

  /// Larger by a relative 1e-9, so that what lies on a face is found in spite of rounding.
  [[nodiscard]] static Bounds3 grown(Bounds3 b);

  /// Calls f(index) for every box that holds `p`.
  template <typename F>
  void at(dvec3 p, F&& f) const {
    descend([p](const Bounds3& b) { return b.contains(p); }, f);
  }

  /// Calls f(index) for every box that meets the line in t_from <= t <= t_to.
  template <typename F>
  void along(const Ray& ray, double t_from, double t_to, F&& f) const {
    const dvec3 inverse = 1.0 / ray.d;
    descend([&](const Bounds3& b) { return meets(b, ray.o, inverse, t_from, t_to); }, f);
  }

  /// Calls f(index) for every box that passes `test`, which must hold for a box if it holds for one
  /// inside of it.
  template <typename Test, typename F>
  void meeting(Test&& test, F&& f) const {
    descend(test, f);
  }

  /// Clips t_from…t_to to the box; false if nothing remains. 0/0 (a ray in the plane of a face)
  /// counts as inside.
  static bool clip(const Bounds3& b, dvec3 o, dvec3 inverse, double& t_from, double& t_to) {
    for (int i = 0; i < 3; ++i) {
      double t1 = (b.lo[i] - o[i]) * inverse[i];
      double t2 = (b.hi[i] - o[i]) * inverse[i];
      if (t1 > t2) std::swap(t1, t2);
      if (t1 > t_from) t_from = t1;
      if (t2 < t_to) t_to = t2;
    }
    return t_from <= t_to;
  }

 private:
  struct Node {
    Bounds3 box;
    std::uint32_t first = 0;  // inner: left child, the right one follows; leaf: into order_
    std::uint32_t count = 0;  // 0: inner
  };

  static bool meets(const Bounds3& b, dvec3 o, dvec3 inverse, double t_from, double t_to) {
    return clip(b, o, inverse, t_from, t_to);
  }

  template <typename Test, typename F>
  void descend(Test&& test, F& f) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 64> stack;  // the tree is balanced: depth <= 32
    std::size_t top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      if (!test(node.box)) continue;
      if (node.count == 0) {
        stack[top++] = node.first + 1;
        stack[top++] = node.first;
        continue;
      }
      for (std::uint32_t i = 0; i < node.count; ++i) {
        const Entry& e = order_[node.first + i];
        if (node.count == 1 || test(e.box)) f(e.index);
      }
    }
  }

  struct Entry {
    Bounds3 box;
    std::uint32_t index = 0;
  };
  void split(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<Entry> order_;
};

}  // namespace durer::tracer

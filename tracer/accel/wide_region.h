// Walking through wide nodes: what is in a convex region. Everything here becomes part of its caller,
// and so is compiled for the caller's instruction set.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tracer/accel/half_space.h"
#include "tracer/accel/lanes.h"
#include "tracer/accel/wide_nodes.h"

namespace durer::tracer::wide {

/// A region as boxes see it: in single precision, relative to the tree's centre, and a little larger.
template <std::size_t Sides>
struct BoxRegion {
  struct Side {
    float n[3];
    float least;           // a box is outside if its innermost corner is below this
    std::size_t plane[3];  // which of Node::planes make that corner
  };
  float lo[3];
  float hi[3];
  Side sides[Sides];

  BoxRegion(const WideNodes& tree, const Bounds3& box, const std::array<HalfSpace, Sides>& spaces) {
    const dvec3 extent = tree.bounds.hi - tree.bounds.lo;
    const double size = std::max({extent.x, extent.y, extent.z});
    for (std::size_t k = 0; k < Sides; ++k) sides[k] = side(spaces[k], tree, size);
    for (int i = 0; i < 3; ++i) {
      const double slack = 1e-6 * (size + std::abs(box.lo[i]) + std::abs(box.hi[i]));
      lo[i] = static_cast<float>(box.lo[i] - tree.center[i] - slack);
      hi[i] = static_cast<float>(box.hi[i] - tree.center[i] + slack);
    }
  }

 private:
  static Side side(const HalfSpace& space, const WideNodes& tree, double size) {
    const dvec3 p = space.p - tree.center;
    const dvec3 away = glm::abs(p);
    const double length = glm::length(space.n);
    const dvec3 n = length > 0 ? space.n / length : dvec3(0.0);
    Side s;
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      s.n[i] = static_cast<float>(n[i]);
      s.plane[i] = n[i] > 0 ? axis + 3 : axis;
    }
    // Errors of single precision, a few 2^-24 of all that is added up.
    const double slack = 4e-6 * (size + std::max({away.x, away.y, away.z}));
    s.least = static_cast<float>(glm::dot(n, p) - slack);
    return s;
  }
};

/// A bit for every child whose box may meet the region.
template <std::size_t Sides>
DURER_INLINE unsigned children_in(const WideNodes::Node& node, const BoxRegion<Sides>& region) {
  const auto plane = [&node](std::size_t i) DURER_LAMBDA_INLINE {
    return load8(node.planes[i].data());
  };
  Int8 in = ~Int8{};
  for (std::size_t i = 0; i < 3; ++i) {
    in &= (plane(i) <= region.hi[i]) & (plane(i + 3) >= region.lo[i]);
  }
  for (const auto& s : region.sides) {
    in &= (plane(s.plane[0]) * s.n[0] + plane(s.plane[1]) * s.n[1] + plane(s.plane[2]) * s.n[2]) >=
          s.least;
  }
  return bits_of_8(in);
}

/// Calls leaf(number) for the leaves whose boxes may meet the region, until it returns false. A region
/// has a box() and half_spaces() that it lies in.
template <typename Region, typename Leaf>
DURER_INLINE void inside(const WideNodes& tree, const Region& region, Leaf&& leaf) {
  if (tree.bounds.empty()) return;
  const BoxRegion box_region(tree, region.box(), region.half_spaces());
  std::uint32_t stack[WideNodes::stack_size];
  std::size_t top = 0;
  stack[top++] = tree.root;
  while (top > 0) {
    const std::uint32_t next = stack[--top];
    if ((next & WideNodes::leaf_mark) != 0) {
      if (!leaf(next & ~WideNodes::leaf_mark)) return;
      continue;
    }
    const WideNodes::Node& node = tree.nodes[next];
    each_bit(children_in(node, box_region),
             [&](std::size_t i) DURER_LAMBDA_INLINE { stack[top++] = node.child[i]; });
  }
}

}  // namespace durer::tracer::wide

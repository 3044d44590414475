// Walking through wide nodes: what is in a shaft. Everything here becomes part of its caller, and so
// is compiled for the caller's instruction set.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tracer/accel/lanes.h"
#include "tracer/accel/shaft.h"
#include "tracer/accel/wide_nodes.h"

namespace durer::tracer::wide {

/// The shaft as boxes see it: in single precision, relative to the tree's centre, and a little larger.
struct BoxShaft {
  struct Side {
    float n[3];
    float least;           // a box is outside if its innermost corner is below this
    std::size_t plane[3];  // which of Node::planes make that corner
  };
  float lo[3];
  float hi[3];
  Side sides[4];

  BoxShaft(const WideNodes& tree, const Shaft& shaft) {
    const dvec3 apex = shaft.apex() - tree.center;
    const dvec3 extent = tree.bounds.hi - tree.bounds.lo;
    const dvec3 away = glm::abs(apex);
    // Errors of single precision, a few 2^-24 of all that is added up.
    const double slack = 1e-6 * (std::max({extent.x, extent.y, extent.z}) +
                                 std::max({away.x, away.y, away.z}));
    for (int i = 0; i < 3; ++i) {
      lo[i] = static_cast<float>(shaft.box().lo[i] - tree.center[i] - slack);
      hi[i] = static_cast<float>(shaft.box().hi[i] - tree.center[i] + slack);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const dvec3 side = shaft.sides()[k];
      const double length = glm::length(side);
      const dvec3 n = length > 0 ? side / length : dvec3(0.0);
      for (int i = 0; i < 3; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        sides[k].n[i] = static_cast<float>(n[i]);
        sides[k].plane[i] = n[i] > 0 ? axis + 3 : axis;
      }
      sides[k].least = static_cast<float>(glm::dot(n, apex) - 4 * slack);
    }
  }
};

/// A bit for every child whose box may meet the shaft.
DURER_INLINE unsigned children_in(const WideNodes::Node& node, const BoxShaft& shaft) {
  const auto plane = [&node](std::size_t i) DURER_LAMBDA_INLINE {
    return load8(node.planes[i].data());
  };
  Int8 in = ~Int8{};
  for (std::size_t i = 0; i < 3; ++i) {
    in &= (plane(i) <= shaft.hi[i]) & (plane(i + 3) >= shaft.lo[i]);
  }
  for (const BoxShaft::Side& s : shaft.sides) {
    in &= (plane(s.plane[0]) * s.n[0] + plane(s.plane[1]) * s.n[1] + plane(s.plane[2]) * s.n[2]) >=
          s.least;
  }
  return bits_of_8(in);
}

/// Calls leaf(number) for the leaves whose boxes may meet the shaft, until it returns false.
template <typename Leaf>
DURER_INLINE void in_shaft(const WideNodes& tree, const Shaft& shaft, Leaf&& leaf) {
  if (tree.bounds.empty()) return;
  const BoxShaft box_shaft(tree, shaft);
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
    each_bit(children_in(node, box_shaft),
             [&](std::size_t i) DURER_LAMBDA_INLINE { stack[top++] = node.child[i]; });
  }
}

}  // namespace durer::tracer::wide

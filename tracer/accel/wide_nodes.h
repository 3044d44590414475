// A hierarchy of boxes, eight to a node and tested together. Boxes are single precision and only
// choose; what is in them decides in double precision.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/bounds.h"

namespace durer::tracer {

struct WideNodes {
  static constexpr std::size_t width = 8;  // children of a node

  /// Boxes of the children, relative to the centre of the whole. Absent children are empty boxes.
  struct alignas(32) Node {
    std::array<std::array<float, width>, 6> planes;  // lo x, y, z; hi x, y, z
    std::array<std::uint32_t, width> child;          // node, or leaf_mark | number of the leaf
  };
  static constexpr std::uint32_t leaf_mark = 1U << 31;
  /// A walk leaves at most seven children waiting on each level; the builder makes 32 levels, and
  /// a few more where things cannot be told apart.
  static constexpr std::size_t stack_size = 7 * 48;

  std::vector<Node> nodes;
  std::uint32_t root = leaf_mark;
  Bounds3 bounds;  // of everything; empty: there is nothing
  Bounds3 reach;   // the same, with room for rounding
  dvec3 center{0.0};
  float pad = 0;  // by which boxes are larger than what is in them
};

}  // namespace durer::tracer

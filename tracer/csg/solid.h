// A solid as a program: leaves are placed primitives, inner nodes count how many of their children
// hold the point that the sweep has reached. Immutable; what changes lives in SweepState.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/texture.h"
#include "tracer/accel/box_tree.h"
#include "tracer/flatten.h"
#include "tracer/primitives/store.h"

namespace durer::tracer {

inline constexpr std::uint32_t no_node = 0xFFFFFFFF;

struct SolidNode {
  Op op = Op::all;  // never Op::leaf
  std::uint32_t parent = no_node;
  std::uint32_t children = 0;

  /// The node's truth when `count` of its children are true.
  [[nodiscard]] bool value(std::uint32_t count) const {
    return op == Op::all ? count == children : count > 0;
  }
  /// True if the other children let a surface of one child through, whose own truth is `child`:
  /// the oracle's rule, a hit counts inside all others (or outside all others, for `merge`).
  [[nodiscard]] bool passes(std::uint32_t count, bool child) const {
    const std::uint32_t others = count - (child ? 1 : 0);
    return op == Op::all ? others == children - 1 : op == Op::any || others == 0;
  }
};

struct SolidLeaf {
  const Store* store = nullptr;
  std::uint32_t shape = 0;
  std::uint32_t parent = 0;
  std::uint32_t slot = 0;  // index of `store` among the solid's stores
  bool inverted = false;
  bool muted = false;  // a clip: cuts, but its own surface is never seen
  std::uint8_t absent_for = 0;  // in a merge: for these rays (Visibility) it is not there at all
};

struct Solid {
  std::vector<SolidNode> nodes;  // parents before children; [0] is the root
  std::vector<SolidLeaf> leaves;
  std::vector<const Store*> stores;
  std::vector<std::uint32_t> counts;   // per node, with every leaf's inside empty
  std::vector<std::uint32_t> endless;  // leaves that any line may be inside of
  BoxTree boxes;                       // of the other leaves
  std::vector<std::uint32_t> leaf_of_box;
  Bounds3 surface;  // nothing is seen outside …
  Bounds3 inside;   // … and no point is inside outside this one
  /// A ray that misses this sees nothing, though there may be surface outside of it: `bounded_by`.
  Bounds3 gate = Bounds3::everything();
  // Where this solid's part of the arrays of SweepState begins.
  std::uint32_t first_node = 0;
  std::uint32_t first_leaf = 0;
};

/// Buffers of one sweep at a time.
struct SweepBuffers {
  std::vector<std::vector<LeafShape>> asked;  // per slot
  std::vector<std::uint32_t> begun;
  Crossings crossings;
  std::vector<std::uint32_t> flipped;  // leaves, in order: flipping them again restores the state
  std::vector<std::uint8_t> shown;     // per crossing of the present group
  struct Verdict {
    bool passes;
    bool value;
  };
  std::vector<Verdict> before;  // of coincident crossings, before they act
};

/// State of one thread. Between sweeps `counts` and `inside` hold every solid's resting state.
struct SweepState {
  std::vector<std::uint32_t> counts;
  std::vector<std::uint8_t> inside;
  SweepBuffers solids;
  SweepBuffers gates;  // gates are asked from within a sweep
};

}  // namespace durer::tracer

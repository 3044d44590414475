// Everything that is not a plain primitive: solids, and the bounds that gate leaves.
#pragma once

#include <memory>
#include <vector>

#include "tracer/csg/solid.h"

namespace durer::tracer {

/// `bounded_by`: a ray must meet the box, hit or start inside each of these solids, and pass the
/// outer gate.
struct Gate {
  Bounds3 box = Bounds3::everything();
  std::vector<std::uint32_t> solids;  // indices into Parts::solids
  std::uint32_t outer = scene::none;
};

struct Parts {
  std::vector<Solid> solids;
  std::vector<Gate> gates;
  std::vector<std::uint32_t> gate_of_leaf;
  std::uint32_t node_count = 0;  // of all solids
  std::uint32_t leaf_count = 0;

  [[nodiscard]] SweepState make_state() const;
};

}  // namespace durer::tracer

// `bounded_by`: where the bound is right it changes nothing; where it is wrong it cuts (objects
// §4).
#include "tracer/csg/build.h"
#include "tracer/csg/sweep.h"
#include "tracer/query.h"

namespace durer::tracer {
namespace {

bool meets(const Solid& solid, const RayQuery& query) {
  SweepState& state = *query.sweep;
  if (solid_contains(solid, query.ray.o, state)) return true;
  Sweep sweep(solid, state, state.gates);
  if (!sweep.begin(query.ray, t_min, no_hit_depth, 0)) return false;
  return sweep.walk(t_min, no_hit_depth,
                    [](const SolidLeaf& /*leaf*/, const Crossing& /*crossing*/) { return true; });
}

bool box_in_solid(const Solid& solid, const Bounds3& box) {
  if (solid.leaves.size() != 1 || solid.leaves[0].inverted) return false;
  const SolidLeaf& leaf = solid.leaves[0];
  if (!leaf.store->convex()) return false;
  for (int i = 0; i < 8; ++i) {
    const dvec3 corner((i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                       (i & 4) != 0 ? box.hi.z : box.lo.z);
    if (!leaf.store->contains(leaf.shape, corner)) return false;
  }
  return true;
}

}  // namespace

bool gates_open(std::uint32_t leaf, const RayQuery& query) {
  return gate_open(query.parts->gate_of_leaf[leaf], query);
}

bool gate_open(std::uint32_t gate, const RayQuery& query) {
  const Parts& parts = *query.parts;
  for (auto g = gate; g != scene::none; g = parts.gates[g].outer) {
    double t_from = t_min;
    double t_to = query.t_to;
    if (!BoxTree::clip(parts.gates[g].box, query.ray.o, 1.0 / query.ray.d, t_from, t_to)) {
      return false;
    }
    for (const std::uint32_t solid : parts.gates[g].solids) {
      if (!meets(parts.solids[solid], query)) return false;
    }
  }
  return true;
}

Bounds3 gate_bounds(const Parts& parts, std::uint32_t gate) {
  Bounds3 all = Bounds3::everything();
  for (auto g = gate; g != scene::none; g = parts.gates[g].outer) {
    all = all.intersection(parts.gates[g].box);
    for (const std::uint32_t solid : parts.gates[g].solids) {
      Bounds3 one = parts.solids[solid].surface;
      one.add(parts.solids[solid].inside);
      all = all.intersection(one);
    }
  }
  return all;
}

bool gate_holds(const Parts& parts, std::uint32_t gate, const Bounds3& box) {
  if (box.infinite()) return false;
  for (auto g = gate; g != scene::none; g = parts.gates[g].outer) {
    const Bounds3& cut = parts.gates[g].box;
    if (!cut.contains(box.lo) || !cut.contains(box.hi)) return false;
    for (const std::uint32_t solid : parts.gates[g].solids) {
      if (!box_in_solid(parts.solids[solid], box)) return false;
    }
  }
  return true;
}

}  // namespace durer::tracer

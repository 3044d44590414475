#include "tracer/csg/solid_targets.h"

#include "tracer/csg/sweep.h"
#include "tracer/query.h"

namespace durer::tracer {

SolidTargets::SolidTargets(const Parts& parts) : parts_(&parts) { nearest = &nearest_of; }

void SolidTargets::add(std::uint32_t solid) {
  solids_.push_back(solid);
  tags.emplace_back();
}

void SolidTargets::update_masks() {
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    tags[i].mask = 0;
    for (const SolidLeaf& leaf : parts_->solids[solids_[i]].leaves) {
      tags[i].mask |= leaf.store->tags[leaf.shape].mask;
    }
  }
}

Bounds3 SolidTargets::surface_bounds(std::uint32_t index) const {
  return parts_->solids[solids_[index]].surface;
}

void SolidTargets::nearest_of(const Targets& targets, std::uint32_t index, RayQuery& query) {
  const auto& self = static_cast<const SolidTargets&>(targets);
  if ((self.tags[index].mask & query.mask) == 0) return;
  const Solid& solid = self.parts_->solids[self.solids_[index]];
  if (!solid.gate.infinite()) {
    double t_from = t_min;
    double t_to = no_hit_depth;
    if (!BoxTree::clip(solid.gate, query.ray.o, 1.0 / query.ray.d, t_from, t_to)) return;
  }
  Sweep sweep(solid, *query.sweep, query.sweep->solids);
  if (!sweep.begin(query.ray, query.t_from, query.t_to, query.mask)) return;
  sweep.walk(query.t_from, query.t_to, [&](const SolidLeaf& leaf, const Crossing& crossing) {
    const Tag& tag = leaf.store->tags[leaf.shape];
    if ((tag.mask & query.mask) == 0) return false;
    if (tag.gated && !gates_open(tag.leaf, query)) return false;
    query.t_to = crossing.t;
    query.found = {leaf.store, leaf.shape, tag.leaf, crossing.part};
    return true;
  });
}

}  // namespace durer::tracer

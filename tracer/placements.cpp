#include "tracer/placements.h"

#include <glm/geometric.hpp>

namespace durer::tracer {

PlacementTargets::PlacementTargets(const std::vector<Placement>& all,
                                   const std::vector<Contents>& contents)
    : all_(&all), contents_(&contents) {
  nearest = &nearest_of;
}

void PlacementTargets::add(std::uint32_t placement, bool gated) {
  ids_.push_back(placement);
  Tag& tag = tags.emplace_back();
  tag.gated = gated;
}

void PlacementTargets::update_masks() {
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    tags[i].mask = (*contents_)[(*all_)[ids_[i]].group].mask;
  }
}

Bounds3 PlacementTargets::surface_bounds(std::uint32_t index) const {
  const Placement& placement = (*all_)[ids_[index]];
  return (*contents_)[placement.group].surface.transformed(placement.to_outer.forward);
}

// The ray goes on in the space of the contents, with a direction of unit length, as shapes expect.
void PlacementTargets::nearest_of(const Targets& targets, std::uint32_t index, RayQuery& query) {
  const auto& self = static_cast<const PlacementTargets&>(targets);
  const Tag& tag = self.tags[index];
  if ((tag.mask & query.mask) == 0) return;
  const std::uint32_t id = self.ids_[index];
  const Placement& placement = (*self.all_)[id];
  if (tag.gated && !gate_open(placement.gate, query)) return;
  const Affine& inward = placement.to_outer.backward;
  const dvec3 d = inward.vector(query.ray.d);
  const double scale = glm::length(d);
  RayQuery inner{{inward.point(query.ray.o), d / scale},
                 query.t_from * scale,
                 query.t_to * scale,
                 query.parts,
                 query.sweep,
                 nullptr,
                 {},
                 {},
                 query.mask,
                 query.any};
  const Accel& accel = *(*self.contents_)[placement.group].accel;
  if (query.any) {
    accel.any(inner);
  } else {
    accel.closest(inner);
  }
  if (inner.found.store == nullptr) return;
  query.t_to = inner.t_to / scale;
  query.found = inner.found;
  query.path = inner.path;
  query.path[query.found.depth++] = id;
}

}  // namespace durer::tracer

#include "tracer/accel/casters.h"

namespace durer::tracer {

CasterIndex::CasterIndex(std::span<const Targets* const> all) {
  std::vector<Bounds3> boxes;
  for (const Targets* targets : all) {
    for (std::uint32_t i = 0; i < targets->size(); ++i) {
      if ((targets->tags[i].mask & casts_shadow) == 0) continue;
      const Bounds3 b = targets->surface_bounds(i);
      if (b.empty()) continue;
      if (b.infinite()) {
        endless_.push_back({targets, i, BoxTree::grown(b)});
      } else {
        boxes.push_back(b);
        of_box_.push_back({targets, i, BoxTree::grown(b)});
      }
    }
  }
  boxes_ = BoxTree(boxes);
}

bool CasterIndex::gather(const Shaft& shaft, std::size_t most, std::vector<Caster>& out) const {
  out.clear();
  for (const Caster& c : endless_) {
    if (shaft.meets(c.box)) out.push_back(c);
  }
  boxes_.meeting([&](const Bounds3& b) { return out.size() <= most && shaft.meets(b); },
                 [&](std::uint32_t box) { out.push_back(of_box_[box]); });
  return out.size() <= most;
}

}  // namespace durer::tracer

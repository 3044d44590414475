#include "tracer/accel/casters.h"

#include <algorithm>

namespace durer::tracer {

CasterIndex::CasterIndex(std::span<const Targets* const> all) {
  std::vector<Bounds3> boxes;
  for (const Targets* targets : all) {
    const auto* lone = dynamic_cast<const Store*>(targets);
    for (std::uint32_t i = 0; i < targets->size(); ++i) {
      if ((targets->tags[i].mask & casts_shadow) == 0) continue;
      const Bounds3 b = targets->surface_bounds(i);
      if (b.empty()) continue;
      if (b.infinite()) {
        endless_.push_back({targets, i, lone, BoxTree::grown(b)});
      } else {
        boxes.push_back(b);
        of_box_.push_back({targets, i, lone, BoxTree::grown(b)});
      }
    }
  }
  boxes_ = BoxTree(boxes);
}

bool CasterIndex::gather(const Sheet& sheet, std::size_t most, std::vector<Caster>& out) const {
  if (!gather_from(sheet, most, out)) return false;
  const auto holds = [&](const Caster& c) {
    return c.lone != nullptr && c.lone->convex() &&
           std::all_of(sheet.corners().begin(), sheet.corners().end(),
                       [&](dvec3 p) { return c.lone->contains(c.index, p); });
  };
  out.erase(std::remove_if(out.begin(), out.end(), holds), out.end());
  return true;
}

}  // namespace durer::tracer

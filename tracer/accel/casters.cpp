#include "tracer/accel/casters.h"

#include <algorithm>
#include <utility>

#include "tracer/accel/box_tree.h"
#include "tracer/accel/wide_build.h"
#include "tracer/accel/wide_region.h"

namespace durer::tracer {
namespace {

bool in_the_way(const Caster& c, const Shaft& shaft) {
  return shaft.meets(c.box) && !c.targets->misses(c.index, shaft.hull());
}
bool in_the_way(const Caster& c, const Sheet& sheet) { return sheet.meets(c.box); }

/// Appends those of `all` in the tree that are in the way, until there are more than `most`.
template <typename Region>
DURER_INLINE void append(const WideNodes& nodes, const Region& region, const Caster* all,
                         std::size_t most, std::vector<Caster>& out) {
  wide::inside(nodes, region, [&](std::uint32_t i) DURER_LAMBDA_INLINE {
    if (in_the_way(all[i], region)) out.push_back(all[i]);
    return out.size() <= most;
  });
}
#if DURER_HAS_WIDE
template <typename Region>
DURER_WIDE void append_wide(const WideNodes& nodes, const Region& region, const Caster* all,
                            std::size_t most, std::vector<Caster>& out) {
  append(nodes, region, all, most, out);
}
#endif

}  // namespace

CasterIndex::CasterIndex(std::span<const Targets* const> all) {
  WideItems boxes;
  std::vector<Caster> found;
  for (const Targets* targets : all) {
    const auto* lone = dynamic_cast<const Store*>(targets);
    for (std::uint32_t i = 0; i < targets->size(); ++i) {
      if ((targets->tags[i].mask & casts_shadow) == 0) continue;
      const Bounds3 b = targets->surface_bounds(i);
      if (b.empty()) continue;
      if (b.infinite()) {
        endless_.push_back({targets, i, lone, BoxTree::grown(b)});
      } else {
        add_item(boxes, b, static_cast<std::uint32_t>(found.size()), nodes_);
        found.push_back({targets, i, lone, BoxTree::grown(b)});
      }
    }
  }
  build_wide_nodes(
      std::move(boxes), 1, nodes_, [this](std::size_t leaves) { finite_.reserve(leaves); },
      [&](std::span<const std::uint32_t> leaf) {
        finite_.push_back(found[leaf.front()]);
        return static_cast<std::uint32_t>(finite_.size() - 1);
      });
}

template <typename Region>
bool CasterIndex::gather_from(const Region& region, std::size_t most,
                              std::vector<Caster>& out) const {
  out.clear();
  for (const Caster& c : endless_) {
    if (in_the_way(c, region)) out.push_back(c);
  }
#if DURER_HAS_WIDE
  if (has_wide_vectors()) {
    append_wide(nodes_, region, finite_.data(), most, out);
    return out.size() <= most;
  }
#endif
  append(nodes_, region, finite_.data(), most, out);
  return out.size() <= most;
}

bool CasterIndex::gather(const Shaft& shaft, std::size_t most, std::vector<Caster>& out) const {
  return gather_from(shaft, most, out);
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

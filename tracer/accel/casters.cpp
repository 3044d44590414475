#include "tracer/accel/casters.h"

#include <cmath>
#include <utility>

#include "tracer/accel/box_tree.h"
#include "tracer/accel/wide_build.h"
#include "tracer/accel/wide_shaft.h"

namespace durer::tracer {
namespace {

/// Like BoxTree::grown, but sides that have no end do not move the others.
Bounds3 grown_each(Bounds3 b) {
  for (int i = 0; i < 3; ++i) {
    b.lo[i] -= 1e-9 * std::max(1e-3, std::abs(b.lo[i]));
    b.hi[i] += 1e-9 * std::max(1e-3, std::abs(b.hi[i]));
  }
  return b;
}

bool in_the_way(const Caster& c, const Shaft& shaft) {
  return shaft.meets(c.box) && !c.targets->misses(c.index, shaft.hull());
}

/// Appends those of `all` in the tree that meet the shaft, until there are more than `most`.
DURER_INLINE void gather_from(const WideNodes& nodes, const Shaft& shaft, const Caster* all,
                              std::size_t most, std::vector<Caster>& out) {
  wide::in_shaft(nodes, shaft, [&](std::uint32_t i) DURER_LAMBDA_INLINE {
    if (in_the_way(all[i], shaft)) out.push_back(all[i]);
    return out.size() <= most;
  });
}
#if DURER_HAS_WIDE
DURER_WIDE void gather_wide(const WideNodes& nodes, const Shaft& shaft, const Caster* all,
                            std::size_t most, std::vector<Caster>& out) {
  gather_from(nodes, shaft, all, most, out);
}
#endif

}  // namespace

CasterIndex::CasterIndex(std::span<const Targets* const> all) {
  WideItems boxes;
  std::vector<Caster> found;
  for (const Targets* targets : all) {
    for (std::uint32_t i = 0; i < targets->size(); ++i) {
      if ((targets->tags[i].mask & casts_shadow) == 0) continue;
      const Bounds3 b = targets->surface_bounds(i);
      if (b.empty()) continue;
      if (b.infinite()) {
        endless_.push_back({targets, i, grown_each(b)});
      } else {
        add_item(boxes, b, static_cast<std::uint32_t>(found.size()), nodes_);
        found.push_back({targets, i, BoxTree::grown(b)});
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

bool CasterIndex::gather(const Shaft& shaft, std::size_t most, std::vector<Caster>& out) const {
  out.clear();
  for (const Caster& c : endless_) {
    if (in_the_way(c, shaft)) out.push_back(c);
  }
#if DURER_HAS_WIDE
  if (has_wide_vectors()) {
    gather_wide(nodes_, shaft, finite_.data(), most, out);
    return out.size() <= most;
  }
#endif
  gather_from(nodes_, shaft, finite_.data(), most, out);
  return out.size() <= most;
}

}  // namespace durer::tracer

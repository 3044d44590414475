#include "tracer/primitives/blob_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/scene.h"
#include "tracer/accel/wide_build.h"

namespace durer::tracer {
namespace {

using Block = BlobData::Block;
using Double4 = double __attribute__((vector_size(32)));
using Long4 = std::int64_t __attribute__((vector_size(32)));

DURER_INLINE Double4 load(const std::array<double, BlobData::block_size>& a) {
  Double4 r;
  std::memcpy(&r, a.data(), sizeof r);
  return r;
}

DURER_INLINE unsigned bits_of(Long4 mask) {
#ifdef __SSE2__
  __m128d half[2];
  std::memcpy(half, &mask, sizeof mask);
  return static_cast<unsigned>(_mm_movemask_pd(half[0]) | (_mm_movemask_pd(half[1]) << 2));
#else
  unsigned bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= (mask[i] != 0 ? 1U : 0U) << i;
  return bits;
#endif
}

/// Of the components in the block, those that the line comes near to, a bit for each. `unit`:
/// 1 / |d|².
DURER_INLINE unsigned met_by(const Block& block, const Ray& ray, double unit) {
  const Double4 x = load(block.x) - ray.o.x;
  const Double4 y = load(block.y) - ray.o.y;
  const Double4 z = load(block.z) - ray.o.z;
  const Double4 t = (x * ray.d.x + y * ray.d.y + z * ray.d.z) * unit;
  const Double4 off_x = x - t * ray.d.x;
  const Double4 off_y = y - t * ray.d.y;
  const Double4 off_z = z - t * ray.d.z;
  return bits_of(off_x * off_x + off_y * off_y + off_z * off_z < load(block.radius2));
}

DURER_INLINE unsigned holding(const Block& block, dvec3 p) {
  const Double4 x = load(block.x) - p.x;
  const Double4 y = load(block.y) - p.y;
  const Double4 z = load(block.z) - p.z;
  return bits_of(x * x + y * y + z * z < load(block.radius2));
}

DURER_INLINE bool gather_in(const BlobData& blob, const Ray& ray, BlobReach reach,
                            BlobLine& line) {
  const double unit = 1 / glm::dot(ray.d, ray.d);
  bool full = false;
  const auto meet = [&](const BlobComponent& component) DURER_LAMBDA_INLINE {
    const std::size_t first = line.stretches.size();
    component.append_stretches(ray, unit, line.t_from, line.t_to, line.stretches);
    if (reach == BlobReach::whole) return;
    for (std::size_t k = first; k < line.stretches.size(); ++k) {
      const BlobStretch& s = line.stretches[k];
      if (!(s.full_begin < s.full_end)) continue;
      full = true;
      line.t_to = std::min(line.t_to, s.full_begin);
    }
  };
  wide::along(blob.tree, ray, line.t_from, line.t_to, [&](std::uint32_t i) DURER_LAMBDA_INLINE {
    const Block& block = blob.blocks[i];
    for (unsigned left = met_by(block, ray, unit); left != 0; left &= left - 1) {
      meet(blob.components[block.component[static_cast<std::size_t>(std::countr_zero(left))]]);
    }
    return full && reach == BlobReach::any_full ? line.t_from - 1 : line.t_to;
  });
  return full && reach == BlobReach::any_full;
}

DURER_INLINE dvec3 fall_in(const BlobData& blob, dvec3 p) {
  dvec3 sum(0.0);
  wide::at(blob.tree, p, [&](std::uint32_t i) DURER_LAMBDA_INLINE {
    const Block& block = blob.blocks[i];
    for (unsigned left = holding(block, p); left != 0; left &= left - 1) {
      sum += blob.components[block.component[static_cast<std::size_t>(std::countr_zero(left))]].fall(p);
    }
  });
  return sum;
}

#if DURER_HAS_WIDE
DURER_WIDE bool gather_wide(const BlobData& blob, const Ray& ray, BlobReach reach,
                            BlobLine& line) {
  return gather_in(blob, ray, reach, line);
}
DURER_WIDE dvec3 fall_wide(const BlobData& blob, dvec3 p) { return fall_in(blob, p); }
#endif

bool gather_any(const BlobData& blob, const Ray& ray, BlobReach reach, BlobLine& line) {
#if DURER_HAS_WIDE
  if (has_wide_vectors()) return gather_wide(blob, ray, reach, line);
#endif
  return gather_in(blob, ray, reach, line);
}

Block block_of(std::span<const std::uint32_t> items, const std::vector<BlobComponent>& all) {
  Block block{};
  block.radius2.fill(-1);
  block.count = static_cast<std::uint32_t>(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const BlobComponent& c = all[items[i]];
    const dvec3 middle = 0.5 * (c.reach.lo + c.reach.hi);
    const dvec3 half = 0.5 * (c.reach.hi - c.reach.lo);
    block.x[i] = middle.x, block.y[i] = middle.y, block.z[i] = middle.z;
    block.radius2[i] = (1 + 1e-6) * (c.moved_only ? c.radius2 : glm::dot(half, half));
    block.component[i] = items[i];
  }
  return block;
}

}  // namespace

BlobLine& BlobLine::of_thread(double t_from, double t_to) {
  thread_local BlobLine line;
  line.t_from = t_from;
  line.t_to = t_to;
  line.stretches.clear();
  line.order.clear();
  line.active.clear();
  return line;
}

double BlobLine::field_at_begin() const {
  double sum = 0;
  for (const BlobStretch* s : order) {
    if (s->begin > t_from) break;
    const double root = s->root_at(t_from);
    sum += s->strength * (root * root);
  }
  return sum;
}

BlobData::BlobData(double level, std::span<const double> list)
    : threshold(level), components(blob_components(list, level)) {
  WideItems items;
  bool all_add = true;
  for (std::uint32_t i = 0; i < components.size(); ++i) {
    const BlobComponent& c = components[i];
    add_item(items, c.reach, i, tree);
    seen.add(c.seen);
    textured = textured || c.texture != scene::none;
    all_add = all_add && c.strength > 0;
  }
  if (!all_add) {  // then no component is strong enough by itself
    for (BlobComponent& c : components) c.full = c.radius2;
  }
  build_wide_nodes(
      std::move(items), block_size, tree, [&](std::size_t leaves) { blocks.reserve(leaves); },
      [&](std::span<const std::uint32_t> of_leaf) {
        blocks.push_back(block_of(of_leaf, components));
        return static_cast<std::uint32_t>(blocks.size() - 1);
      });
}

bool BlobData::gather(const Ray& ray, BlobReach reach, BlobLine& line) const {
  if (gather_any(*this, ray, reach, line)) return true;
  for (const BlobStretch& s : line.stretches) line.order.push_back(&s);
  std::sort(line.order.begin(), line.order.end(),
            [](const BlobStretch* a, const BlobStretch* b) { return a->begin < b->begin; });
  return false;
}

dvec3 BlobData::fall(dvec3 p) const {
#if DURER_HAS_WIDE
  if (has_wide_vectors()) return fall_wide(*this, p);
#endif
  return fall_in(*this, p);
}

}  // namespace durer::tracer

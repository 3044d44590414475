#include "tracer/primitives/blob_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/scene.h"
#include "tracer/accel/wide_build.h"

namespace durer::tracer {
namespace {

using Block = BlobData::Block;
using wide::Double4;
using wide::load4;

/// What a line meets of the balls of a block, a lane for each.
struct Meeting {
  Double4 middle, top, begin, end, full_begin, full_end;
  unsigned met;  // a bit for each
};

/// `unit`: 1 / |d|².
DURER_INLINE Meeting meet(const Block& block, const Ray& ray, double unit, const BlobLine& line) {
  const Double4 x = load4(block.x) - ray.o.x;
  const Double4 y = load4(block.y) - ray.o.y;
  const Double4 z = load4(block.z) - ray.o.z;
  Meeting m;
  m.middle = (x * ray.d.x + y * ray.d.y + z * ray.d.z) * unit;
  const Double4 off_x = x - m.middle * ray.d.x;
  const Double4 off_y = y - m.middle * ray.d.y;
  const Double4 off_z = z - m.middle * ray.d.z;
  const Double4 radius2 = load4(block.radius2);
  m.top = radius2 - (off_x * off_x + off_y * off_y + off_z * off_z);
  m.met = wide::bits_of_4(m.top > epsilon * radius2);
  if (m.met == 0) return m;
  // Lanes that hold no number are compared, and left out.
  const Double4 half = wide::root_of(m.top * unit);
  m.begin = wide::greater_of(m.middle - half, line.t_from + Double4{});
  m.end = wide::less_of(m.middle + half, line.t_to + Double4{});
  m.met &= wide::bits_of_4(m.begin < m.end);
  const Double4 more = m.top - load4(block.full);
  const Double4 full_half = wide::root_of(more * unit);
  constexpr double never = std::numeric_limits<double>::infinity();
  const Double4 full_begin = wide::greater_of(m.middle - full_half, m.begin);
  m.full_begin = more > Double4{} ? full_begin : never + Double4{};
  m.full_end = wide::less_of(m.middle + full_half, m.end);
  return m;
}

DURER_INLINE bool gather_in(const BlobData& blob, const Ray& ray, BlobReach reach,
                            BlobLine& line) {
  const double bend = glm::dot(ray.d, ray.d);
  const double unit = 1 / bend;
  bool full = false;
  const auto look_at = [&](const BlobStretch& s) DURER_LAMBDA_INLINE {
    if (reach == BlobReach::whole || !(s.full_begin < s.full_end)) return;
    full = true;
    line.t_to = std::min(line.t_to, s.full_begin);
  };
  wide::along(blob.tree, ray, line.t_from, line.t_to, [&](std::uint32_t i) DURER_LAMBDA_INLINE {
    const Block& block = blob.blocks[i];
    const Meeting m = meet(block, ray, unit, line);
    wide::each_bit(m.met & ~block.others, [&](std::size_t k) DURER_LAMBDA_INLINE {
      line.stretches.push_back({m.begin[k], m.end[k], m.middle[k], m.top[k], bend,
                                block.strength[k], m.full_begin[k], m.full_end[k]});
      look_at(line.stretches.back());
    });
    wide::each_bit(m.met & block.others, [&](std::size_t k) DURER_LAMBDA_INLINE {
      std::size_t next = line.stretches.size();
      blob.components[block.component[k]].append_stretches(ray, line.t_from, line.t_to,
                                                           line.stretches);
      for (; next < line.stretches.size(); ++next) look_at(line.stretches[next]);
    });
    return full && reach == BlobReach::any_full ? line.t_from - 1 : line.t_to;
  });
  return full && reach == BlobReach::any_full;
}

DURER_INLINE dvec3 fall_in(const BlobData& blob, dvec3 p) {
  Double4 sum_x{};
  Double4 sum_y{};
  Double4 sum_z{};
  dvec3 others(0.0);
  wide::at(blob.tree, p, [&](std::uint32_t i) DURER_LAMBDA_INLINE {
    const Block& block = blob.blocks[i];
    const Double4 x = p.x - load4(block.x);
    const Double4 y = p.y - load4(block.y);
    const Double4 z = p.z - load4(block.z);
    const Double4 root = load4(block.radius2) - (x * x + y * y + z * z);
    const Double4 steep = wide::greater_of(root, Double4{}) * load4(block.strength);
    sum_x += steep * x;
    sum_y += steep * y;
    sum_z += steep * z;
    wide::each_bit(block.others & wide::bits_of_4(root > Double4{}), [&](std::size_t k) {
      others += blob.components[block.component[k]].fall(p);
    });
  });
  const auto all = [](Double4 v) { return (v[0] + v[1]) + (v[2] + v[3]); };
  return 4.0 * dvec3(all(sum_x), all(sum_y), all(sum_z)) + others;
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
    const dvec3 middle = c.plain ? -c.to_own.t : 0.5 * (c.reach.lo + c.reach.hi);
    const dvec3 half = 0.5 * (c.reach.hi - c.reach.lo);
    block.x[i] = middle.x, block.y[i] = middle.y, block.z[i] = middle.z;
    block.component[i] = items[i];
    if (c.plain) {
      block.radius2[i] = c.radius2;
      block.strength[i] = c.strength;
      block.full[i] = c.full;
    } else {
      block.radius2[i] = (1 + 1e-6) * glm::dot(half, half);
      block.others |= 1U << i;
    }
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

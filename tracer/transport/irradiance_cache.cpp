#include "tracer/transport/irradiance_cache.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "tracer/accel/lanes.h"

namespace durer::tracer {

double weight_of(const IrradianceSample& s, const IrradianceQuery& q) {
  const dvec3 delta = q.p - s.p;
  const double square = glm::dot(delta, delta);
  const double far = s.radius * q.error;
  if (square >= far * far) return 0;
  const double distance = std::sqrt(square);
  const bool apart = distance > 1e-6;
  const dvec3 u = apart ? delta / distance : dvec3(0.0);
  double radius = s.radius;
  if (const double c = glm::dot(s.to_nearest, u); c > 0) {
    radius = c * s.nearest + (1 - c) * s.radius;
    if (distance >= radius * q.error) return 0;
  }
  const double error =
      distance / radius + 2 * std::sqrt(std::abs(1 - glm::dot(q.n, s.n)));
  if (!(error < q.error)) return 0;
  // A point in front of the other is lit by things that the other does not see.
  const double in_front = apart ? glm::dot(u, glm::normalize(q.n + s.n)) : 1.0;
  constexpr double behind = 0.05;
  if (!(in_front > -behind)) return 0;
  const double t = error / q.error;
  double w = 1 - t;
  if (q.smooth) w = t < 0.5 ? 1 - 2 * t * t : 2 * (1 - t) * (1 - t);
  if (in_front <= 0) w *= 1 + in_front / behind;
  return w > 0.001 ? w * s.quality : 0;
}

namespace {

// As std::floor, of what fits; without a call where the processor's basic instructions lack it.
DURER_INLINE std::int64_t whole(double v) {
  const auto cut = static_cast<std::int64_t>(v);
  return cut - (v < static_cast<double>(cut) ? 1 : 0);
}

}  // namespace

DURER_INLINE std::uint64_t IrradianceCache::cell(std::uint32_t depth, int level, dvec3 scaled) {
  // Spread first: a level must not be made up for by a coordinate.
  std::uint64_t h =
      ((std::uint64_t{depth} << 8) + static_cast<std::uint64_t>(level)) * 0xD1B54A32D192ED03U;
  for (int i = 0; i < 3; ++i) {
    h = (h ^ static_cast<std::uint64_t>(whole(scaled[i]))) * 0x9E3779B97F4A7C15U;
    h ^= h >> 29;
  }
  return h;
}

// The other half of the hash than the one that chooses a slot.
void IrradianceCache::mark(std::uint64_t cell) {
  const std::uint64_t bit = cell >> 32 & (64 * marks_.size() - 1);
  marks_[bit / 64] |= std::uint64_t{1} << bit % 64;
}
DURER_INLINE bool IrradianceCache::is_marked(std::uint64_t cell) const {
  const std::uint64_t bit = cell >> 32 & (64 * marks_.size() - 1);
  return (marks_[bit / 64] >> bit % 64 & 1U) != 0;
}

DURER_INLINE std::uint32_t IrradianceCache::first_in(std::uint64_t cell) const {
  if (slots_.empty() || !is_marked(cell)) return nothing;
  std::size_t i = cell & (slots_.size() - 1);
  while (slots_[i].first != nothing && slots_[i].cell != cell) i = (i + 1) & (slots_.size() - 1);
  return slots_[i].first;
}

void IrradianceCache::add(const IrradianceSample& sample, double reach) {
  const auto id = static_cast<std::uint32_t>(samples_.size());
  samples_.push_back(sample);
  const double side = std::clamp(2 * reach, 0x1p-31, 0x1p31);
  const int level = std::ilogb(side) + 1 + level_of_one;
  levels_used_[sample.depth] |= std::uint64_t{1} << level;
  const double scale = std::ldexp(1.0, level_of_one - level);
  const dvec3 lo = glm::floor((sample.p - reach) * scale);
  const dvec3 hi = glm::floor((sample.p + reach) * scale);
  for (double x = lo.x; x <= hi.x; ++x) {
    for (double y = lo.y; y <= hi.y; ++y) {
      for (double z = lo.z; z <= hi.z; ++z) {
        put(id, first_in(cell(sample.depth, level, {x, y, z})), dvec3(x, y, z) / scale);
      }
    }
  }
}

void IrradianceCache::put(std::uint32_t id, std::uint32_t& first, dvec3 origin) {
  if (first == nothing || blocks_[first].open == 0) {
    Block block{};
    for (Eight& axis : block.p) axis.fill(std::numeric_limits<float>::infinity());
    block.origin = origin;
    block.next = first;
    block.open = lanes;
    first = static_cast<std::uint32_t>(blocks_.size());
    blocks_.push_back(block);
  }
  Block& block = blocks_[first];
  const IrradianceSample& s = samples_[id];
  const std::size_t lane = --block.open;
  const vec3 p(s.p - block.origin);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<int>(axis);
    block.p[axis][lane] = p[i];
    block.n[axis][lane] = static_cast<float>(s.n[i]);
    block.to_nearest[axis][lane] = static_cast<float>(s.to_nearest[i]);
  }
  block.radius[lane] = static_cast<float>(s.radius);
  block.nearest[lane] = static_cast<float>(s.nearest);
  block.sample[lane] = id;
}

struct IrradianceCache::Look {
  dvec3 p;
  vec3 n;
  float error;
  float side;  // of a cell
};

// Bits of the lanes that may have a weight. The same steps as in weight_of(), in single precision: so
// bounds are a little wider than there, by what rounding may do to numbers of a cell's size.
DURER_INLINE unsigned IrradianceCache::near_lanes(const Block& block, const Look& look) {
  using wide::Float8;
  using wide::load8;
  constexpr float rounding = 1e-5F;
  constexpr float rounding_of_angle = 2e-3F;  // 2·sqrt() of that of the cosine
  const vec3 q(look.p - block.origin);
  const Float8 x = q.x - load8(block.p[0].data());
  const Float8 y = q.y - load8(block.p[1].data());
  const Float8 z = q.z - load8(block.p[2].data());
  const Float8 square = x * x + y * y + z * z;
  const Float8 radius = load8(block.radius.data());
  const Float8 far = radius * (look.error * (1 + rounding)) + look.side * rounding;
  const auto in_reach = square < far * far;
  if (wide::bits_of_8(in_reach) == 0) return 0;

  const Float8 cosine = look.n.x * load8(block.n[0].data()) + look.n.y * load8(block.n[1].data()) +
                        look.n.z * load8(block.n[2].data());
  const Float8 turn = wide::greater_of(1 - cosine, cosine - 1);
  const Float8 error_left = look.error * (1 + rounding) + rounding_of_angle - 2 * wide::root_of(turn);
  const Float8 towards =
      wide::greater_of(x * load8(block.to_nearest[0].data()) + y * load8(block.to_nearest[1].data()) +
                           z * load8(block.to_nearest[2].data()),
                       Float8{});
  // The radius in that direction, times the distance.
  const Float8 scaled = radius * wide::root_of(square) - towards * (radius - load8(block.nearest.data()));
  const float slack = 10 * rounding * look.side * look.side;
  const auto useful = square <= error_left * scaled * (1 + 10 * rounding) + slack;
  return wide::bits_of_8(in_reach & useful & (error_left > 0));
}

DURER_INLINE void IrradianceCache::look_into_all(const IrradianceQuery& query,
                                                 IrradianceSum& sum) const {
  struct Cell {
    std::uint32_t first;
    float side;
  };
  std::array<Cell, levels> cells;
  std::size_t count = 0;
  // All levels are looked up before any block is opened, so that the processor need not wait for one
  // after the other.
  for (std::uint64_t left = levels_used_[query.depth]; left != 0; left &= left - 1) {
    const int level = std::countr_zero(left);
    // 2 to the power of what is missing to the level whose cells have side 1.
    const auto scale = std::bit_cast<double>(std::uint64_t(1023 + level_of_one - level) << 52);
    const std::uint32_t first = first_in(cell(query.depth, level, query.p * scale));
    cells[count] = {first, static_cast<float>(1 / scale)};
    count += first != nothing ? 1 : 0;
  }
  const bool enough = sum.weight >= query.plenty;
  Look look{query.p, vec3(query.n), static_cast<float>(query.error), 0};
  for (std::size_t i = 0; i < count; ++i) {
    look.side = cells[i].side;
    for (std::uint32_t at = cells[i].first; at != nothing; at = blocks_[at].next) {
      const Block& block = blocks_[at];
      // Who has enough already hears one more, whoever that is.
      unsigned lanes_left = enough ? 1U << block.open : near_lanes(block, look);
      for (; lanes_left != 0; lanes_left &= lanes_left - 1) {
        const IrradianceSample& s = samples_[block.sample[std::countr_zero(lanes_left)]];
        if (s.depth != query.depth) continue;  // cells may share a slot
        const double w = weight_of(s, query);
        sum.light += w * dvec3(s.light);
        sum.weight += w;
        if (sum.weight >= query.plenty) return;
      }
    }
  }
}

#if DURER_HAS_WIDE
DURER_WIDE void IrradianceCache::look_wide(const IrradianceQuery& query, IrradianceSum& sum) const {
  look_into_all(query, sum);
}
#endif

void IrradianceCache::look_up(const IrradianceQuery& query, IrradianceSum& sum) const {
#if DURER_HAS_WIDE
  if (has_wide_vectors()) return look_wide(query, sum);
#endif
  look_into_all(query, sum);
}

void IrradianceCache::clear() {
  if (empty()) return;
  samples_.clear();
  blocks_.clear();
  std::fill(slots_.begin(), slots_.end(), Slot{});
  std::fill(marks_.begin(), marks_.end(), 0U);
  used_ = 0;
  levels_used_ = {};
}

std::uint32_t& IrradianceCache::first_in(std::uint64_t cell) {
  if (2 * (used_ + 1) > slots_.size()) grow();
  std::size_t i = cell & (slots_.size() - 1);
  while (slots_[i].first != nothing && slots_[i].cell != cell) i = (i + 1) & (slots_.size() - 1);
  if (slots_[i].first == nothing) {
    slots_[i].cell = cell;
    mark(cell);
    ++used_;
  }
  return slots_[i].first;
}

void IrradianceCache::grow() {
  std::vector<Slot> old(std::max<std::size_t>(64, 2 * slots_.size()));
  old.swap(slots_);
  marks_.assign(slots_.size() / 16, 0);  // eight bits for a cell, at least
  for (const Slot& s : old) {
    if (s.first == nothing) continue;
    std::size_t i = s.cell & (slots_.size() - 1);
    while (slots_[i].first != nothing) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = s;
    mark(s.cell);
  }
}

}  // namespace durer::tracer

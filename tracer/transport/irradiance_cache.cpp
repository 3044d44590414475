#include "tracer/transport/irradiance_cache.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

std::uint64_t IrradianceCache::cell(std::uint32_t depth, int level, dvec3 scaled) {
  // Spread first: a level must not be made up for by a coordinate.
  std::uint64_t h =
      ((std::uint64_t{depth} << 8) + static_cast<std::uint64_t>(level)) * 0xD1B54A32D192ED03U;
  for (int i = 0; i < 3; ++i) {
    h = (h ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(scaled[i])))) *
        0x9E3779B97F4A7C15U;
    h ^= h >> 29;
  }
  return h;
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
        std::uint32_t& first = first_in(cell(sample.depth, level, {x, y, z}));
        entries_.push_back({id, first});
        first = static_cast<std::uint32_t>(entries_.size() - 1);
      }
    }
  }
}

void IrradianceCache::look_up(const IrradianceQuery& query, IrradianceSum& sum) const {
  for (std::uint64_t left = levels_used_[query.depth]; left != 0; left &= left - 1) {
    const int level = std::countr_zero(left);
    const double scale = std::ldexp(1.0, level_of_one - level);
    for (std::uint32_t at = first_in(cell(query.depth, level, query.p * scale)); at != nothing;
         at = entries_[at].next) {
      const IrradianceSample& s = samples_[entries_[at].sample];
      if (s.depth != query.depth) continue;  // cells may share a slot
      const double w = weight_of(s, query);
      sum.light += w * dvec3(s.light);
      sum.weight += w;
      if (sum.weight >= query.plenty) return;
    }
  }
}

void IrradianceCache::clear() {
  if (empty()) return;
  samples_.clear();
  entries_.clear();
  std::fill(slots_.begin(), slots_.end(), Slot{});
  used_ = 0;
  levels_used_ = {};
}

std::uint32_t& IrradianceCache::first_in(std::uint64_t cell) {
  if (2 * (used_ + 1) > slots_.size()) grow();
  std::size_t i = cell & (slots_.size() - 1);
  while (slots_[i].first != nothing && slots_[i].cell != cell) i = (i + 1) & (slots_.size() - 1);
  if (slots_[i].first == nothing) {
    slots_[i].cell = cell;
    ++used_;
  }
  return slots_[i].first;
}

std::uint32_t IrradianceCache::first_in(std::uint64_t cell) const {
  if (slots_.empty()) return nothing;
  std::size_t i = cell & (slots_.size() - 1);
  while (slots_[i].first != nothing && slots_[i].cell != cell) i = (i + 1) & (slots_.size() - 1);
  return slots_[i].first;
}

void IrradianceCache::grow() {
  std::vector<Slot> old(std::max<std::size_t>(64, 2 * slots_.size()));
  old.swap(slots_);
  for (const Slot& s : old) {
    if (s.first == nothing) continue;
    std::size_t i = s.cell & (slots_.size() - 1);
    while (slots_[i].first != nothing) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = s;
  }
}

}  // namespace durer::tracer

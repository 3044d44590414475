#include "tracer/primitives/field_packet.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "tracer/accel/lanes.h"
#include "tracer/primitives/field_search.h"
#include "tracer/primitives/field_walk.h"

namespace durer::tracer {
namespace {

using wide::each_bit;

/// Which way a line goes along each axis, in three bits.
unsigned octant_of(const dvec3& d) {
  return (std::signbit(d.x) ? 1U : 0U) | (std::signbit(d.y) ? 2U : 0U) |
         (std::signbit(d.z) ? 4U : 0U);
}

}  // namespace

void FieldPacket::run(std::span<const PacketRay> rays, std::span<std::optional<Nearest>> hits) {
  rays_ = rays;
  hits_ = hits;
  std::fill(hits.begin(), hits.end(), std::nullopt);
  start(rays);
  while (open_ != 0) {
    const Mask together = like_directed(open_);
    walk_field(*this, together);
    leave(together & open_);
  }
}

void FieldPacket::start(std::span<const PacketRay> rays) {
  const dvec3 centre = field_.centre();
  const double size = glm::length(field_.half());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto& [ray, t_from, t_to] = rays[i];
    const auto stretch = stretch_in(surface_.container, ray);
    if (!stretch || !(stretch->to >= t_from) || !(stretch->from < t_to)) continue;
    const Mask bit = Mask{1} << i;
    const bool entering = stretch->from >= t_from;
    const double begin = entering ? stretch->from : t_from;
    const dvec3 p = ray.at(begin);
    const double unit = 1 / glm::length(ray.d);
    stretch_[i] = *stretch;
    begin_[i] = begin;
    fine_[i] = 1e-8 * size * unit;
    doubt_[i] = static_cast<float>(4e-6 * size * unit);
    end_[i] = static_cast<float>(std::min(stretch->to, t_to) - begin);
    open_ |= bit;
    if (entering) entering_ |= bit;
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      p_[axis][i] = p[k];
      d_[axis][i] = ray.d[k];
      near_p_[axis][i] = static_cast<float>(p[k] - centre[k]);
      near_d_[axis][i] = static_cast<float>(ray.d[k]);
      inverse_[axis][i] = static_cast<float>(std::clamp(1 / ray.d[k], -1e30, 1e30));
    }
  }
  if (open_ == 0) return;
  // Idle lanes repeat one that is not, so that none is slow or gets lost.
  const auto any = static_cast<std::size_t>(std::countr_zero(open_));
  for (std::size_t i = 0; i < size; ++i) {
    if ((open_ >> i & 1) != 0) continue;
    fine_[i] = fine_[any];
    doubt_[i] = doubt_[any];
    end_[i] = end_[any];
    for (std::size_t k = 0; k < 3; ++k) {
      p_[k][i] = p_[k][any];
      d_[k][i] = d_[k][any];
      near_p_[k][i] = near_p_[k][any];
      near_d_[k][i] = near_d_[k][any];
      inverse_[k][i] = inverse_[k][any];
    }
  }
}

/// Those lanes that meet the halves of cells in the same order as the first of them.
FieldPacket::Mask FieldPacket::like_directed(Mask lanes) const {
  const unsigned octant = octant_of(rays_[static_cast<std::size_t>(std::countr_zero(lanes))].ray.d);
  Mask alike = 0;
  each_bit(lanes, [&](std::size_t i) {
    if (octant_of(rays_[i].ray.d) == octant) alike |= Mask{1} << i;
  });
  return alike;
}

void FieldPacket::hit(std::size_t lane, double t, std::uint32_t part) {
  open_ &= ~(Mask{1} << lane);
  if (t < rays_[lane].t_to) hits_[lane] = Nearest{t, part};
}

/// A side that is known to hold from `where` on.
void FieldPacket::settle(Mask lanes, bool inside, const PerLane<float>& where) {
  const Mask now = inside ? lanes : 0;
  const Mask changed = lanes & known_ & (inside_ ^ now);
  const Mask starting = lanes & ~known_;
  known_ |= lanes;
  inside_ = (inside_ & ~lanes) | now;
  each_bit(changed, [&](std::size_t i) {
    hit(i, begin_[i] + static_cast<double>(where[i]), 0);
  });
  if (!inside || surface_.open) return;
  each_bit(starting & entering_,
           [&](std::size_t i) { hit(i, stretch_[i].from, stretch_[i].face_from); });
}

/// The rest of a line in a part of the field that is too rough for many at once.
void FieldPacket::alone(std::size_t lane, float from) {
  const Mask bit = Mask{1} << lane;
  const bool known = (known_ & bit) != 0;
  const bool was_inside = (inside_ & bit) != 0;
  const PacketRay& ray = rays_[lane];
  const Stretch rest{begin_[lane] + static_cast<double>(from), stretch_[lane].to, 0, 0};
  FieldSearch search(field_, ray.ray, rest.from, ray.t_to, least_);
  const int last = search.run(rest, [&](double t, int sign) {
    const bool inside = sign < 0;
    if (t > rest.from || (known && inside != was_inside)) {
      hit(lane, t, 0);
      return true;
    }
    if (known || !inside || surface_.open || (entering_ & bit) == 0) return false;
    hit(lane, stretch_[lane].from, stretch_[lane].face_from);
    return true;
  });
  if ((open_ & bit) == 0) return;
  known_ |= bit;
  inside_ = last < 0 ? inside_ | bit : inside_ & ~bit;
  leave(bit);
}

/// Lines that have come to their ends.
void FieldPacket::leave(Mask lanes) {
  open_ &= ~lanes;
  if (surface_.open) return;
  each_bit(lanes & known_ & inside_, [&](std::size_t i) {
    hit(i, stretch_[i].to, stretch_[i].face_to);
  });
}

}  // namespace durer::tracer

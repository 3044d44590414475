#include "tracer/primitives/field_packet.h"

#include <algorithm>

#include "tracer/accel/lanes.h"
#include "tracer/primitives/container.h"
#include "tracer/primitives/field_search.h"
#include "tracer/primitives/field_walk.h"

namespace durer::tracer {

using wide::each_bit;

void FieldPacket::run(std::span<const PacketRay> rays, std::span<std::optional<Nearest>> hits) {
  rays_ = rays;
  hits_ = hits;
  std::fill(hits.begin(), hits.end(), std::nullopt);
  // Idle lanes repeat one that is not.
  for (std::size_t i = 0; i < size; ++i) {
    const PacketRay& ray = rays[std::min(i, rays.size() - 1)];
    for (int k = 0; k < 3; ++k) {
      p_[static_cast<std::size_t>(k)][i] = ray.ray.o[k];
      d_[static_cast<std::size_t>(k)][i] = ray.ray.d[k];
    }
    t_from_[i] = ray.t_from;
    t_to_[i] = ray.t_to;
  }
  walk_field(*this);
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
  each_bit(starting & entering_, [&](std::size_t i) { enter(i); });
}

void FieldPacket::enter(std::size_t lane) {
  hit(lane, enter_[lane], face(near_, lane, enter_[lane], false));
}

/// The face of the container that a line meets at t.
std::uint32_t FieldPacket::face(const std::array<PerLane<double>, 3>& at, std::size_t lane,
                                double t, bool far) const {
  if (surface_.container.kind == scene::Container::Kind::sphere) return sphere_part;
  std::size_t k = 0;
  while (k < 2 && at[k][lane] != t) ++k;
  const bool high = (d_[k][lane] > 0) == far;
  return static_cast<std::uint32_t>(2 * k + 1) + (high ? 1 : 0);
}

/// A line in a cell that is too rough for many at once.
void FieldPacket::alone(std::size_t lane, const FieldCell& cell, const FieldDetail& detail,
                        float from, float to) {
  const Mask bit = Mask{1} << lane;
  const bool known = (known_ & bit) != 0;
  const int before = known ? ((inside_ & bit) != 0 ? -1 : 1) : 0;
  const Stretch part{begin_[lane] + static_cast<double>(from),
                     begin_[lane] + static_cast<double>(to), 0, 0};
  const bool at_face = !surface_.open && (entering_ & bit) != 0;
  FieldSearch search(field_, rays_[lane].ray, part.from, part.to, least_);
  const int last = search.run_in(cell, detail, part, before, [&](double t, int sign) {
    if (before != 0 || t > part.from) {
      hit(lane, t, 0);
      return true;
    }
    if (sign < 0 && at_face) enter(lane);
    return (open_ & bit) == 0;
  });
  if (last == 0) return;
  known_ |= bit;
  inside_ = last < 0 ? inside_ | bit : inside_ & ~bit;
}

/// Lines that have come to their ends.
void FieldPacket::leave(Mask lanes) {
  open_ &= ~lanes;
  if (surface_.open) return;
  each_bit(lanes & known_ & inside_, [&](std::size_t i) {
    hit(i, leave_[i], face(far_, i, leave_[i], true));
  });
}

}  // namespace durer::tracer

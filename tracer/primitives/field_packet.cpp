#include "tracer/primitives/field_packet.h"

#include <algorithm>

#include "tracer/accel/lanes.h"
#include "tracer/primitives/container.h"
#include "tracer/primitives/field_search.h"

namespace durer::tracer {

using wide::each_bit;

void FieldPacket::run(std::span<const PacketRay> rays, std::span<std::optional<Nearest>> hits,
                      FieldWalkVersion walk) {
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
  walk(*this);
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
  each_bit(changed, [&](std::size_t i) { hit(i, begin_[i] + static_cast<double>(where[i]), 0); });
  if (!inside || surface_.open) return;
  each_bit(starting & entering_, [&](std::size_t i) { enter(i); });
}

void FieldPacket::enter(std::size_t lane) { hit_face(lane, near_, enter_[lane], false); }

/// Where a line enters or leaves the container, at about t.
void FieldPacket::hit_face(std::size_t lane, const std::array<PerLane<double>, 3>& planes, double t,
                           bool leaves) {
  const scene::Container& c = surface_.container;
  if (c.kind == scene::Container::Kind::sphere) return hit(lane, t, sphere_part);
  std::size_t axis = 0;
  while (axis < 2 && planes[axis][lane] != t) ++axis;
  const int k = static_cast<int>(axis);
  const Ray& ray = rays_[lane].ray;
  const bool high = (ray.d[k] > 0) == leaves;
  // As stretch_in() has it, to the last bit.
  const double exact = ((high ? c.hi : c.lo)[k] - ray.o[k]) / ray.d[k];
  hit(lane, exact, static_cast<std::uint32_t>(2 * k + 1) + (high ? 1 : 0));
}

/// A part of a line that is too rough for many at once.
void FieldPacket::alone(std::size_t lane, const Piece& piece) {
  const Mask bit = Mask{1} << lane;
  const bool known = (known_ & bit) != 0;
  const int before = known ? ((inside_ & bit) != 0 ? -1 : 1) : 0;
  const Stretch part{begin_[lane] + piece.from, begin_[lane] + piece.to, 0, 0};
  const bool at_face = !surface_.open && (entering_ & bit) != 0;
  const auto take = [&](double t, int sign) {
    if (before != 0 || t > part.from) {
      hit(lane, t, 0);
      return true;
    }
    if (sign < 0 && at_face) enter(lane);
    return (open_ & bit) == 0;
  };
  FieldSearch search(field_, rays_[lane].ray, part.from, part.to, least_);
  const int last =
      search.run_between(part, piece.value_from, piece.value_to, piece.slope, before, take);
  if (last == 0) return;
  known_ |= bit;
  inside_ = last < 0 ? inside_ | bit : inside_ & ~bit;
}

/// Lines that have come to their ends.
void FieldPacket::leave(Mask lanes) {
  open_ &= ~lanes;
  if (surface_.open) return;
  each_bit(lanes & known_ & inside_, [&](std::size_t i) { hit_face(i, far_, leave_[i], true); });
}

}  // namespace durer::tracer

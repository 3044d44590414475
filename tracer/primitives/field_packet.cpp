#include "tracer/primitives/field_packet.h"

#include "tracer/accel/lanes.h"
#include "tracer/primitives/container.h"
#include "tracer/primitives/field_search.h"

namespace durer::tracer {

using wide::each_bit;

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

void FieldPacket::enter(std::size_t lane) { hit_face(lane, enter_face_, enter_[lane], false); }

/// Where a line enters or leaves the container, at about t.
void FieldPacket::hit_face(std::size_t lane, const FaceOf& face, double t, bool leaves) {
  const scene::Container& c = surface_.container;
  if (c.kind == scene::Container::Kind::sphere) return hit(lane, t, sphere_part);
  const int k = face.axis(lane);
  const auto axis = static_cast<std::size_t>(k);
  const double d = rays_.d.of[axis][lane];
  const bool high = (d > 0) == leaves;
  // As stretch_in() has it, to the last bit.
  const double exact = ((high ? c.hi : c.lo)[k] - rays_.o.of[axis][lane]) / d;
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
  FieldSearch search(field_, rays_.ray(lane), part.from, part.to, least_);
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
  each_bit(lanes & known_ & inside_,
           [&](std::size_t i) { hit_face(i, leave_face_, leave_[i], true); });
}

}  // namespace durer::tracer

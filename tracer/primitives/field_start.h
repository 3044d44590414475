// Where the lines of a packet enter the container, and which of them go the same way. Only for
// field_walk.cpp.
#pragma once

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "tracer/primitives/field_lanes.h"

namespace durer::tracer {

/// Where a group of lines enters the container, and what the walk needs to know of them.
template <class Instructions>
void FieldWalk<Instructions>::start(std::size_t first) {
  const bool box = packet_.surface_.container.kind == scene::Container::Kind::box;
  Mask open = box ? meet_box(first) : meet_sphere(first);
  const auto load_at = [&](const FieldPacket::PerLane<double>& v)
                           DURER_LAMBDA_INLINE { return Doubles::load(&v[first]); };
  const Doubles enter = load_at(packet_.enter_);
  const Doubles leave = load_at(packet_.leave_);
  const Doubles t_from = load_at(packet_.rays_.t_from);
  const Doubles t_to = load_at(packet_.rays_.t_to);
  open &= above(t_to, enter) & above(t_to, t_from) & ~above(t_from, leave);
  const Doubles begin = most(enter, t_from);
  begin.store(&packet_.begin_[first]);
  (least(leave, t_to) - begin).narrowed(&packet_.end_[first]);
  const dvec3 centre = field_.centre();
  Doubles steps = Doubles::all(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Doubles d = load_at(packet_.rays_.d.of[k]);
    const Doubles p = load_at(packet_.rays_.o.of[k]) + begin * d;
    d.store(&packet_.d_[k][first]);
    p.store(&packet_.p_[k][first]);
    (p - Doubles::all(centre[static_cast<int>(k)])).narrowed(&packet_.short_p_[k][first]);
    d.narrowed(&packet_.short_d_[k][first]);
    steps = steps + abs(d);
  }
  const Doubles size = Doubles::all(packet_.half_diagonal_) / steps;
  (size * Doubles::all(1e-8)).store(&packet_.fine_[first]);
  (size * Doubles::all(4e-6)).narrowed(&packet_.doubt_[first]);
  packet_.open_ |= open << first;
  packet_.entering_ |= (open & ~above(t_from, enter)) << first;
}

/// Fills in enter_ and leave_, nearly as stretch_in() has them; returns who meets the container.
template <class Instructions>
auto FieldWalk<Instructions>::meet_box(std::size_t first) -> Mask {
  const scene::Container& c = packet_.surface_.container;
  Doubles enter = Doubles::all(-std::numeric_limits<double>::infinity());
  Doubles leave = Doubles::all(std::numeric_limits<double>::infinity());
  std::array<Mask, 3> enters{};
  std::array<Mask, 3> leaves{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Doubles o = Doubles::load(&packet_.rays_.o.of[k][first]);
    const Doubles d =
        Doubles::load(&packet_.rays_.d.of[k][first]) + Doubles::all(0);  // no zero below zero
    const Doubles inverse = Doubles::all(1) / d;
    const Doubles a = (Doubles::all(c.lo[static_cast<int>(k)]) - o) * inverse;
    const Doubles b = (Doubles::all(c.hi[static_cast<int>(k)]) - o) * inverse;
    // Of a line within a face, one of them is not a number: that one goes first here, and then in
    // the comparisons below, where it changes nothing.
    const Doubles near = least(b, a);
    const Doubles far = most(a, b);
    if (k > 0) {
      enters[k] = above(near, enter);
      leaves[k] = above(leave, far);
    }
    enter = most(near, enter);
    leave = least(far, leave);
  }
  packet_.enter_face_.y |= enters[1] << first;
  packet_.enter_face_.z |= enters[2] << first;
  packet_.leave_face_.y |= leaves[1] << first;
  packet_.leave_face_.z |= leaves[2] << first;
  enter.store(&packet_.enter_[first]);
  leave.store(&packet_.leave_[first]);
  return above(leave, enter) & above(enter, Doubles::all(-std::numeric_limits<double>::max()));
}

template <class Instructions>
auto FieldWalk<Instructions>::meet_sphere(std::size_t first) -> Mask {
  const scene::Container& c = packet_.surface_.container;
  const auto vector = [&](const auto& v) DURER_LAMBDA_INLINE {
    return std::array{Doubles::load(&v.of[0][first]), Doubles::load(&v.of[1][first]),
                      Doubles::load(&v.of[2][first])};
  };
  const auto dot = [](const auto& a, const auto& b)
                       DURER_LAMBDA_INLINE { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto o = vector(packet_.rays_.o);
  const auto d = vector(packet_.rays_.d);
  const std::array centre{Doubles::all(c.centre.x), Doubles::all(c.centre.y),
                          Doubles::all(c.centre.z)};
  std::array<Doubles, 3> way;
  for (std::size_t k = 0; k < 3; ++k) way[k] = centre[k] - o[k];
  const Doubles d2 = dot(d, d);
  const Doubles middle = dot(way, d) / d2;
  std::array<Doubles, 3> miss;
  for (std::size_t k = 0; k < 3; ++k) miss[k] = o[k] + middle * d[k] - centre[k];
  const Doubles h2 = Doubles::all(c.radius * c.radius) - dot(miss, miss);
  const Doubles half = root(h2 / d2);
  (middle - half).store(&packet_.enter_[first]);
  (middle + half).store(&packet_.leave_[first]);
  return above(h2, Doubles::all(0));
}

/// Those lanes that meet the halves of cells in the same order as the first of them.
template <class Instructions>
auto FieldWalk<Instructions>::alike(Mask lanes) const -> Mask {
  Mask alike = lanes;
  for (std::size_t k = 0; k < 3; ++k) {
    const Mask falling = above(Floats::all(0), load(packet_.inverse_[k]));
    const bool first = (falling >> std::countr_zero(lanes) & 1) != 0;
    alike &= first ? falling : ~falling;
  }
  return alike;
}

}  // namespace durer::tracer

// The lines of a packet in vector registers. Only for field_walk.cpp and what it is made of.
#pragma once

#include <array>
#include <cstddef>

#include "tracer/accel/lanes.h"
#include "tracer/accel/vector_lanes.h"
#include "tracer/primitives/field_packet.h"

namespace durer::tracer {

using wide::each_bit;

/// The walk on behalf of one packet. Compiled for several instruction sets; all give the same bits.
template <class Instructions>
class FieldWalk {
 public:
  using Floats = typename Instructions::Floats;
  using Doubles = typename Instructions::Doubles;
  using Mask = FieldPacket::Mask;
  using State = FieldLink::State;
  static constexpr std::size_t group = Doubles::size;
  static constexpr Mask all_of_group = (Mask{1} << group) - 1;

  DURER_INLINE explicit FieldWalk(FieldPacket& packet)
      : packet_(packet),
        field_(packet.field_),
        evaluator_(*packet.field_.function(), function_workspace(packet.field_.generator())) {}

  DURER_INLINE void run();

 private:
  struct Line {
    Floats at, slope;
  };
  struct alignas(64) Later {
    FieldPacket::PerLane<float> begin, end;
    const FieldCell* cell;
    Mask lanes;
  };

  static DURER_INLINE Floats load(const FieldPacket::PerLane<float>& p) {
    return Floats::load(p.data());
  }
  // field_start.h; `first`: of a group of lanes
  DURER_INLINE void start(std::size_t first);
  DURER_INLINE Mask meet_box(std::size_t first);
  DURER_INLINE Mask meet_sphere(std::size_t first);
  DURER_INLINE Mask alike(Mask lanes) const;
  // field_walk.cpp
  DURER_INLINE void walk(Mask lanes);
  DURER_INLINE Line line_in(const FieldCell& cell) const;
  DURER_INLINE Floats spread_in(const FieldDetail& cell) const;
  DURER_INLINE void settle(Mask lanes, bool inside, Floats where) {
    const Mask as_before = packet_.known_ & ~(packet_.inside_ ^ (inside ? ~Mask{0} : 0));
    if ((lanes & ~as_before) == 0) return;
    alignas(64) FieldPacket::PerLane<float> u;
    where.store(u.data());
    packet_.settle(lanes, inside, u);
  }
  // field_roots.h
  DURER_INLINE void examine(const FieldCell& cell, Mask lanes, const Line& line, Floats spread,
                            Floats begin, Floats end);
  DURER_INLINE void settle(std::size_t first, Mask lanes, Doubles v);
  DURER_INLINE void turn(Mask lanes, bool bounded, Floats slope, Floats spread, Floats begin,
                         Floats end);
  DURER_INLINE void turn(std::size_t first, Mask lanes, bool bounded);
  DURER_INLINE Doubles values(std::size_t first, Doubles u);
  DURER_INLINE Mask inside_at(Mask lanes, Floats u);
  DURER_INLINE void solve(std::size_t first, Mask lanes);
  DURER_INLINE void find_any(std::size_t first, Mask lanes, Mask rising);

  FieldPacket& packet_;
  const FunctionField& field_;
  functions::Evaluator<functions::Pack> evaluator_;
  // What is to be solved.
  alignas(64) FieldPacket::PerLane<float> slope_, spread_, from_, to_, guess_, reach_;
};

}  // namespace durer::tracer

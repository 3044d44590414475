// Roots along the lines of a packet, in a cell that has no halves to ask. Only for field_walk.cpp.
#pragma once

#include <cmath>

#include "tracer/primitives/field_lanes.h"

namespace durer::tracer {

/// Looks for changes of sign in a cell that has no halves to ask.
template <class Instructions>
void FieldWalk<Instructions>::examine(const FieldCell& cell, Mask lanes, const Line& line,
                                      Floats spread, Floats begin, Floats end) {
  const Floats steep = abs(line.slope);
  const float bound = cell.error;
  const bool bounded = std::isfinite(bound);
  const Mask rough = lanes & ~(bounded ? above(steep, spread) : 0);
  if (rough != 0) {
    turn(rough, bounded, line.slope, spread, begin, end);
    lanes &= ~rough;
    if (lanes == 0) return;
  }
  // One root at most, in the band where linear bounds leave the sign open.
  const Mask rising = above(line.slope, Floats::all(0));
  const Floats guess = Floats::all(0) - line.at / line.slope;
  const Floats reach = Floats::all(bound) / steep + load(packet_.doubt_);
  const Floats from = most(begin, guess - reach);
  const Floats to = least(end, guess + reach);
  // Before it, the side is known.
  const Mask before = lanes & above(from, begin);
  if (before != 0) {
    const Mask down = before & ~rising;
    if (down != 0) settle(down, false, begin);
    if ((before & rising) != 0) settle(before & rising, true, begin);
  }
  lanes &= packet_.open_;
  const Mask unknown = lanes & ~packet_.known_;
  if (unknown != 0) {
    const Mask inside = inside_at(unknown, begin);
    if ((unknown & inside) != 0) settle(unknown & inside, true, begin);
    if ((unknown & ~inside) != 0) settle(unknown & ~inside, false, begin);
    lanes &= packet_.open_;
  }
  lanes &= ~(packet_.inside_ ^ rising);  // others cannot change sides any more
  if (lanes == 0) return;
  line.slope.store(slope_.data());
  spread.store(spread_.data());
  from.store(from_.data());
  to.store(to_.data());
  most(from, least(guess, to)).store(guess_.data());
  (guess + reach).store(reach_.data());
  for (std::size_t first = 0; first < FieldPacket::size; first += group) {
    const Mask some = lanes >> first & all_of_group;
    if (some == 0) continue;
    if (packet_.any_) {
      find_any(first, some, rising >> first);
    } else {
      solve(first, some);
    }
  }
}

/// Lines along which the function may turn round in the cell. Most keep clear of zero all the same,
/// as a few values tell; others are followed one by one.
template <class Instructions>
void FieldWalk<Instructions>::turn(Mask lanes, bool bounded, Floats slope, Floats spread,
                                   Floats begin, Floats end) {
  slope.store(slope_.data());
  spread.store(spread_.data());
  begin.store(from_.data());
  end.store(to_.data());
  for (std::size_t first = 0; first < FieldPacket::size; first += group) {
    const Mask some = lanes >> first & all_of_group;
    if (some != 0) turn(first, some, bounded);
  }
}

template <class Instructions>
void FieldWalk<Instructions>::turn(std::size_t first, Mask lanes, bool bounded) {
  const Doubles zero = Doubles::all(0);
  const Doubles half = Doubles::all(0.5);
  const Doubles begin = Doubles::widened(&from_[first]);
  const Doubles end = Doubles::widened(&to_[first]);
  const Doubles slope = Doubles::widened(&slope_[first]);
  const Doubles spread = Doubles::widened(&spread_[first]);
  // Where the line that falls from a as steeply as it may meets the one that rises to b, that is,
  // above or below zero (FieldSearch::stays_clear).
  const auto clear = [&](Doubles a, Doubles b, Doubles length) DURER_LAMBDA_INLINE {
    const auto stays = [&](Doubles up, Doubles down, Doubles from, Doubles to) DURER_LAMBDA_INLINE {
      return above(from * up - to * down + down * up * length, zero);
    };
    const Doubles lowest = slope - spread;
    const Doubles highest = slope + spread;
    const Mask outside = above(a, zero) & above(b, zero) & stays(highest, lowest, a, b);
    const Mask inside =
        above(zero, a) & above(zero, b) & stays(zero - lowest, zero - highest, zero - a, zero - b);
    return outside | inside;
  };
  const Doubles a = values(first, begin);
  const Doubles b = values(first, end);
  const Mask all_clear = bounded ? lanes & clear(a, b, end - begin) : 0;
  settle(first, all_clear, a);
  lanes &= ~all_clear;
  if (lanes == 0) return;
  const Doubles middle = (begin + end) * half;
  const Doubles m = values(first, middle);
  const Mask front = bounded ? lanes & clear(a, m, middle - begin) : 0;
  const Mask back = bounded ? lanes & clear(m, b, end - middle) : 0;
  settle(first, front, a);
  alignas(64) std::array<double, group> from, to, between;
  a.store(from.data());
  b.store(to.data());
  m.store(between.data());
  alignas(64) std::array<double, group> where;
  middle.store(where.data());
  each_bit(lanes & ~(front & back), [&](std::size_t i) {
    const std::size_t lane = first + i;
    const Mask bit = Mask{1} << i;
    const auto begins = static_cast<double>(from_[lane]);
    const auto ends = static_cast<double>(to_[lane]);
    const auto s = static_cast<double>(slope_[lane]);
    const auto w = static_cast<double>(spread_[lane]);
    const Interval slopes = bounded ? Interval(s - w, s + w) : Interval::entire();
    if ((front & bit) == 0) {
      packet_.alone(lane, {begins, where[i], from[i], between[i], slopes});
    }
    if ((back & bit) == 0 && (packet_.open_ >> lane & 1) != 0) {
      packet_.alone(lane, {where[i], ends, between[i], to[i], slopes});
    }
  });
}

/// Settles the side of some lines of a group, where at the beginning they have values `v`.
template <class Instructions>
void FieldWalk<Instructions>::settle(std::size_t first, Mask lanes, Doubles v) {
  const Floats where = load(from_);
  const Mask outside = lanes & above(v, Doubles::all(0));
  if (outside != 0) settle(outside << first, false, where);
  if (outside != lanes) settle((lanes & ~outside) << first, true, where);
}

/// Values of the function, less the threshold, at `u` on a group of lines.
template <class Instructions>
auto FieldWalk<Instructions>::values(std::size_t first, Doubles u) -> Doubles {
  functions::Pack* const places = evaluator_.arguments();
  for (std::size_t k = 0; k < 3; ++k) {
    const Doubles p = Doubles::load(&packet_.p_[k][first]);
    (p + Doubles::load(&packet_.d_[k][first]) * u).store(places[k].v.data());
  }
  return Doubles::load(evaluator_.in_place().v.data()) - Doubles::all(field_.threshold());
}

template <class Instructions>
auto FieldWalk<Instructions>::inside_at(Mask lanes, Floats u) -> Mask {
  alignas(64) FieldPacket::PerLane<float> places;
  u.store(places.data());
  Mask inside = 0;
  for (std::size_t first = 0; first < FieldPacket::size; first += group) {
    if ((lanes >> first & all_of_group) == 0) continue;
    const Doubles v = values(first, Doubles::widened(&places[first]));
    // Zero counts as inside, and what is not a number as outside.
    alignas(64) std::array<double, group> g;
    v.store(g.data());
    for (std::size_t i = 0; i < group; ++i) inside |= (g[i] <= 0 ? Mask{1} : 0) << (first + i);
  }
  return inside;
}

/// As solve(), if it does not matter where in the band a root is: the side at its end tells.
template <class Instructions>
void FieldWalk<Instructions>::find_any(std::size_t first, Mask lanes, Mask rising) {
  const Doubles zero = Doubles::all(0);
  const Doubles v = values(first, Doubles::widened(&to_[first]));
  each_bit(lanes & ((rising & above(v, zero)) | (~rising & above(zero, v))), [&](std::size_t i) {
    packet_.hit(first + i, packet_.begin_[first + i] + static_cast<double>(from_[first + i]), 0);
  });
}

/// Roots of a function whose slopes are known to have one sign, see FieldSearch::solve.
template <class Instructions>
void FieldWalk<Instructions>::solve(std::size_t first, Mask lanes) {
  const auto of = [&](const FieldPacket::PerLane<float>& v)
                      DURER_LAMBDA_INLINE { return Doubles::widened(&v[first]); };
  const Doubles zero = Doubles::all(0);
  const Doubles one = Doubles::all(1);
  const Doubles slope = of(slope_);
  const Doubles steep = abs(slope);
  const Doubles spread = of(spread_);
  const Doubles flattest = steep - spread;
  // Ways along the line for a difference of one.
  const Doubles longest = one / flattest;
  const Doubles shortest = one / (steep + spread);
  const Doubles usual = one / steep;
  const Doubles begin = of(from_);
  const Doubles end = of(to_);
  const Doubles fine = Doubles::load(&packet_.fine_[first]);
  const Doubles tenth = fine * Doubles::all(0.1);
  Doubles lo = begin;
  Doubles hi = of(reach_);
  Doubles u = of(guess_);
  Doubles last_u = zero;
  Doubles last_v = zero;
  const Mask falling = above(zero, slope);
  Doubles sign;
  {
    alignas(64) std::array<double, group> s;
    for (std::size_t i = 0; i < group; ++i) s[i] = (falling >> i & 1) != 0 ? -1 : 1;
    sign = Doubles::load(s.data());
  }
  const auto found = [&](Mask some, Doubles where) {
    alignas(64) std::array<double, group> root;
    where.store(root.data());
    each_bit(some, [&](std::size_t i) {
      packet_.hit(first + i, packet_.begin_[first + i] + root[i], 0);
    });
    lanes &= ~some;
  };
  for (int i = 0; i < 60; ++i) {
    const Doubles v = sign * values(first, u);
    const Mask positive = above(v, zero);
    const Mask negative = above(zero, v);
    const Doubles a = v * longest;
    const Doubles b = v * shortest;
    lo = most(lo, u - most(a, b));
    hi = least(hi, u - least(a, b));
    const Mask is_number = above(one, v - v);
    lanes &= is_number & (positive | ~(above(lo, end) | (negative & ~above(end, u))));
    // Errors of secants shrink like e[i+1] = c e[i] e[i-1], and a step is about the error of its
    // beginning.
    const Doubles step =
        i == 0 ? v * usual : v * most(shortest, least((u - last_u) / (v - last_v), longest));
    Doubles next = u - step;
    const Doubles doubt = i == 0 ? abs(step) * spread : step * step;
    const Doubles little = i == 0 ? tenth * flattest : tenth * abs(u - last_u);
    next = most(lo, least(next, most(lo, hi)));
    const Mask done = lanes & (~above(doubt, little) | ~above(hi - lo, fine));
    if (done != 0) found(done, least(next, end));
    if (lanes == 0) return;
    if (i > 12) next = lo + (hi - lo) * Doubles::all(0.5);
    last_u = u;
    last_v = v;
    u = least(next, end);
    const Mask still = lanes & ~(above(u, last_u) | above(last_u, u));
    if (still != 0) found(still, u);
    if (lanes == 0) return;
  }
  found(lanes, u);
}

}  // namespace durer::tracer

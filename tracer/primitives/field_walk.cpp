#include "tracer/primitives/field_walk.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <glm/geometric.hpp>

#include "tracer/accel/lanes.h"
#include "tracer/accel/vector_lanes.h"

namespace durer::tracer {

using wide::each_bit;

/// Compiled for several instruction sets; all give the same bits.
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
  DURER_INLINE void start(std::size_t first);
  DURER_INLINE Mask meet_box(std::size_t first);
  DURER_INLINE Mask meet_sphere(std::size_t first);
  DURER_INLINE Mask alike(Mask lanes) const;
  DURER_INLINE void walk(Mask lanes);

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
  DURER_INLINE Line line_in(const FieldCell& cell) const;
  DURER_INLINE Floats spread_in(const FieldDetail& cell) const;
  DURER_INLINE void settle(Mask lanes, bool inside, Floats where) {
    const Mask as_before = packet_.known_ & ~(packet_.inside_ ^ (inside ? ~Mask{0} : 0));
    if ((lanes & ~as_before) == 0) return;
    alignas(64) FieldPacket::PerLane<float> u;
    where.store(u.data());
    packet_.settle(lanes, inside, u);
  }
  DURER_INLINE void examine(const FieldCell& cell, Mask lanes, const Line& line, Floats spread, Floats begin, Floats end);
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

template <class Instructions>
auto FieldWalk<Instructions>::line_in(const FieldCell& cell) const -> Line {
  const auto dot = [&](const std::array<FieldPacket::PerLane<float>, 3>& v) DURER_LAMBDA_INLINE {
    return load(v[0]) * Floats::all(cell.slope[0]) + load(v[1]) * Floats::all(cell.slope[1]) +
           load(v[2]) * Floats::all(cell.slope[2]);
  };
  return {dot(packet_.short_p_) + Floats::all(cell.value), dot(packet_.short_d_)};
}

/// By how much slopes along the lines may differ in the cell.
template <class Instructions>
auto FieldWalk<Instructions>::spread_in(const FieldDetail& cell) const -> Floats {
  const auto part = [&](std::size_t k) DURER_LAMBDA_INLINE {
    return abs(load(packet_.short_d_[k])) * Floats::all(cell.spread[k]);
  };
  return (part(0) + part(1) + part(2)) * Floats::all(1 + 1e-6F);
}

template <class Instructions>
void FieldWalk<Instructions>::run() {
  for (std::size_t first = 0; first < FieldPacket::size; first += group) start(first);
  packet_.open_ &= (Mask{1} << packet_.rays_.size()) - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Floats inverse = Floats::all(1) / load(packet_.short_d_[k]);
    most(least(inverse, Floats::all(1e30F)), Floats::all(-1e30F)).store(packet_.inverse_[k].data());
  }
  while (packet_.open_ != 0) {
    const Mask together = alike(packet_.open_);
    walk(together);
    packet_.leave(together & packet_.open_);
  }
}

/// Where a group of lines enters the container, and what the walk needs to know of them.
template <class Instructions>
void FieldWalk<Instructions>::start(std::size_t first) {
  const bool box = packet_.surface_.container.kind == scene::Container::Kind::box;
  Mask open = box ? meet_box(first) : meet_sphere(first);
  const auto load_at = [&](const FieldPacket::PerLane<double>& v) DURER_LAMBDA_INLINE {
    return Doubles::load(&v[first]);
  };
  const Doubles enter = load_at(packet_.enter_);
  const Doubles leave = load_at(packet_.leave_);
  const Doubles t_from = load_at(packet_.t_from_);
  const Doubles t_to = load_at(packet_.t_to_);
  open &= above(t_to, enter) & ~above(t_from, leave);
  const Doubles begin = most(enter, t_from);
  begin.store(&packet_.begin_[first]);
  (least(leave, t_to) - begin).narrowed(&packet_.end_[first]);
  const dvec3 centre = field_.centre();
  Doubles steps = Doubles::all(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Doubles d = load_at(packet_.d_[k]);
    const Doubles p = load_at(packet_.p_[k]) + begin * d;
    p.store(&packet_.p_[k][first]);
    (p - Doubles::all(centre[static_cast<int>(k)])).narrowed(&packet_.short_p_[k][first]);
    d.narrowed(&packet_.short_d_[k][first]);
    steps = steps + abs(d);
  }
  const Doubles size = Doubles::all(glm::length(field_.half())) / steps;
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
  for (std::size_t k = 0; k < 3; ++k) {
    const Doubles o = Doubles::load(&packet_.p_[k][first]);
    const Doubles d = Doubles::load(&packet_.d_[k][first]) + Doubles::all(0);  // no zero below zero
    const Doubles inverse = Doubles::all(1) / d;
    const Doubles a = (Doubles::all(c.lo[static_cast<int>(k)]) - o) * inverse;
    const Doubles b = (Doubles::all(c.hi[static_cast<int>(k)]) - o) * inverse;
    // Of a line within a face, one of them is not a number: that one goes first here, and then in
    // the comparisons below, where it changes nothing.
    const Doubles near = least(b, a);
    const Doubles far = most(a, b);
    near.store(&packet_.near_[k][first]);
    far.store(&packet_.far_[k][first]);
    enter = most(near, enter);
    leave = least(far, leave);
  }
  enter.store(&packet_.enter_[first]);
  leave.store(&packet_.leave_[first]);
  return above(leave, enter) & above(enter, Doubles::all(-std::numeric_limits<double>::max()));
}

template <class Instructions>
auto FieldWalk<Instructions>::meet_sphere(std::size_t first) -> Mask {
  const scene::Container& c = packet_.surface_.container;
  const auto vector = [&](const auto& v) DURER_LAMBDA_INLINE {
    return std::array{Doubles::load(&v[0][first]), Doubles::load(&v[1][first]),
                      Doubles::load(&v[2][first])};
  };
  const auto dot = [](const auto& a, const auto& b) DURER_LAMBDA_INLINE {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto o = vector(packet_.p_);
  const auto d = vector(packet_.d_);
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

template <class Instructions>
void FieldWalk<Instructions>::walk(Mask lanes) {
  std::array<Later, std::max(field_depth, grazing_depth) + 2> later;
  std::size_t waiting = 0;
  const auto any = static_cast<std::size_t>(std::countr_zero(lanes));
  const std::array<std::size_t, 3> nearer{packet_.inverse_[0][any] < 0 ? 1U : 0U,
                                          packet_.inverse_[1][any] < 0 ? 1U : 0U,
                                          packet_.inverse_[2][any] < 0 ? 1U : 0U};
  const FieldCell* cell = &field_.root();
  Floats begin = Floats::all(0);
  Floats end = load(packet_.end_);
  while (true) {
    // To the next cell, if this one has told all.
    const auto next = [&]() DURER_LAMBDA_INLINE {
      do {
        if (waiting == 0) return false;
        --waiting;
        lanes = later[waiting].lanes & packet_.open_;
      } while (lanes == 0);
      const Later& now = later[waiting];
      cell = now.cell;
      begin = load(now.begin);
      end = load(now.end);
      return true;
    };
    FieldLink link = cell->link.load(std::memory_order_acquire);
    const State state = link.state();
    if (state <= State::outside) {
      settle(lanes, state == State::inside, begin);
      if (!next()) return;
      continue;
    }
    if (state != State::halved) {
      const Line line = line_in(*cell);
      const Floats a = line.at + line.slope * begin;
      const Floats b = line.at + line.slope * end;
      const Mask outside = lanes & above(least(a, b), Floats::all(cell->error));
      const Mask inside = lanes & above(Floats::all(-cell->error), most(a, b));
      if (outside != 0) settle(outside, false, begin);
      if (inside != 0) settle(inside, true, begin);
      lanes &= ~(outside | inside);
      if (lanes != 0 && state != State::whole) {
        const FieldDetail& detail = state == State::refined ? link.halves().whole() : link.detail();
        const Floats spread = spread_in(detail);
        Mask here = lanes;
        if (state != State::rough && detail.depth() < grazing_depth) {
          here &= above(abs(line.slope), spread);
        }
        if (here != 0) examine(*cell, here, line, spread, begin, end);
        lanes &= ~here;
      }
      if (lanes == 0) {
        if (!next()) return;
        continue;
      }
    }
    const auto k = static_cast<std::size_t>(link.axis());
    const std::size_t near = nearer[k];
    if (!link.has_halves()) link = field_.split(*cell, link, near);
    const FieldHalves& halves = link.halves();
    const Floats middle =
        (Floats::all(cell->plane) - load(packet_.short_p_[k])) * load(packet_.inverse_[k]);
    const Mask first = lanes & above(middle, begin);
    const Mask second = lanes & (above(end, middle) | ~first);
    // Without branches, which could not be foretold.
    Later& then = later[waiting];
    waiting += first != 0 && second != 0 ? 1 : 0;
    const Floats farther = most(begin, middle);
    farther.store(then.begin.data());
    end.store(then.end.data());
    then.cell = &halves.cells[1 - near];
    then.lanes = second;
    cell = &halves.cells[first != 0 ? near : 1 - near];
    begin = chosen(first != 0, begin, farther);
    end = chosen(first != 0, least(end, middle), end);
    lanes = first != 0 ? first : second;
  }
}

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

/// Lines along which the function may turn round in the cell. Most keep clear of zero all the same, as
/// a few values tell; others are followed one by one.
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
    const auto stays = [&](Doubles up, Doubles down, Doubles from, Doubles to)
                           DURER_LAMBDA_INLINE {
      return above(from * up - to * down + down * up * length, zero);
    };
    const Doubles lowest = slope - spread;
    const Doubles highest = slope + spread;
    const Mask outside = above(a, zero) & above(b, zero) & stays(highest, lowest, a, b);
    const Mask inside = above(zero, a) & above(zero, b) &
                        stays(zero - lowest, zero - highest, zero - a, zero - b);
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
  const auto of = [&](const FieldPacket::PerLane<float>& v) DURER_LAMBDA_INLINE {
    return Doubles::widened(&v[first]);
  };
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
    const Doubles step = i == 0 ? v * usual
                                : v * most(shortest, least((u - last_u) / (v - last_v), longest));
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

namespace {

template <class Instructions>
DURER_INLINE void walk_with(FieldPacket& packet) {
  FieldWalk<Instructions>(packet).run();
}
using Walk = void (*)(FieldPacket&);
void walk_128(FieldPacket& packet) {
  walk_with<wide::LanesOf<16>>(packet);
}
#if defined(__x86_64__)
DURER_AVX2 void walk_256(FieldPacket& packet) {
  walk_with<wide::LanesOf<32>>(packet);
}
DURER_AVX512 void walk_512(FieldPacket& packet) {
  walk_with<wide::LanesOf<64>>(packet);
}
#endif

Walk best_walk() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
      __builtin_cpu_supports("avx512bw") != 0) {
    return walk_512;
  }
  if (__builtin_cpu_supports("avx2") != 0) return walk_256;
#endif
  return walk_128;
}

}  // namespace

void walk_field(FieldPacket& packet) {
  static const Walk walk = best_walk();
  walk(packet);
}

}  // namespace durer::tracer

#include "tracer/primitives/field_walk.h"

#include <bit>
#include <cmath>

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

  DURER_INLINE explicit FieldWalk(FieldPacket& packet)
      : packet_(packet),
        field_(packet.field_),
        evaluator_(*packet.field_.function(), function_workspace(packet.field_.generator())) {}

  DURER_INLINE void run(Mask lanes);

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
  DURER_INLINE Line line_in(const FieldCell& cell) const;
  DURER_INLINE Floats spread_in(const FieldDetail& cell) const;
  DURER_INLINE void settle(Mask lanes, bool inside, Floats where) {
    alignas(64) FieldPacket::PerLane<float> u;
    where.store(u.data());
    packet_.settle(lanes, inside, u);
  }
  DURER_INLINE void examine(const FieldCell& cell, Mask lanes, const Line& line, Floats spread,
                            Floats begin, Floats end);
  DURER_INLINE Doubles values(std::size_t first, Doubles u);
  DURER_INLINE Mask inside_at(Mask lanes, Floats u);
  DURER_INLINE void solve(std::size_t first, Mask lanes);

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
  return {dot(packet_.near_p_) + Floats::all(cell.value), dot(packet_.near_d_)};
}

/// By how much slopes along the lines may differ in the cell.
template <class Instructions>
auto FieldWalk<Instructions>::spread_in(const FieldDetail& cell) const -> Floats {
  const auto part = [&](std::size_t k) DURER_LAMBDA_INLINE {
    return abs(load(packet_.near_d_[k])) * Floats::all(cell.spread[k]);
  };
  return (part(0) + part(1) + part(2)) * Floats::all(1 + 2e-6F);
}

template <class Instructions>
void FieldWalk<Instructions>::run(Mask lanes) {
  std::array<Later, grazing_depth + 1> later;
  std::size_t waiting = 0;
  const auto any = static_cast<std::size_t>(std::countr_zero(lanes));
  const std::array<std::size_t, 3> nearer{std::signbit(packet_.near_d_[0][any]) ? 1U : 0U,
                                          std::signbit(packet_.near_d_[1][any]) ? 1U : 0U,
                                          std::signbit(packet_.near_d_[2][any]) ? 1U : 0U};
  const dvec3 centre = field_.centre();
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
    if (state != State::vague) {
      const Line line = line_in(*cell);
      const Floats a = line.at + line.slope * begin;
      const Floats b = line.at + line.slope * end;
      const Mask outside =
          lanes & above(least(a, b), Floats::all(cell->above.load(std::memory_order_relaxed)));
      const Mask inside =
          lanes & above(Floats::all(cell->below.load(std::memory_order_relaxed)), most(a, b));
      if (outside != 0) settle(outside, false, begin);
      if (inside != 0) settle(inside, true, begin);
      lanes &= ~(outside | inside);
      if (lanes != 0 && state != State::whole && state != State::halved) {
        const FieldDetail& detail = state == State::refined ? link.halves().whole() : link.detail();
        const Floats spread = spread_in(detail);
        Mask here = lanes;
        if (state != State::rough && detail.depth < grazing_depth) {
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
    const auto plane = static_cast<float>(halves.plane - centre[static_cast<int>(k)]);
    const Floats middle =
        (Floats::all(plane) - load(packet_.near_p_[k])) * load(packet_.inverse_[k]);
    const Mask first = lanes & above(middle, begin);
    const Mask second = lanes & (above(end, middle) | ~first);
    if (first == 0) {
      cell = &halves.cells[1 - near];
      begin = most(begin, middle);
      continue;
    }
    if (second != 0) {
      Later& then = later[waiting++];
      most(begin, middle).store(then.begin.data());
      end.store(then.end.data());
      then.cell = &halves.cells[1 - near];
      then.lanes = second;
    }
    cell = &halves.cells[near];
    lanes = first;
    end = least(end, middle);
  }
}

/// Looks for changes of sign in a cell that has no halves to ask.
template <class Instructions>
void FieldWalk<Instructions>::examine(const FieldCell& cell, Mask lanes, const Line& line,
                                      Floats spread, Floats begin, Floats end) {
  const Floats steep = abs(line.slope);
  const float bound = cell.above.load(std::memory_order_relaxed);
  const Mask rough = lanes & ~(std::isfinite(bound) ? above(steep, spread) : 0);
  if (rough != 0) {
    alignas(64) FieldPacket::PerLane<float> u;
    begin.store(u.data());
    each_bit(rough, [&](std::size_t i) { packet_.alone(i, u[i]); });
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
    const Mask some = lanes >> first & ((Mask{1} << group) - 1);
    if (some != 0) solve(first, some);
  }
}

/// Values of the function, less the threshold, at `u` on a group of lines.
template <class Instructions>
auto FieldWalk<Instructions>::values(std::size_t first, Doubles u) -> Doubles {
  std::array<functions::Pack, 3> places;
  for (std::size_t k = 0; k < 3; ++k) {
    const Doubles p = Doubles::load(&packet_.p_[k][first]);
    (p + Doubles::load(&packet_.d_[k][first]) * u).store(places[k].v.data());
  }
  const functions::Pack g = evaluator_(places);
  return Doubles::load(g.v.data()) - Doubles::all(field_.threshold());
}

template <class Instructions>
auto FieldWalk<Instructions>::inside_at(Mask lanes, Floats u) -> Mask {
  alignas(64) FieldPacket::PerLane<float> places;
  u.store(places.data());
  Mask inside = 0;
  for (std::size_t first = 0; first < FieldPacket::size; first += group) {
    if ((lanes >> first & ((Mask{1} << group) - 1)) == 0) continue;
    const Doubles v = values(first, Doubles::widened(&places[first]));
    // Zero counts as inside, and what is not a number as outside.
    alignas(64) std::array<double, group> g;
    v.store(g.data());
    for (std::size_t i = 0; i < group; ++i) inside |= (g[i] <= 0 ? Mask{1} : 0) << (first + i);
  }
  return inside;
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
  const Doubles steepest = steep + spread;
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
    const Doubles a = v / flattest;
    const Doubles b = v / steepest;
    lo = most(lo, u - most(a, b));
    hi = least(hi, u - least(a, b));
    const Mask is_number = above(one, v - v);
    lanes &= is_number & (positive | ~(above(lo, end) | (negative & ~above(end, u))));
    Doubles next = u - v / steep;
    Doubles doubt = abs(next - u) * (spread / flattest);
    if (i > 0) {
      const Doubles secant = most(flattest, least((v - last_v) / (u - last_u), steepest));
      next = u - v / secant;
      doubt = (next - u) * (next - u) / abs(u - last_u);
    }
    next = most(lo, least(next, most(lo, hi)));
    const Mask done = lanes & (~above(doubt, tenth) | ~above(hi - lo, fine));
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
DURER_INLINE void walk_with(FieldPacket& packet, std::uint32_t lanes) {
  FieldWalk<Instructions>(packet).run(lanes);
}
using Walk = void (*)(FieldPacket&, std::uint32_t);
void walk_128(FieldPacket& packet, std::uint32_t lanes) {
  walk_with<wide::LanesOf<16>>(packet, lanes);
}
#if defined(__x86_64__)
DURER_AVX2 void walk_256(FieldPacket& packet, std::uint32_t lanes) {
  walk_with<wide::LanesOf<32>>(packet, lanes);
}
DURER_AVX512 void walk_512(FieldPacket& packet, std::uint32_t lanes) {
  walk_with<wide::LanesOf<64>>(packet, lanes);
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

void walk_field(FieldPacket& packet, std::uint32_t lanes) {
  static const Walk walk = best_walk();
  walk(packet, lanes);
}

}  // namespace durer::tracer

#include "tracer/primitives/field_walk.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "tracer/primitives/field_roots.h"
#include "tracer/primitives/field_start.h"

namespace durer::tracer {

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
void FieldWalk<Instructions>::walk(Mask lanes) {
  std::array<Later, std::max(field_depth, grazing_depth) + 2> later;
  Later* free = later.data();  // those before wait
  const auto any = static_cast<std::size_t>(std::countr_zero(lanes));
  const std::array<std::size_t, 3> nearer{packet_.inverse_[0][any] < 0 ? 1U : 0U,
                                          packet_.inverse_[1][any] < 0 ? 1U : 0U,
                                          packet_.inverse_[2][any] < 0 ? 1U : 0U};
  const FieldCell* cell = &field_.root();
  Floats begin = Floats::all(0);
  Floats end = load(packet_.end_);
  // Goes on with that half of the cell which comes first; the other one waits, if lines pass both.
  const auto descend = [&](FieldLink link) DURER_LAMBDA_INLINE {
    const auto k = static_cast<std::size_t>(link.axis());
    const std::size_t near = nearer[k];
    const FieldHalves& halves = link.halves();
    const Floats middle =
        (Floats::all(cell->plane) - load(packet_.short_p_[k])) * load(packet_.inverse_[k]);
    const Mask first = lanes & above(middle, begin);
    const Mask second = lanes & (above(end, middle) | ~first);
    if (first == 0) {
      cell = &halves.cells[1 - near];
      return;
    }
    cell = &halves.cells[near];
    if (second == 0) return;
    most(begin, middle).store(free->begin.data());
    end.store(free->end.data());
    free->cell = &halves.cells[1 - near];
    free->lanes = second;
    ++free;
    end = least(end, middle);
    lanes = first;
  };
  // To the next cell, if this one has told all.
  const auto next = [&]() DURER_LAMBDA_INLINE {
    do {
      if (free == later.data()) return false;
      --free;
      lanes = free->lanes & packet_.open_;
    } while (lanes == 0);
    cell = free->cell;
    begin = load(free->begin);
    end = load(free->end);
    return true;
  };
  while (true) {
    FieldLink link = cell->link.load();
    // A loop of its own, in which everything stays in registers.
    while (link.state() == State::halved) {
      descend(link);
      link = cell->link.load();
    }
    const State state = link.state();
    if (state <= State::outside) {
      settle(lanes, state == State::inside, begin);
      if (!next()) return;
      continue;
    }
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
    if (!link.has_halves()) {
      link = field_.split(*cell, link, nearer[static_cast<std::size_t>(link.axis())]);
    }
    descend(link);
  }
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

namespace {

template <class Instructions>
DURER_INLINE void walk_with(FieldPacket& packet) {
  FieldWalk<Instructions>(packet).run();
}
void walk_128(FieldPacket& packet) { walk_with<wide::LanesOf<16>>(packet); }
#if defined(__x86_64__)
DURER_AVX2 void walk_256(FieldPacket& packet) { walk_with<wide::LanesOf<32>>(packet); }
DURER_AVX512 void walk_512(FieldPacket& packet) { walk_with<wide::LanesOf<64>>(packet); }
#endif

}  // namespace

std::span<const FieldWalkVersion> field_walks() {
  static const std::vector<FieldWalkVersion> versions = [] {
    std::vector<FieldWalkVersion> all{walk_128};
#if defined(__x86_64__)
    if (simd::has_avx2()) all.push_back(walk_256);
    if (simd::has_avx512()) {
      all.push_back(walk_512);
    }
#endif
    return all;
  }();
  return versions;
}

}  // namespace durer::tracer

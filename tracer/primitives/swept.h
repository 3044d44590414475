// What prisms and glyphs have in common: the sides that an outline leaves behind it, between two
// parallel planes that end them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "tracer/primitives/crossing.h"
#include "tracer/primitives/outline.h"

namespace durer::tracer::swept {

/// Parts: the two ends, then the arcs of the outline.
inline constexpr std::uint32_t low_end = 0;
inline constexpr std::uint32_t high_end = 1;
inline constexpr std::uint32_t first_side = 2;

struct SideHit {
  double t;
  std::uint32_t part;
};

/// The piece of a line between the two ends, and which of them it passes first.
struct Piece {
  double t_in;
  double t_out;
  std::uint32_t part_in;
  std::uint32_t part_out;
};

/// Where o + t·d lies between lo and hi; none if it nowhere does. Of lines along the ends, those at
/// the lower one belong to the inside.
[[nodiscard]] inline std::optional<Piece> between(double o, double d, double lo, double hi) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  if (d == 0) {
    if (!(o >= lo && o < hi)) return std::nullopt;
    return Piece{-endless, endless, low_end, high_end};
  }
  const double t_lo = (lo - o) / d;
  const double t_hi = (hi - o) / d;
  if (d > 0) return Piece{t_lo, t_hi, low_end, high_end};
  return Piece{t_hi, t_lo, high_end, low_end};
}

/// Sides of this thread's present line: shapes have no buffers to hand down.
inline std::vector<SideHit>& empty_sides() {
  thread_local std::vector<SideHit> sides;
  sides.clear();
  return sides;
}

/// Calls f(crossing) for every crossing, ascending. `inside`: at t = -infinity, between endless
/// sides. `ends_seen`: whether the ends are surfaces, or only end the inside.
template <typename F>
void each_crossing(std::vector<SideHit>& sides, bool inside, const Piece& piece, bool ends_seen,
                   F&& f) {
  std::sort(sides.begin(), sides.end(),
            [](const SideHit& a, const SideHit& b) { return a.t < b.t; });
  auto at = sides.begin();
  for (; at != sides.end() && at->t <= piece.t_in; ++at) inside = !inside;
  if (inside) f(Crossing{piece.t_in, 0, piece.part_in, Side::enter, ends_seen});
  for (; at != sides.end() && at->t < piece.t_out; ++at) {
    f(Crossing{at->t, 0, at->part, inside ? Side::exit : Side::enter, true});
    inside = !inside;
  }
  if (inside) f(Crossing{piece.t_out, 0, piece.part_out, Side::exit, ends_seen});
}

}  // namespace durer::tracer::swept

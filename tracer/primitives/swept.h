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

/// The first crossing in t_from <= t < t_to that is seen, where o + t·d is the line in the plane of
/// the outline.
[[nodiscard]] inline std::optional<Nearest> nearest(const Outline& outline, dvec2 o, dvec2 d,
                                                    bool upright, const Piece& piece,
                                                    bool ends_seen, double t_from, double t_to) {
  if (piece.t_out < t_from || piece.t_in >= t_to) return std::nullopt;
  const bool sees_in = ends_seen && piece.t_in >= t_from;
  const double begin = std::max(piece.t_in, t_from);
  const double end = std::min(piece.t_out, t_to);
  // Whether it is inside where it comes in, where it begins to be of interest, and after that.
  bool at_in = false;
  bool later = false;
  std::optional<Nearest> first;
  if (upright) {
    at_in = later = outline.contains(o);
  } else {
    double until = end;
    const bool odd = outline.each_crossing_within(
        o, d, begin, end, [&](std::uint32_t arc, double t) {
          if (t <= piece.t_in) at_in = !at_in;
          if (t < piece.t_out) later = !later;
          if (t <= piece.t_in || t < t_from || !(t < until)) return;
          until = t;
          first = Nearest{t, arc + first_side};
        });
    at_in ^= odd;
    later ^= odd;
  }
  if (at_in && sees_in) return Nearest{piece.t_in, piece.part_in};
  if (first) return first;
  // No side is passed any more: what is inside now comes out at the end.
  if (later && ends_seen && piece.t_out >= t_from && piece.t_out < t_to) {
    return Nearest{piece.t_out, piece.part_out};
  }
  return std::nullopt;
}

}  // namespace durer::tracer::swept

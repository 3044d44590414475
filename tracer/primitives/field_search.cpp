#include "tracer/primitives/field_search.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace durer::tracer {
namespace {

/// NaN counts as outside.
int sign_of(double g) { return g <= 0 ? -1 : 1; }

}  // namespace

FieldSearch::FieldSearch(const FunctionField& field, const Ray& ray, double t_from, double t_to,
                         double least)
    : field_(field),
      ray_(ray),
      from_centre_(ray.o - field.centre()),
      t_from_(t_from),
      t_to_(t_to),
      workspace_(function_workspace(field.generator())) {
  const double length = glm::length(ray.d);
  least_ = least / length;
  fine_ = 1e-8 * glm::length(field.half()) / length;
}

void FieldSearch::settle(int sign, double t) {
  if (!started_) {
    started_ = true;
    if (t_from_ <= stretch_.from) report(stretch_.from, sign);
  } else if (sign_ != 0 && sign_ != sign) {
    report(t, sign);
  }
  sign_ = sign;
}

double FieldSearch::value(double t) {
  const dvec3 p = ray_.at(t);
  return (*evaluator_)(std::array{p.x, p.y, p.z}) - field_.threshold();
}

FieldSearch::Line FieldSearch::line_in(const FieldCell& cell) const {
  const dvec3 g(cell.slope[0], cell.slope[1], cell.slope[2]);
  return {static_cast<double>(cell.value) + glm::dot(g, from_centre_), glm::dot(g, ray_.d),
          static_cast<double>(cell.error)};
}

/// True if the slope along the line may be zero somewhere in the cell.
bool FieldSearch::grazes(const FieldDetail& cell, const Line& line) const {
  const dvec3 spread(cell.spread[0], cell.spread[1], cell.spread[2]);
  return std::abs(line.slope) <= glm::dot(spread, glm::abs(ray_.d));
}

/// Settles the sign along t0 … t1, a part of the line in the cell, by what is known of the cell.
/// False if its halves must be asked; `link` leads to them.
bool FieldSearch::enter(const FieldCell& cell, FieldLink& link, double t0, double t1) {
  using State = FieldLink::State;
  const State state = link.state();
  if (state == State::halved) return false;
  if (state == State::inside) return settle(-1, t0), true;
  if (state == State::outside) return settle(1, t0), true;
  const Line line = line_in(cell);
  const double a = line.at + line.slope * t0;
  const double b = line.at + line.slope * t1;
  if (std::min(a, b) > line.error) return settle(1, t0), true;
  if (std::max(a, b) < -line.error) return settle(-1, t0), true;
  if (state == State::whole) return false;
  const FieldDetail& detail = state == State::refined ? link.halves().whole() : link.detail();
  if (state != State::rough && detail.depth() < grazing_depth && grazes(detail, line)) return false;
  examine(detail, line, t0, t1);
  return true;
}

/// Visits cells in the order of the line until there is nothing more to find.
void FieldSearch::walk(double t0, double t1) {
  struct Visit {
    const FieldCell* cell;
    double end;
  };
  std::array<Visit, std::max(field_depth, grazing_depth) + 1> later;  // cells that the line has yet to pass
  std::size_t waiting = 0;
  Visit now{&field_.root(), t1};
  dvec3 inverse;
  std::array<std::size_t, 3> nearer;  // which half comes first
  for (int k = 0; k < 3; ++k) {
    // Along a plane, that is far away, on the side that tells which half the line is in.
    inverse[k] = std::clamp(1 / ray_.d[k], -1e200, 1e200);
    nearer[static_cast<std::size_t>(k)] = std::signbit(ray_.d[k]) ? 1 : 0;
  }
  while (true) {
    if (t0 >= t_to_) done_ = true;
    if (done_) return;
    FieldLink link = now.cell->link.load();
    if (enter(*now.cell, link, t0, now.end)) {
      if (waiting == 0) return;
      t0 = now.end;
      now = later[--waiting];
      continue;
    }
    const int k = link.axis();
    const std::size_t near = nearer[static_cast<std::size_t>(k)];
    if (!link.has_halves()) link = field_.split(*now.cell, link, near);
    const FieldHalves& halves = link.halves();
    const double beginning = std::max(t0, t_from_);
    const double middle = (static_cast<double>(now.cell->plane) - from_centre_[k]) * inverse[k];
    // Without branches, which could not be foretold.
    const bool past = middle <= beginning;
    t0 = past ? std::max(t0, middle) : t0;
    const bool both = !past && middle < now.end;
    later[waiting] = {&halves.cells[1 - near], now.end};
    waiting += both ? 1 : 0;
    now.cell = &halves.cells[past ? 1 - near : near];
    now.end = both ? middle : now.end;
  }
}

/// The part of t0 … t1 where the linear bounds of the cell, m + t · slope ± error on the line,
/// leave the sign open. Signs before it are settled.
FieldSearch::Band FieldSearch::clip(const Line& line, double t0, double t1) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Band band{t0, t1, infinity, 0, 0, false};
  if (!std::isfinite(line.error)) return band;
  const double m = line.at;
  const double error = line.error;
  band.slope = line.slope;
  const auto one_sign = [&](int sign) {
    band.empty = true;
    settle(sign, t0);
    return band;
  };
  if (band.slope == 0) return std::abs(m) > error ? one_sign(m > 0 ? 1 : -1) : band;
  const int rising = band.slope > 0 ? 1 : -1;
  const double half = error / std::abs(band.slope);
  band.middle = -m / band.slope;
  if (band.middle + half <= t0) return one_sign(rising);
  if (band.middle - half >= t1) return one_sign(-rising);
  if (band.middle - half > t0) {
    band.begin = band.middle - half;
    settle(-rising, t0);
  }
  band.limit = band.middle + half;
  band.end = std::min(t1, band.limit);
  return band;
}

/// Looks for changes of sign in the part t0 … t1 of the line, which lies in the cell.
void FieldSearch::examine(const FieldDetail& cell, const Line& line, double t0, double t1) {
  follow(*field_.function());
  const Band band = clip(line, t0, t1);
  if (band.empty) return;
  const double begin = band.begin;
  const double end = band.end;
  const double slope = band.slope;
  double spread = std::numeric_limits<double>::infinity();
  if (std::isfinite(line.error)) {
    spread = glm::dot(dvec3(cell.spread[0], cell.spread[1], cell.spread[2]), glm::abs(ray_.d));
  }

  if (!(std::abs(slope) > spread)) {
    const double ga = begin == last_t_ && tape_ == last_tape_ ? last_g_ : value(begin);
    settle(sign_of(ga), begin);
    const Interval slopes =
        std::isfinite(spread) ? Interval{slope - spread, slope + spread} : Interval::entire();
    const double gb = value(end);
    last_t_ = end;
    last_g_ = gb;
    last_tape_ = tape_;
    return resolve({begin, ga, end, gb, slopes});
  }
  // One root at most.
  const int rising = slope > 0 ? 1 : -1;
  if (sign_ == 0 || t_from_ > t0) {  // nothing to solve if the root lies before
    const int sign = sign_of(value(std::clamp(t_from_, t0, t1)));
    if (sign == rising) {
      if (!(t_from_ > t0)) settle(sign, t0);
      started_ = true;
      return void(sign_ = sign);
    }
    settle(sign, t0);
  }
  if (sign_ == rising) return;
  const Rise rise{begin, end, band.limit, band.middle, std::abs(slope), spread, double(rising)};
  if (const auto t = solve(rise)) settle(rising, *t);
}

/// The root of a function whose slopes are known to be positive: interval Newton steps narrow the
/// bracket, secants choose where to look.
std::optional<double> FieldSearch::solve(const Rise& rise) {
  const double least = rise.slope - rise.spread;
  const double most = rise.slope + rise.spread;
  double lo = rise.begin;
  double hi = rise.limit;
  double t = std::clamp(rise.first, rise.begin, rise.end);
  double last_t = 0;
  double last_v = 0;
  for (int i = 0; i < 60; ++i) {
    const double v = rise.direction * value(t);
    if (v != v) return std::nullopt;
    if (v > 0) {
      lo = std::max(lo, t - v / least);
      hi = std::min(hi, t - v / most);
    } else {
      lo = std::max(lo, t - v / most);
      hi = std::min(hi, t - v / least);
      if (lo > rise.end || (t == rise.end && v < 0)) return std::nullopt;
    }
    double next = 0;
    double doubt = 0;  // how far the root may be from there
    if (i == 0) {
      next = t - v / rise.slope;
      doubt = std::abs(next - t) * (rise.spread / least);
    } else {
      next = t - v / std::clamp((v - last_v) / (t - last_t), least, most);
      // Errors of secants shrink like e[i+1] = c e[i] e[i-1], and a step is about the error of its
      // beginning.
      doubt = (next - t) * (next - t) / std::abs(t - last_t);
    }
    next = std::clamp(next, lo, std::max(lo, hi));
    if (doubt <= 0.1 * fine_ || hi - lo <= fine_) return std::min(next, rise.end);
    if (i > 12) next = lo + (hi - lo) / 2;  // slopes that vary wildly
    last_t = t;
    last_v = v;
    t = std::min(next, rise.end);
    if (t == last_t) return t;
  }
  return t;
}

/// Same sign at both ends: true if the slopes between do not suffice to reach zero.
bool FieldSearch::stays_clear(const Piece& piece) {
  const double height = sign_of(piece.ga) > 0 ? 1 : -1;
  const double ga = height * piece.ga;
  const double gb = height * piece.gb;
  const double down = height > 0 ? piece.slope.lo : -piece.slope.hi;  // steepest descent from a
  const double up = height > 0 ? piece.slope.hi : -piece.slope.lo;    // steepest ascent to b
  if (down >= 0) return ga > 0;
  if (up <= 0) return gb > 0;
  // Where the line that falls from a meets the line that rises to b.
  return ga * up - gb * down + down * up * (piece.b - piece.a) > 0;
}

/// Settles the signs along a piece in which several roots may lie: by bounds of value and slope
/// along it, or in halves.
void FieldSearch::resolve(Piece piece) {
  const double length = piece.b - piece.a;
  const int before = sign_of(piece.ga);
  const int after = sign_of(piece.gb);
  const auto decided = [&] {
    if (before == after && stays_clear(piece)) return true;
    if (!(piece.slope.lo > 0) && !(piece.slope.hi < 0)) return false;
    if (before != after) settle(after, bracketed_root(piece));
    return true;
  };
  if (decided()) return;
  if (length < least_) {
    if (before != after) settle(after, bracketed_root(piece));
    return;
  }
  const Trend trend =
      functions::evaluate_along(*tape_, ray_.o, ray_.d, {piece.a, piece.b}, workspace_);
  if (const Interval range = trend.range(); !range.nan) {
    const double threshold = field_.threshold();
    if (before == after && (range.lo > threshold || range.hi <= threshold)) return;
    const Interval slope = trend.slope(0);
    if (!slope.nan) {
      piece.slope = narrowed(piece.slope, slope);
      if (decided()) return;
    }
  }
  const double middle = piece.a + length / 2;
  const double g = value(middle);
  resolve({piece.a, piece.ga, middle, g, piece.slope});
  if (!done_) resolve({middle, g, piece.b, piece.gb, piece.slope});
}

/// A change of sign between the ends, by false position with halved weights (the Illinois rule);
/// by bisection where that is slow, as at jumps.
double FieldSearch::bracketed_root(const Piece& piece) {
  double a = piece.a;
  double b = piece.b;
  double ga = piece.ga;
  double gb = piece.gb;
  const int before = sign_of(ga);
  int last_side = 0;
  for (int i = 0; i < 100 && b - a > fine_; ++i) {
    double t = a - ga * (b - a) / (gb - ga);
    if (i >= 20 || !(t > a && t < b)) t = a + (b - a) / 2;
    if (!(t > a && t < b)) break;
    const double g = value(t);
    if (g == 0) return t;
    const int side = sign_of(g) == before ? -1 : 1;
    (side < 0 ? a : b) = t;
    (side < 0 ? ga : gb) = g;
    if (side == last_side) (side < 0 ? gb : ga) /= 2;
    last_side = side;
  }
  return a + (b - a) / 2;
}

}  // namespace durer::tracer

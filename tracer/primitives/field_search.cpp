#include "tracer/primitives/field_search.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace durer::tracer {
namespace {

/// Samples are cheaper than bounds: those are made anew after so many halvings.
constexpr int halvings = 3;

/// NaN counts as outside.
int sign_of(double g) { return g <= 0 ? -1 : 1; }

}  // namespace

FieldSearch::FieldSearch(const FunctionField& field, const Ray& ray, double t_from, double t_to,
                         double least)
    : field_(field),
      ray_(ray),
      inverse_(1.0 / ray.d.x, 1.0 / ray.d.y, 1.0 / ray.d.z),
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

void FieldSearch::walk(const FieldCell& cell, const dvec3& centre, const dvec3& half, int depth,
                       double t0, double t1) {
  if (cell.state != FieldCell::State::mixed) return examine(cell, centre, t0, t1);
  if (const int sign = sign_over(cell, centre, t0, t1); sign != 0) return settle(sign, t0);
  const FieldBlock& children = field_.children(cell, centre, half, depth);
  // The middle planes that lie between, in the order in which the line crosses them.
  struct Plane {
    double t;
    unsigned bit;
  };
  std::array<Plane, 3> planes;  // NOLINT: filled as far as counted
  std::size_t count = 0;
  unsigned child = 0;
  for (int k = 0; k < 3; ++k) {
    const unsigned bit = 1U << static_cast<unsigned>(k);
    if (ray_.d[k] == 0) {
      if (ray_.o[k] >= centre[k]) child |= bit;
      continue;
    }
    const double t = (centre[k] - ray_.o[k]) * inverse_[k];
    if ((t <= t0) == (ray_.d[k] > 0)) child |= bit;
    if (!(t > t0 && t < t1)) continue;
    std::size_t at = count++;
    for (; at > 0 && planes[at - 1].t > t; --at) planes[at] = planes[at - 1];
    planes[at] = {t, bit};
  }
  const dvec3 quarter = half * 0.5;
  double from = t0;
  for (std::size_t i = 0; i <= count; ++i) {
    const double to = i < count ? planes[i].t : t1;
    if (to <= t_from_) {
      sign_ = 0;  // it may change there
    } else if (from >= t_to_ || done_) {
      done_ = true;
      return;
    } else if (from < to) {
      if ((children.inside >> child & 1U) != 0) {
        settle(-1, from);
      } else if ((children.outside >> child & 1U) != 0) {
        settle(1, from);
      } else {
        const dvec3 at = centre + dvec3((child & 1) != 0 ? quarter.x : -quarter.x,
                                        (child & 2) != 0 ? quarter.y : -quarter.y,
                                        (child & 4) != 0 ? quarter.z : -quarter.z);
        walk(children.cells[child], at, quarter, depth + 1, from, to);
      }
    }
    if (i < count) child ^= planes[i].bit;
    from = to;
  }
}

/// The sign all over t0 … t1 if the linear bounds of the cell tell it, else 0.
int FieldSearch::sign_over(const FieldCell& cell, const dvec3& centre, double t0,
                           double t1) const {
  const auto error = static_cast<double>(cell.error);
  const dvec3 g(cell.slope[0], cell.slope[1], cell.slope[2]);
  const double m = cell.value + glm::dot(g, ray_.o - centre);
  const double slope = glm::dot(g, ray_.d);
  const double a = m + slope * t0;
  const double b = m + slope * t1;
  if (std::min(a, b) > error) return 1;
  return std::max(a, b) < -error ? -1 : 0;
}

/// The part of t0 … t1 where the linear bounds of the cell, m + t · slope ± error along the line,
/// leave the sign open. Signs before it are settled.
FieldSearch::Band FieldSearch::clip(const FieldCell& cell, const dvec3& centre, double t0,
                                    double t1) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Band band{t0, t1, infinity, 0, 0, false};
  const double error = static_cast<double>(cell.error);
  if (!std::isfinite(error)) return band;
  const dvec3 g(cell.slope[0], cell.slope[1], cell.slope[2]);
  const double m = cell.value + glm::dot(g, ray_.o - centre);
  band.slope = glm::dot(g, ray_.d);
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
void FieldSearch::examine(const FieldCell& cell, const dvec3& centre, double t0, double t1) {
  using State = FieldCell::State;
  if (cell.state == State::inside) return settle(-1, t0);
  if (cell.state == State::outside) return settle(1, t0);

  if (tape_ != cell.tape) {
    tape_ = cell.tape;
    evaluator_.emplace(*tape_, workspace_);
  }
  const Band band = clip(cell, centre, t0, t1);
  if (band.empty) return;
  const double begin = band.begin;
  const double end = band.end;
  const double slope = band.slope;
  double spread = std::numeric_limits<double>::infinity();
  if (std::isfinite(cell.error)) {
    spread = glm::dot(dvec3(cell.spread[0], cell.spread[1], cell.spread[2]), glm::abs(ray_.d));
  }

  if (!(std::abs(slope) > spread)) {
    const double ga = begin == last_t_ && tape_ == last_tape_ ? last_g_ : value(begin);
    settle(sign_of(ga), begin);
    const Interval slopes = std::isfinite(spread) ? Interval{slope - spread, slope + spread}
                                                  : Interval::entire();
    const double gb = value(end);
    last_t_ = end;
    last_g_ = gb;
    last_tape_ = tape_;
    return resolve({begin, ga, end, gb, slopes}, 0);
  }
  // One root at most.
  const int rising = slope > 0 ? 1 : -1;
  if (sign_ == 0) {
    const int sign = sign_of(value(std::clamp(t_from_, t0, t1)));
    if (sign == rising) {
      if (!(t_from_ > t0)) settle(sign, t0);
      started_ = true;
      return void(sign_ = sign);
    }
    settle(sign, t0);
  }
  if (sign_ == rising) return;
  const Rise rise{begin,           end,    band.limit,    band.middle,
                  std::abs(slope), spread, double(rising)};
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
    double steepness = rise.slope;
    double tolerance = 1e-4 * fine_;
    if (i > 0) {
      steepness = std::clamp((v - last_v) / (t - last_t), least, most);
      tolerance = fine_;
    }
    double next = std::clamp(t - v / steepness, lo, std::max(lo, hi));
    if (std::abs(next - t) <= tolerance) return std::min(next, rise.end);
    if (i > 12) next = lo + (hi - lo) / 2;  // slopes that vary wildly
    last_t = t;
    last_v = v;
    t = std::min(next, rise.end);
    if (t == last_t) return t;
  }
  return t;
}

Trend FieldSearch::trend_over(double a, double b) const {
  const dvec3 p = ray_.at(a);
  const dvec3 q = ray_.at(b);
  std::array<Interval, 3> box;
  for (int k = 0; k < 3; ++k) {
    const double pad = 1e-15 * (std::abs(p[k]) + std::abs(q[k]));
    box[static_cast<std::size_t>(k)] = {std::min(p[k], q[k]) - pad, std::max(p[k], q[k]) + pad};
  }
  return functions::evaluate_trend(*tape_, box, workspace_);
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

/// Settles the signs along a piece in which several roots may lie. Samples are cheaper than bounds,
/// so bounds are made anew only after some halvings.
void FieldSearch::resolve(Piece piece, int depth) {
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
  if (depth % halvings == halvings - 1 || !piece.slope.is_bounded()) {
    const Trend trend = trend_over(piece.a, piece.b);
    if (!trend.v.nan) {
      const double threshold = field_.threshold();
      if (before == after && (trend.v.lo > threshold || trend.v.hi <= threshold)) return;
      Interval slope;
      for (std::size_t k = 0; k < 3; ++k) {
        slope += trend_detail::product(trend.d[k], ray_.d[static_cast<int>(k)]);
      }
      if (!slope.nan) {
        piece.slope = narrowed(piece.slope, slope);
        if (decided()) return;
      }
    }
  }
  const double middle = piece.a + length / 2;
  const double g = value(middle);
  resolve({piece.a, piece.ga, middle, g, piece.slope}, depth + 1);
  if (!done_) resolve({middle, g, piece.b, piece.gb, piece.slope}, depth + 1);
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
  for (int i = 0; i < 100 && b - a > 1e-4 * fine_; ++i) {
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

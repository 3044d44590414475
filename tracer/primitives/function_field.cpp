#include "tracer/primitives/function_field.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "functions/waves.h"

namespace durer::tracer {
namespace {

using functions::Function;
using State = FieldLink::State;

/// The least float that is not below `v`.
float rounded_up(double v) {
  const auto f = static_cast<float>(v);
  if (!(static_cast<double>(f) < v)) return f;
  if (f == 0) return std::numeric_limits<float>::denorm_min();
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(f) + (f > 0 ? 1 : -1));
}

/// A dozen steps of single precision: what sums of a few products may be off by.
constexpr double short_rounding = 12 * 0x1p-24;

/// See FunctionField::hair_.
dvec3 hair_around(const Bounds3& box) {
  const dvec3 farthest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  return 1e-6 * (box.hi - box.lo) + 1e-13 * (farthest.x + farthest.y + farthest.z);
}

constexpr double infinite = std::numeric_limits<double>::infinity();

double load(const std::atomic<float>& v) {
  return static_cast<double>(v.load(std::memory_order_relaxed));
}
dvec3 to_dvec3(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

/// What a linear function, value + slope · q with q from the field's centre, is over a cell; a hair
/// more, for rounding.
struct Spread {
  double lo, hi;
};
Spread spread_over(double value, const dvec3& g, const FieldDetail& cell, const dvec3& centre,
                   const dvec3& hair) {
  const dvec3 q = cell.centre - centre;
  const double middle = value + glm::dot(g, q);
  const double rounding = 1e-14 * (std::abs(value) + glm::dot(glm::abs(g), glm::abs(q)));
  const double radius = (1 + 1e-8) * glm::dot(glm::abs(g), cell.half + hair) + rounding;
  return {middle - radius, middle + radius};
}

/// The axis along which the function and its slope vary most over a cell, as far as is known; else
/// the longest. What varies in slope counts twice: it is what keeps searches from being short.
int axis_to_halve(const Trend& trend, const dvec3& half) {
  int best = 0;
  double most = -1;
  bool known = true;
  for (int k = 0; k < 3; ++k) {
    const Interval d = trend.slope(static_cast<std::size_t>(k));
    known = known && d.is_bounded();
  }
  for (int k = 0; k < 3; ++k) {
    const Interval d = trend.slope(static_cast<std::size_t>(k));
    const double steepest =
        known ? std::max(std::abs(d.lo), std::abs(d.hi)) + 2 * (d.hi - d.lo) : 1;
    if (steepest * half[k] > most) {
      most = steepest * half[k];
      best = k;
    }
  }
  return best;
}

}  // namespace

FieldHalves* FieldStore::make() {
  while (true) {
    Chunk* const chunk = last_.load(std::memory_order_acquire);
    if (chunk != nullptr) {
      const std::size_t i = chunk->used.fetch_add(1, std::memory_order_relaxed);
      if (i < chunk->size) return new (chunk->places.get() + i) FieldHalves;
    }
    add_chunk(chunk);
  }
}

/// Unless somebody else has.
void FieldStore::add_chunk(const Chunk* full) {
  const std::lock_guard guard(adding_);
  if (last_.load(std::memory_order_relaxed) != full) return;
  constexpr std::size_t most = 4096;
  const std::size_t size = full == nullptr ? 16 : std::min(2 * full->size, most);
  chunks_.push_back(std::make_unique<Chunk>(size));
  last_.store(chunks_.back().get(), std::memory_order_release);
}

bool can_be_bounded(const functions::Function& f) {
  for (const functions::External& e : f.externals) {
    if (e.box == nullptr) return false;
  }
  return std::all_of(f.callees.begin(), f.callees.end(),
                     [](const functions::FunctionRef& g) { return can_be_bounded(*g); });
}

functions::Workspace& function_workspace(functions::NoiseGenerator generator) {
  thread_local functions::Workspace workspace;
  workspace.context.noise_generator = generator;
  return workspace;
}

FunctionField::FunctionField(functions::FunctionRef function, double threshold, const Bounds3& box,
                             functions::NoiseGenerator generator)
    : function_(std::make_shared<const functions::Function>(functions::with_waves(*function))),
      threshold_(threshold),
      box_(box),
      generator_(generator),
      hair_(hair_around(box)),
      has_bounds_(can_be_bounded(*function_)) {
  if (!has_bounds_) return;
  trends_.emplace(function_);
  root_detail_.centre = centre();
  root_detail_.half = half();
  root_detail_.tape = function_.get();
  examine(root_, root_detail_, function_workspace(generator_));
}

FieldLink FunctionField::split(const FieldCell& cell, FieldLink link, std::size_t next) const {
  functions::Workspace& workspace = function_workspace(generator_);
  FieldHalves* const made = store_.make();
  const FieldDetail& parent = link.detail();
  const int k = link.axis();
  made->plane = parent.centre[k];
  made->short_plane = static_cast<float>(parent.centre[k] - centre()[k]);
  const double bound = load(cell.above);
  for (const std::size_t i : {1 - next, next}) {  // what is examined last is remembered
    FieldDetail& part = made->details[i];
    part = parent;
    part.half[k] *= 0.5;
    part.centre[k] += i == 0 ? -part.half[k] : part.half[k];
    part.depth = parent.depth + 1;
    part.parent = &parent;
    FieldCell& half = made->cells[i];
    // What is known of the whole may do.
    const Spread m =
        spread_over(static_cast<double>(cell.value), to_dvec3(cell.slope), part, centre(), hair_);
    if (m.lo > bound) {
      half.link = FieldLink(State::outside, 0, &part);
    } else if (m.hi < -bound) {
      half.link = FieldLink(State::inside, 0, &part);
    } else {
      examine(half, part, workspace);
    }
  }
  const FieldLink halved(link.state() == State::smooth ? State::refined : State::vague, k,
                         made);
  if (cell.link.compare_exchange_strong(link, halved, std::memory_order_acq_rel)) {
    for (const FieldDetail* d = &parent; d != nullptr && tighten(*d); d = d->parent) {
    }
    return halved;
  }
  return link;  // another thread was faster; its cells are the same, and these are left over
}

/// Draws the bounds of a halved cell together by those of its halves. False if there was next to
/// nothing to gain, or nothing that could be of use to cells around it.
bool FunctionField::tighten(const FieldDetail& detail) const {
  const FieldCell& cell = *detail.cell;
  const FieldLink link = cell.link.load(std::memory_order_acquire);
  if (link.state() == State::refined)
    return false;  // searches in it must not depend on who came first
  const auto value = static_cast<double>(cell.value);
  const dvec3 slope = to_dvec3(cell.slope);
  double above = -infinite;
  double below = infinite;
  for (std::size_t i = 0; i < 2; ++i) {
    const FieldCell& half = link.halves().cells[i];
    const FieldDetail& part = link.halves().details[i];
    const State state = half.link.load(std::memory_order_acquire).state();
    const Spread m = spread_over(value, slope, part, centre(), hair_);
    Spread lead = m;  // of m where the half leaves the sign open
    if (state > State::outside) {
      const Spread ahead = spread_over(value - static_cast<double>(half.value),
                                       slope - to_dvec3(half.slope), part, centre(), hair_);
      lead.hi = std::min(m.hi, ahead.hi + load(half.above));
      lead.lo = std::max(m.lo, ahead.lo + load(half.below));
    }
    if (state != State::outside) above = std::max(above, lead.hi);
    if (state != State::inside) below = std::min(below, lead.lo);
  }
  const double old_above = load(cell.above);
  const double old_below = load(cell.below);
  above = std::min(above, old_above);
  below = std::max(below, old_below);
  if (!(old_above - above + below - old_below > 0.01 * (old_above - old_below))) return false;
  cell.above.store(rounded_up(above), std::memory_order_relaxed);
  cell.below.store(-rounded_up(-below), std::memory_order_relaxed);
  const Spread m = spread_over(value, slope, detail, centre(), hair_);
  if (m.hi <= above && m.lo >= below) return false;
  if (link.state() == State::vague) {
    cell.link.store({State::halved, link.axis(), &link.halves()}, std::memory_order_release);
  }
  return true;
}

/// Fills in what is known about a cell from the bounds of the function over it.
void FunctionField::examine(FieldCell& cell, FieldDetail& detail,
                            functions::Workspace& workspace) const {
  const dvec3& c = detail.centre;
  detail.cell = &cell;
  const dvec3 reach = detail.half + hair_;
  const std::array<Interval, 3> box{Interval{c.x - reach.x, c.x + reach.x},
                                    Interval{c.y - reach.y, c.y + reach.y},
                                    Interval{c.z - reach.z, c.z + reach.z}};
  const auto set = [&](State state, int axis = 0) {
    cell.link.store({state, axis, &detail}, std::memory_order_relaxed);
  };
  static thread_local functions::BoxTrends::Memory memory;
  const Trend trend = (*trends_)(box, {c.x, c.y, c.z}, workspace, memory);
  const Interval range = trend.range();
  if (!range.nan) {
    if (range.hi <= threshold_) return set(State::inside);
    if (range.lo > threshold_) return set(State::outside);
  }
  dvec3 slope(0.0);
  dvec3 spread(0.0);
  bool known = !range.nan;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Interval d = trend.slope(i);
    known = known && d.is_bounded();
    if (!known) break;
    cell.slope[i] = static_cast<float>(d.mid());
    slope[k] = static_cast<double>(cell.slope[i]);
    detail.spread[i] = rounded_up(std::max(d.hi - slope[k], slope[k] - d.lo) +
                                  short_rounding * std::abs(slope[k]));
    spread[k] = static_cast<double>(detail.spread[i]);
  }
  const double steepness = glm::dot(slope, slope);
  const double variation = glm::dot(spread, spread);
  known = known && std::isfinite(steepness) && std::isfinite(variation);
  const bool smooth = known && variation <= smoothness * smoothness * steepness;
  const State state = smooth                       ? State::smooth
                      : detail.depth < field_depth ? State::whole
                                                   : State::rough;
  set(state, axis_to_halve(trend, detail.half));
  cell.above = std::numeric_limits<float>::infinity();
  cell.below = -std::numeric_limits<float>::infinity();
  if (!known) return;
  const double value = (*trends_)(std::array{c.x, c.y, c.z}, workspace, memory) - threshold_;
  const dvec3 from_centre = c - centre();
  const double at_centre = value - glm::dot(slope, from_centre);
  cell.value = static_cast<float>(at_centre);
  // Lines are followed in single precision as well, from one end of the box to the other.
  const double rounding =
      std::abs(at_centre - static_cast<double>(cell.value)) +
      short_rounding * (std::abs(at_centre) + 2 * glm::dot(glm::abs(slope), half()));
  cell.above = rounded_up(rounding + glm::dot(spread, reach));
  cell.below = -cell.above;
  // The linear bounds may settle what the range could not.
  const double swing = static_cast<double>(cell.above) + glm::dot(glm::abs(slope), reach);
  if (value > swing) set(State::outside);
  if (value < -swing) set(State::inside);
}

}  // namespace durer::tracer

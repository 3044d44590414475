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

dvec3 to_dvec3(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

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
  examine(root_, root_detail_, half(), function_workspace(generator_));
}

dvec3 FunctionField::half_of(const FieldDetail& cell) const {
  dvec3 half = this->half();
  for (int k = 0; k < 3; ++k) {
    half[k] = std::ldexp(half[k], -cell.halvings[static_cast<std::size_t>(k)]);
  }
  return half;
}

FieldLink FunctionField::split(const FieldCell& cell, FieldLink link, std::size_t next) const {
  functions::Workspace& workspace = function_workspace(generator_);
  FieldHalves* const made = store_.make();
  const FieldDetail& parent = link.detail();
  const int k = link.axis();
  dvec3 half = half_of(parent);
  half[k] *= 0.5;
  const dvec3 slope = to_dvec3(cell.slope);
  const double swing = glm::dot(glm::abs(slope), half + hair_) + static_cast<double>(cell.error);
  for (const std::size_t i : {1 - next, next}) {  // what is examined last is remembered
    FieldDetail& part = made->details[i];
    part.centre = parent.centre;
    part.centre[k] += i == 0 ? -half[k] : half[k];
    part.halvings = parent.halvings;
    ++part.halvings[static_cast<std::size_t>(k)];
    part.parent = &parent;
    // What is known of the whole may do.
    const double middle = static_cast<double>(cell.value) + glm::dot(slope, part.centre - centre());
    FieldCell& place = made->cells[i];
    if (middle > swing) {
      place.link.set({State::outside, 0, &part});
    } else if (middle < -swing) {
      place.link.set({State::inside, 0, &part});
    } else {
      examine(place, part, half, workspace);
    }
  }
  const FieldLink halved(link.state() == State::smooth ? State::refined : State::halved, k, made);
  // If another thread was faster, its cells are the same, and these are left over.
  return cell.link.replace(link, halved);
}

/// Fills in what is known about a cell from the bounds of the function over it.
void FunctionField::examine(FieldCell& cell, FieldDetail& detail, const dvec3& half,
                            functions::Workspace& workspace) const {
  const dvec3& c = detail.centre;
  const dvec3 reach = half + hair_;
  const std::array<Interval, 3> box{Interval{c.x - reach.x, c.x + reach.x},
                                    Interval{c.y - reach.y, c.y + reach.y},
                                    Interval{c.z - reach.z, c.z + reach.z}};
  const auto set = [&](State state, int axis = 0) { cell.link.set({state, axis, &detail}); };
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
  const State state = smooth                         ? State::smooth
                      : detail.depth() < field_depth ? State::whole
                                                     : State::rough;
  const int axis = axis_to_halve(trend, half);
  set(state, axis);
  cell.plane = static_cast<float>(c[axis] - centre()[axis]);
  cell.error = std::numeric_limits<float>::infinity();
  if (!known) return;
  const double value = (*trends_)(std::array{c.x, c.y, c.z}, workspace, memory) - threshold_;
  const dvec3 from_centre = c - centre();
  const double at_centre = value - glm::dot(slope, from_centre);
  cell.value = static_cast<float>(at_centre);
  // Lines are followed in single precision as well, from one end of the box to the other.
  const double rounding =
      std::abs(at_centre - static_cast<double>(cell.value)) +
      short_rounding * (std::abs(at_centre) + 2 * glm::dot(glm::abs(slope), this->half()));
  cell.error = rounded_up(rounding + glm::dot(spread, reach));
  // The linear bounds may settle what the range could not.
  const double swing = static_cast<double>(cell.error) + glm::dot(glm::abs(slope), reach);
  if (value > swing) set(State::outside);
  if (value < -swing) set(State::inside);
}

}  // namespace durer::tracer

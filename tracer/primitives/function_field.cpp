#include "tracer/primitives/function_field.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace durer::tracer {
namespace {

using functions::Function;
using State = FieldCell::State;

/// Cells are halved at most this often: a hundred cells or so along each edge of the box.
constexpr int depth_limit = 20;
/// Slopes are known well if they vary by less than this share of the gradient.
constexpr double smoothness = 0.35;

/// The least float that is not below `v`.
float rounded_up(double v) {
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

void delete_halves(const FieldCell& cell) {
  const FieldHalves* halves = cell.halves.load(std::memory_order_relaxed);
  if (halves == nullptr) return;
  for (const FieldCell& half : halves->cells) delete_halves(half);
  delete halves;
}

/// The axis along which the function and its slope vary most over a cell, as far as is known; else
/// the longest. What varies in slope counts twice: it is what keeps searches from being short.
std::uint8_t axis_to_halve(const Trend& trend, const dvec3& half) {
  int best = 0;
  double most = -1;
  bool known = true;
  for (int k = 0; k < 3; ++k) {
    const Interval& d = trend.d[static_cast<std::size_t>(k)];
    known = known && !d.nan && d.is_bounded();
  }
  for (int k = 0; k < 3; ++k) {
    const Interval& d = trend.d[static_cast<std::size_t>(k)];
    const double steepest = known ? std::max(std::abs(d.lo), std::abs(d.hi)) + 2 * (d.hi - d.lo) : 1;
    if (steepest * half[k] > most) {
      most = steepest * half[k];
      best = k;
    }
  }
  return static_cast<std::uint8_t>(best);
}

}  // namespace

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
    : function_(std::move(function)),
      threshold_(threshold),
      box_(box),
      generator_(generator),
      has_bounds_(can_be_bounded(*function_)) {
  root_.tape = function_.get();
  if (has_bounds_) examine(root_, centre(), half(), 0, function_workspace(generator_));
}

FunctionField::~FunctionField() { delete_halves(root_); }

const FieldHalves& FunctionField::split(const FieldCell& cell, const dvec3& centre,
                                        const dvec3& half, int depth) const {
  functions::Workspace& workspace = function_workspace(generator_);
  auto made = std::make_unique<FieldHalves>();
  dvec3 part = half;
  part[cell.axis] *= 0.5;
  for (std::size_t i = 0; i < 2; ++i) {
    dvec3 middle = centre;
    middle[cell.axis] += i == 0 ? -part[cell.axis] : part[cell.axis];
    made->cells[i].tape = cell.tape;
    examine(made->cells[i], middle, part, depth + 1, workspace);
  }
  // Another thread may have been faster; its cells are the same.
  const FieldHalves* expected = nullptr;
  if (cell.halves.compare_exchange_strong(expected, made.get(), std::memory_order_acq_rel)) {
    return *made.release();
  }
  return *expected;
}

/// Fills in what is known about a cell from the bounds of the function over it.
void FunctionField::examine(FieldCell& cell, const dvec3& centre, const dvec3& half, int depth,
                            functions::Workspace& workspace) const {
  // A hair wider, because the ray's points are rounded.
  const dvec3 reach = half * (1 + 1e-9) + dvec3(1e-13 * glm::length(centre));
  const std::array<Interval, 3> box{Interval{centre.x - reach.x, centre.x + reach.x},
                                    Interval{centre.y - reach.y, centre.y + reach.y},
                                    Interval{centre.z - reach.z, centre.z + reach.z}};
  const Trend trend = functions::evaluate_trend(*cell.tape, box, workspace);
  if (!trend.v.nan) {
    if (trend.v.hi <= threshold_) return void(cell.state = State::inside);
    if (trend.v.lo > threshold_) return void(cell.state = State::outside);
  }
  double steepness = 0;
  double variation = 0;
  bool known = !trend.v.nan;
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval& d = trend.d[k];
    known = known && !d.nan && d.is_bounded();
    if (!known) break;
    cell.slope[k] = static_cast<float>(d.mid());
    cell.spread[k] = rounded_up(std::max(d.hi - static_cast<double>(cell.slope[k]),
                                         static_cast<double>(cell.slope[k]) - d.lo));
    steepness += std::pow(static_cast<double>(cell.slope[k]), 2);
    variation += std::pow(static_cast<double>(cell.spread[k]), 2);
  }
  known = known && std::isfinite(steepness) && std::isfinite(variation);
  const bool smooth = known && variation <= smoothness * smoothness * steepness;
  cell.state = smooth ? State::smooth : depth < depth_limit ? State::mixed : State::rough;
  cell.error = std::numeric_limits<float>::infinity();
  cell.axis = axis_to_halve(trend, half);
  if (!known) return;
  cell.value = functions::evaluate(*cell.tape, std::array{centre.x, centre.y, centre.z}, workspace) -
               threshold_;
  double error = 1e-9 * std::abs(cell.value);
  for (int k = 0; k < 3; ++k) {
    error += static_cast<double>(cell.spread[static_cast<std::size_t>(k)]) * reach[k];
  }
  cell.error = rounded_up(error);
  // The linear bounds may settle what the range could not.
  double swing = static_cast<double>(cell.error);
  for (int k = 0; k < 3; ++k) {
    swing += std::abs(static_cast<double>(cell.slope[static_cast<std::size_t>(k)])) * reach[k];
  }
  if (cell.value > swing) cell.state = State::outside;
  if (cell.value < -swing) cell.state = State::inside;
}

}  // namespace durer::tracer

#include "tracer/primitives/function_field.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace durer::tracer {
namespace {

using functions::Function;
using State = FieldCell::State;

/// Cells are split at most this often: 256 cells along an edge of the box.
constexpr int depth_limit = 8;
/// Slopes are known well if they vary by less than this share of the gradient.
constexpr double smoothness = 0.35;

/// The least float that is not below `v`.
float rounded_up(double v) {
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

void delete_children(const FieldCell& cell) {
  const FieldBlock* block = cell.children.load(std::memory_order_relaxed);
  if (block == nullptr) return;
  for (const FieldCell& child : block->cells) delete_children(child);
  delete block;
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

FunctionField::~FunctionField() { delete_children(root_); }

const FieldBlock& FunctionField::split(const FieldCell& cell, const dvec3& centre,
                                       const dvec3& half, int depth) const {
  functions::Workspace& workspace = function_workspace(generator_);
  auto made = std::make_unique<FieldBlock>();
  const dvec3 quarter = half * 0.5;
  for (unsigned i = 0; i < 8; ++i) {
    const dvec3 side((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    FieldCell& child = made->cells[i];
    child.tape = cell.tape;
    examine(child, centre + side * quarter, quarter, depth + 1, workspace);
    if (child.state == State::inside) made->inside |= 1U << i;
    if (child.state == State::outside) made->outside |= 1U << i;
  }
  // Another thread may have been faster; its cells are the same.
  const FieldBlock* expected = nullptr;
  if (cell.children.compare_exchange_strong(expected, made.get(), std::memory_order_acq_rel)) {
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
    const double extent = half[static_cast<int>(k)];
    steepness += std::pow(static_cast<double>(cell.slope[k]) * extent, 2);
    variation += std::pow(static_cast<double>(cell.spread[k]) * extent, 2);
  }
  known = known && std::isfinite(steepness) && std::isfinite(variation);
  const bool smooth = known && variation <= smoothness * smoothness * steepness;
  cell.state = smooth ? State::smooth : depth < depth_limit ? State::mixed : State::rough;
  cell.error = std::numeric_limits<float>::infinity();
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

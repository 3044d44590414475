// What is known about a function over the box in which it is looked at: a tree of cells, made where
// rays come by. Each cell holds bounds of the function and of its slopes, so that most of a ray
// needs no evaluation at all.
#pragma once

#include <array>
#include <atomic>
#include <memory>

#include "base/bounds.h"
#include "functions/evaluate.h"

namespace durer::tracer {

/// The workspace of this thread, for evaluations in a scene with that noise generator. Tapes need
/// room for their registers; it grows once.
[[nodiscard]] functions::Workspace& function_workspace(functions::NoiseGenerator generator);

/// False if some value in the function comes from outside and cannot be bounded over boxes.
[[nodiscard]] bool can_be_bounded(const functions::Function& f);

struct FieldBlock;

/// Where a function lies in relation to a threshold, over a cell of space.
struct FieldCell {
  enum class State : std::uint8_t {
    inside,   // nowhere above the threshold
    outside,  // everywhere above it
    smooth,   // on both sides perhaps; the slopes are known well
    rough,    // likewise, but they are not, and the cell is as small as cells get
    mixed,    // likewise, and it has children, or will have
  };
  State state = State::rough;
  /// At a point c + q of the cell, c its centre, the function lies within
  /// value + slope · q ± error above the threshold; its slope along axis k is slope[k] ± spread[k].
  float error = 0;
  double value = 0;
  std::array<float, 3> slope{};
  std::array<float, 3> spread{};
  /// The function, without what makes no difference in this cell.
  const functions::Function* tape = nullptr;
  mutable std::atomic<const FieldBlock*> children{nullptr};
};

/// The eight parts of a cell: bit k of an index is set where coordinate k is higher.
struct FieldBlock {
  // Which of them are decided; a line that passes those need not look at them.
  unsigned inside = 0;
  unsigned outside = 0;
  std::array<FieldCell, 8> cells;
};

/// A function g(x, y, z) = f - threshold in a box. Cells depend on the function alone, not on who
/// asks first, so pictures do not depend on it either.
class FunctionField {
 public:
  FunctionField(functions::FunctionRef function, double threshold, const Bounds3& box,
                functions::NoiseGenerator generator);
  ~FunctionField();
  FunctionField(const FunctionField&) = delete;
  FunctionField& operator=(const FunctionField&) = delete;

  [[nodiscard]] const functions::Function& function() const { return *function_; }
  [[nodiscard]] double threshold() const { return threshold_; }
  [[nodiscard]] const Bounds3& box() const { return box_; }
  [[nodiscard]] functions::NoiseGenerator generator() const { return generator_; }

  [[nodiscard]] const FieldCell& root() const { return root_; }
  [[nodiscard]] dvec3 centre() const { return (box_.lo + box_.hi) * 0.5; }
  [[nodiscard]] dvec3 half() const { return (box_.hi - box_.lo) * 0.5; }
  /// The parts of a mixed cell.
  [[nodiscard]] const FieldBlock& children(const FieldCell& cell, const dvec3& centre,
                                           const dvec3& half, int depth) const {
    const FieldBlock* made = cell.children.load(std::memory_order_acquire);
    return made != nullptr ? *made : split(cell, centre, half, depth);
  }

  /// True if the function can be bounded over boxes at all.
  [[nodiscard]] bool has_bounds() const { return has_bounds_; }

 private:
  const FieldBlock& split(const FieldCell& cell, const dvec3& centre, const dvec3& half,
                          int depth) const;
  void examine(FieldCell& cell, const dvec3& centre, const dvec3& half, int depth,
               functions::Workspace& workspace) const;

  functions::FunctionRef function_;
  double threshold_;
  Bounds3 box_;
  functions::NoiseGenerator generator_;
  bool has_bounds_ = true;
  FieldCell root_;
};

}  // namespace durer::tracer

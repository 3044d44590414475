// What is known about a function over the box in which it is looked at: a tree of cells, made where
// rays come by. Each cell holds bounds of the function and of its slopes, so that most of a ray
// needs no evaluation at all.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "base/bounds.h"
#include "functions/box_trends.h"
#include "functions/evaluate.h"

namespace durer::tracer {

/// The workspace of this thread, for evaluations in a scene with that noise generator. Tapes need
/// room for their registers; it grows once.
[[nodiscard]] functions::Workspace& function_workspace(functions::NoiseGenerator generator);

/// False if some value in the function comes from outside and cannot be bounded over boxes.
[[nodiscard]] bool can_be_bounded(const functions::Function& f);

struct FieldCell;
struct FieldHalves;

// How far searches are spared by making cells.
/// Slopes are known well if they vary by less than this share of the gradient: then a cell needs no
/// halves. Anything from 0.35 to 0.9 takes the same time.
inline constexpr double smoothness = 0.7;
/// Greatest number of halvings above a cell: 256 cells along each edge of the box …
inline constexpr int field_depth = 24;
/// … and above cells for lines that graze the surface.
inline constexpr int grazing_depth = 24;

/// What is needed of a cell only where the surface may be inside it.
struct alignas(32) FieldDetail {
  dvec3 centre{0.0};
  std::array<float, 3> spread{};           // the slope along axis k is slope[k] ± spread[k]
  std::array<std::uint8_t, 3> halvings{};  // along each axis, of the box
  const FieldDetail* parent = nullptr;     // the cell that this is half of

  [[nodiscard]] int depth() const { return halvings[0] + halvings[1] + halvings[2]; }
};

/// What kind of cell it is, and where to find more about it, in one word: cells of the same parent
/// share a cache line.
class FieldLink {
 public:
  enum class State : std::uintptr_t {
    inside,   // nowhere above the threshold
    outside,  // everywhere above it
    smooth,   // on both sides perhaps; the slopes are known well
    rough,    // likewise, but they are not, and the cell is as small as cells get
    whole,    // likewise, and it will have halves when somebody comes by
    halved,   // its halves know more
    refined,  // smooth, and halved for lines that graze the surface
  };
  FieldLink() = default;
  explicit FieldLink(std::uintptr_t word) : word_(word) {}
  FieldLink(State state, int axis, const FieldDetail* detail)
      : word_(reinterpret_cast<std::uintptr_t>(detail) | static_cast<std::uintptr_t>(axis) << 3 |
              static_cast<std::uintptr_t>(state)) {}
  FieldLink(State state, int axis, const FieldHalves* halves)
      : word_(reinterpret_cast<std::uintptr_t>(halves) | static_cast<std::uintptr_t>(axis) << 3 |
              static_cast<std::uintptr_t>(state)) {}

  [[nodiscard]] State state() const { return static_cast<State>(word_ & 7); }
  [[nodiscard]] bool has_halves() const { return state() >= State::halved; }
  /// Not for those that are known to be inside or outside: across which axis halves lie, if there
  /// are any.
  [[nodiscard]] int axis() const { return static_cast<int>(word_ >> 3 & 3); }
  /// Smooth, rough or whole.
  [[nodiscard]] const FieldDetail& detail() const {
    return *reinterpret_cast<const FieldDetail*>(word_ & ~std::uintptr_t{31});
  }
  /// Where there are some.
  [[nodiscard]] const FieldHalves& halves() const {
    return *reinterpret_cast<const FieldHalves*>(word_ & ~std::uintptr_t{31});
  }

  [[nodiscard]] std::uintptr_t word() const { return word_; }

 private:
  std::uintptr_t word_ = 0;
};

/// A link that threads share. Not an atomic FieldLink, which compilers read by way of memory: walks
/// wait for each link before they know the next cell.
class SharedFieldLink {
 public:
  [[nodiscard]] FieldLink load() const { return FieldLink(word_.load(std::memory_order_acquire)); }
  /// Before others see it.
  void set(FieldLink link) { word_.store(link.word(), std::memory_order_relaxed); }
  /// Replaces `expected`. What is there from then on: perhaps somebody else's.
  FieldLink replace(FieldLink expected, FieldLink by) const {
    std::uintptr_t found = expected.word();
    return word_.compare_exchange_strong(found, by.word(), std::memory_order_acq_rel)
               ? by
               : FieldLink(found);
  }

 private:
  mutable std::atomic<std::uintptr_t> word_{0};
};

/// Where a function lies in relation to a threshold, over a cell of space. At a point c + q of the
/// cell, c the centre of the whole field, it is within `error` of m = value + slope · q, as long as
/// it may have either sign. A walk through halves needs no more than this line of memory.
struct FieldCell {
  float value = 0;
  std::array<float, 3> slope{};
  float error = 0;
  float plane = 0;  // between the halves, if it has any: their coordinate, from the field's centre
  SharedFieldLink link;
};

/// The lower and the higher half of a cell.
struct FieldHalves {
  alignas(64) std::array<FieldCell, 2> cells;
  std::array<FieldDetail, 2> details;

  /// Of the cell that they are halves of.
  [[nodiscard]] const FieldDetail& whole() const { return *details[0].parent; }
};

/// Memory of all cells of a field, which live as long as it does.
class FieldStore {
 public:
  /// For any thread at any time.
  [[nodiscard]] FieldHalves* make();

 private:
  /// Places in which pairs are made one after the other; nothing of them has to be destroyed.
  struct Chunk {
    struct alignas(FieldHalves) Place {
      std::byte bytes[sizeof(FieldHalves)];
    };
    explicit Chunk(std::size_t n) : size(n), places(new Place[n]) {}

    std::size_t size;
    std::unique_ptr<Place[]> places;
    std::atomic<std::size_t> used{0};  // or more, where several came too late
  };
  static_assert(std::is_trivially_destructible_v<FieldHalves>);
  void add_chunk(const Chunk* full);

  std::atomic<Chunk*> last_{nullptr};
  std::mutex adding_;
  std::vector<std::unique_ptr<Chunk>> chunks_;
};

/// A function g(x, y, z) = f - threshold in a box. Cells depend on the function alone, not on who
/// asks first, so pictures do not depend on it either.
class FunctionField {
 public:
  FunctionField(functions::FunctionRef function, double threshold, const Bounds3& box,
                functions::NoiseGenerator generator);
  ~FunctionField() = default;
  FunctionField(const FunctionField&) = delete;
  FunctionField& operator=(const FunctionField&) = delete;

  /// The function as it is evaluated: in the last bits not the one that was given.
  [[nodiscard]] const functions::FunctionRef& function() const { return function_; }
  [[nodiscard]] double threshold() const { return threshold_; }
  [[nodiscard]] const Bounds3& box() const { return box_; }
  [[nodiscard]] functions::NoiseGenerator generator() const { return generator_; }

  [[nodiscard]] const FieldCell& root() const { return root_; }
  [[nodiscard]] dvec3 centre() const { return (box_.lo + box_.hi) * 0.5; }
  [[nodiscard]] dvec3 half() const { return (box_.hi - box_.lo) * 0.5; }
  /// Halves a whole or a smooth cell; gives its link from then on. `next` is the half that is
  /// likely to be split soon: it does not change the result.
  FieldLink split(const FieldCell& cell, FieldLink link, std::size_t next) const;

  /// True if the function can be bounded over boxes at all.
  [[nodiscard]] bool has_bounds() const { return has_bounds_; }

 private:
  void examine(FieldCell& cell, FieldDetail& detail, const dvec3& half,
               functions::Workspace& workspace) const;
  [[nodiscard]] dvec3 half_of(const FieldDetail& cell) const;

  functions::FunctionRef function_;
  std::optional<functions::BoxTrends> trends_;  // if it has bounds
  double threshold_;
  Bounds3 box_;
  functions::NoiseGenerator generator_;
  dvec3 hair_;  // by how much points on lines may lie outside of their cells, for rounding
  bool has_bounds_ = true;
  mutable FieldStore store_;
  FieldCell root_;
  FieldDetail root_detail_;
};

}  // namespace durer::tracer

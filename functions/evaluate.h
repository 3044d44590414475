// The ways to evaluate a compiled function.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "functions/tape.h"

namespace durer::functions {

/// Register frames of one kind of number, in chunks so that growing moves nothing.
template <class T>
class FrameStack {
 public:
  /// `n` numbers of unspecified value, valid until the matching pop.
  [[nodiscard]] T* push(std::size_t n) {
    while (chunk_ < chunks_.size() && used_ + n > chunks_[chunk_].size) next_chunk();
    if (chunk_ == chunks_.size()) add_chunk(n);
    T* frame = chunks_[chunk_].data.get() + used_;
    used_ += n;
    return frame;
  }
  /// A place to come back to.
  struct Mark {
    std::size_t chunk, used;
  };
  [[nodiscard]] Mark mark() const { return {chunk_, used_}; }
  void pop_to(Mark m) {
    chunk_ = m.chunk;
    used_ = m.used;
  }

 private:
  struct Chunk {
    std::unique_ptr<T[]> data;
    std::size_t size;
  };
  void next_chunk() {
    ++chunk_;
    used_ = 0;
  }
  void add_chunk(std::size_t n) {
    const std::size_t size = std::max<std::size_t>(n, 1024);
    chunks_.push_back({std::make_unique<T[]>(size), size});
  }

  std::vector<Chunk> chunks_;
  std::size_t chunk_ = 0;
  std::size_t used_ = 0;
};

/// Per-thread memory of evaluations, and what they need to know about the scene.
struct Workspace {
  Context context;
  /// Turns of sum() and prod() that are left before evaluation gives up with NaN.
  std::uint64_t loop_budget = 10'000'000'000;

  FrameStack<double> points;
  FrameStack<Pack> batches;
  FrameStack<Interval> boxes;
  FrameStack<Dual> gradients;
  FrameStack<Trend> trends;
};

/// Evaluates one function again and again: its frame and constants are set up once. T is double (a
/// point), Pack (eight points), Interval (a box; encloses what points inside it give), Dual (value
/// and gradient, by whatever the arguments' gradients refer to) or Trend (both over a box).
/// Evaluators on one workspace must end in the opposite order of their beginning.
template <class T>
class Evaluator {
 public:
  Evaluator(const Function& f, Workspace& w);
  ~Evaluator();
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// The first component at `arguments`, as many as the function has parameters.
  T operator()(std::span<const T> arguments);
  /// The same where it is, until the next evaluation.
  const T& in_place(std::span<const T> arguments);
  /// The same for arguments that were written to their places.
  [[nodiscard]] T* arguments() { return frame_; }
  const T& in_place();
  /// Component `i` of the last evaluation.
  [[nodiscard]] const T& component(int i) const;

 private:
  const Function& f_;
  Workspace& w_;
  typename FrameStack<T>::Mark mark_;
  T* frame_;
};

/// Single evaluations.
[[nodiscard]] double evaluate(const Function& f, std::span<const double> arguments, Workspace& w);
[[nodiscard]] Interval evaluate_interval(const Function& f, std::span<const Interval> arguments,
                                         Workspace& w);
[[nodiscard]] Dual evaluate_gradient(const Function& f, std::span<const Dual> arguments,
                                     Workspace& w);
/// Value and gradient by the first three parameters.
[[nodiscard]] Dual evaluate_gradient(const Function& f, dvec3 p, Workspace& w);
/// Range and slopes over a box, by the first three parameters.
[[nodiscard]] Trend evaluate_trend(const Function& f, std::span<const Interval> box, Workspace& w);
/// Range over a part `t` of a line origin + t · direction, and as first slope that along the line.
[[nodiscard]] Trend evaluate_along(const Function& f, dvec3 origin, dvec3 direction, Interval t,
                                   Workspace& w);
/// All components; `out` has f.components() places.
void evaluate(const Function& f, std::span<const double> arguments, std::span<double> out,
              Workspace& w);
/// out[i] = f(arguments[0][i], arguments[1][i], …) for n points, bit for bit what `evaluate` gives.
/// `arguments` holds one array of n numbers per parameter.
void evaluate_batch(const Function& f, std::span<const double* const> arguments, std::size_t n,
                    double* out, Workspace& w);

/// Value of a plain operation on up to four numbers; what constant folding uses.
[[nodiscard]] double evaluate_op(Op op, std::span<const double> arguments);

}  // namespace durer::functions

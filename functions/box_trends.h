// Trends of one function over boxes of which each has edges in common with the last.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "functions/evaluate.h"

namespace durer::functions {

/// For a function of three parameters. What depends on edges that are those of the last box is not
/// computed again; the results are those of evaluate_trend(), bit for bit.
class BoxTrends {
 public:
  using Box = std::array<Interval, 3>;

  /// What one thread remembers of the last box.
  class Memory {
    friend class BoxTrends;
    std::uint64_t owner_ = 0;
    Box box_{};
    std::vector<Trend> registers_;
  };

  explicit BoxTrends(FunctionRef function);

  [[nodiscard]] Trend operator()(const Box& box, Workspace& w, Memory& memory) const;

 private:
  FunctionRef function_;
  std::uint64_t number_;            // unlike that of any other
  std::array<Function, 8> parts_;  // by the parameters that have changed, as bits
};

}  // namespace durer::functions

// Trends of one function over boxes of which each has edges in common with the last, and values at
// their centres.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "functions/evaluate.h"

namespace durer::functions {

/// For a function of three parameters. What depends on edges or coordinates that are those of the
/// last box or point is not computed again; the results are those of evaluate_trend() and
/// evaluate(), bit for bit.
class BoxTrends {
 public:
  using Box = std::array<Interval, 3>;
  using Point = std::array<double, 3>;

  /// What one thread remembers of the last box and of the last point.
  class Memory {
    friend class BoxTrends;
    template <class T, class Arguments>
    struct Last {
      std::uint64_t owner = 0;
      Arguments arguments{};
      std::vector<T> registers;
    };
    Last<Trend, Box> box_;
    Last<double, Point> point_;
  };

  explicit BoxTrends(FunctionRef function);

  [[nodiscard]] Trend operator()(const Box& box, Workspace& w, Memory& memory) const;
  [[nodiscard]] double operator()(const Point& p, Workspace& w, Memory& memory) const;

 private:
  template <class T, class Arguments>
  const T& evaluate_anew(const Arguments& arguments, Workspace& w,
                         Memory::Last<T, Arguments>& last) const;

  std::uint64_t number_;            // unlike that of any other
  Function whole_;                  // with waves one by one, lest results depend on what was last
  std::array<Function, 8> parts_;  // by the parameters that have changed, as bits
};

}  // namespace durer::functions

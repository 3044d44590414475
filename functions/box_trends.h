// Trends of one function over boxes of which each has edges in common with the last, and values at
// their centres.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "functions/evaluate.h"

namespace durer::functions {

/// For a function of three parameters. What depends on edges or coordinates that are those of the
/// last box or point is not computed again; results do not depend on what was last. Values are those
/// of evaluate() and trends those of evaluate_trend(), or narrower: where an operation asks on which
/// side of something its operand lies, the operand's range is narrowed by its value at the centre
/// and its slopes.
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

  /// `centre`: of the box, nearly.
  [[nodiscard]] Trend operator()(const Box& box, const Point& centre, Workspace& w,
                                 Memory& memory) const;
  [[nodiscard]] double operator()(const Point& p, Workspace& w, Memory& memory) const;

 private:
  /// A register whose range is narrowed before the instruction at `pc`.
  struct Stop {
    std::uint32_t pc;
    Register operand;
  };
  struct Part {
    Function tape;
    std::vector<Stop> stops;
  };
  [[nodiscard]] static Part with_stops(Function tape);
  /// The instructions that are to be run, after the arguments have been set.
  template <class T, class Arguments>
  const Part* prepare(const Arguments& arguments, Workspace& w,
                      Memory::Last<T, Arguments>& last) const;

  std::uint64_t number_;        // unlike that of any other
  Part whole_;                  // with waves one by one, lest results depend on what was last
  std::array<Part, 8> parts_;  // by the parameters that have changed, as bits
};

}  // namespace durer::functions

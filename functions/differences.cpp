#include "functions/differences.h"

#include <algorithm>

#include "functions/dependence.h"
#include "functions/machine.h"

namespace durer::functions {
Differences::Differences(FunctionRef function)
    : function_(std::move(function)),
      changes_{depending_on(*function_, 1), depending_on(*function_, 2),
               depending_on(*function_, 4)} {}

std::array<double, 4> Differences::operator()(const dvec3& p, double step, Workspace& w) const {
  const Function& f = *function_;
  const auto mark = w.points.mark();
  double* const here = w.points.push(f.registers);
  double* const there = w.points.push(f.registers);
  for (int k = 0; k < 3; ++k) here[k] = p[k];
  Machine<double> whole(f, here, w);
  whole.load_constants();
  whole.run();
  std::array<double, 4> values{here[f.results[0]]};
  for (int k = 0; k < 3; ++k) {
    std::copy_n(here, f.registers, there);
    there[k] += step;
    Machine<double>(changes_[static_cast<std::size_t>(k)], there, w).run();
    values[static_cast<std::size_t>(k) + 1] = there[f.results[0]];
  }
  w.points.pop_to(mark);
  return values;
}

}  // namespace durer::functions

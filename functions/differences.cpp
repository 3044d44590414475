#include "functions/differences.h"

#include <algorithm>

#include "functions/machine.h"
#include "functions/operands.h"

namespace durer::functions {
namespace {

/// The instructions whose results may change with parameter `axis`. Those with branches or loops
/// count as a whole tape: all instructions stay.
Function depending_on(const Function& f, Register axis) {
  Function part = f;
  const auto branches = [](const Instruction& in) {
    return in.op == Op::select || in.op == Op::loop;
  };
  if (std::any_of(f.code.begin(), f.code.end(), branches)) return part;
  std::vector<bool> changes(f.registers);
  changes[axis] = true;
  part.code.clear();
  for (const Instruction& in : f.code) {
    bool depends = false;
    for_operands(f, in, [&](const Register& r) { depends = depends || changes[r]; });
    if (!depends) continue;
    part.code.push_back(in);
    for (std::uint32_t i = 0; i < results_of(in); ++i) changes[in.dst + i] = true;
  }
  return part;
}

}  // namespace

Differences::Differences(FunctionRef function)
    : function_(std::move(function)),
      changes_{depending_on(*function_, 0), depending_on(*function_, 1),
               depending_on(*function_, 2)} {}

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

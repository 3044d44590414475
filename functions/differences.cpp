#include "functions/differences.h"

#include "functions/dependence.h"
#include "functions/machine.h"

namespace durer::functions {

Differences::Differences(FunctionRef function) : here_(*function), step_(4 * function->registers) {
  for (Register k = 0; k < 3; ++k) {
    const Register distance = (k + 1) * function->registers;
    const unsigned axis = 1U << k;
    beside_[k] = moved(depending_on(*function, axis), axis, distance);
    here_.code.push_back({Op::add, 0, k + distance, k, step_});
  }
  here_.registers = step_ + 1;
}

/// Runs all tapes on a frame whose first registers are a place.
template <class T>
void Differences::evaluate(T* registers, double step, Workspace& w) const {
  spread_all(&step, 1, registers + step_);
  Machine<T> here(here_, registers, w);
  here.load_constants();
  here.run();
  for (const Function& tape : beside_) Machine<T>(tape, registers, w).run();
}

std::array<double, 4> Differences::operator()(const dvec3& p, double step, Workspace& w) const {
  const auto mark = w.points.mark();
  double* const registers = w.points.push(here_.registers);
  for (int k = 0; k < 3; ++k) registers[k] = p[k];
  evaluate(registers, step, w);
  const std::array<double, 4> values{registers[here_.results[0]], registers[beside_[0].results[0]],
                                     registers[beside_[1].results[0]],
                                     registers[beside_[2].results[0]]};
  w.points.pop_to(mark);
  return values;
}

void Differences::operator()(const std::array<const double*, 3>& p, double step,
                             const std::array<double*, 3>& out, Workspace& w) const {
  const auto mark = w.batches.mark();
  Pack* const registers = w.batches.push(here_.registers);
  for (std::size_t k = 0; k < 3; ++k) simd::best_tape_lanes->copy(p[k], 1, registers + k);
  evaluate(registers, step, w);
  const Pack& here = registers[here_.results[0]];
  for (std::size_t k = 0; k < 3; ++k) {
    const Pack difference = registers[beside_[k].results[0]] - here;  // `out` might be anywhere
    std::copy_n(difference.v.begin(), Pack::lanes, out[k]);
  }
  w.batches.pop_to(mark);
}

}  // namespace durer::functions

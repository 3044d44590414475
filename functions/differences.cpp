#include "functions/differences.h"

#include "functions/dependence.h"
#include "functions/machine.h"

namespace durer::functions {

Differences::Differences(FunctionRef function)
    : here_(*function), step_(4 * function->registers) {
  for (Register k = 0; k < 3; ++k) {
    const Register distance = (k + 1) * function->registers;
    const unsigned axis = 1U << k;
    beside_[k] = moved(depending_on(*function, axis), axis, distance);
    here_.code.push_back({Op::add, 0, k + distance, k, step_});
  }
  here_.registers = step_ + 1;
}

template <class T>
std::array<T, 4> Differences::evaluate(const std::array<T, 3>& p, double step,
                                       Workspace& w) const {
  FrameStack<T>& stack = frames(w, T());
  const auto mark = stack.mark();
  T* const registers = stack.push(here_.registers);
  copy_all(p.data(), p.size(), registers);
  spread_all(&step, 1, registers + step_);
  Machine<T> here(here_, registers, w);
  here.load_constants();
  here.run();
  std::array<T, 4> values;
  copy_all(registers + here_.results[0], 1, values.data());
  for (std::size_t k = 0; k < 3; ++k) {
    Machine<T>(beside_[k], registers, w).run();
    copy_all(registers + beside_[k].results[0], 1, values.data() + k + 1);
  }
  stack.pop_to(mark);
  return values;
}

std::array<double, 4> Differences::operator()(const dvec3& p, double step, Workspace& w) const {
  return evaluate(std::array{p.x, p.y, p.z}, step, w);
}
std::array<Pack, 4> Differences::operator()(const std::array<Pack, 3>& p, double step,
                                            Workspace& w) const {
  return evaluate(p, step, w);
}

}  // namespace durer::functions

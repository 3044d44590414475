#include <algorithm>

#include "functions/machine.h"

namespace durer::functions {

void call_external(const External& e, const Context& c, const Interval* a, Interval* out) {
  if (e.box != nullptr) return e.box(e.self.get(), c, a, out);
  std::fill_n(out, e.components, Interval::entire(true));
}

template class Evaluator<Interval>;

Interval evaluate_interval(const Function& f, std::span<const Interval> arguments, Workspace& w) {
  return Evaluator<Interval>(f, w)(arguments);
}

}  // namespace durer::functions

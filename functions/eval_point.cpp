#include "functions/machine.h"

namespace durer::functions {

void call_external(const External& e, const Context& c, const double* a, double* out) {
  e.point(e.self.get(), c, a, out);
}

template class Evaluator<double>;

double evaluate(const Function& f, std::span<const double> arguments, Workspace& w) {
  return Evaluator<double>(f, w)(arguments);
}

void evaluate(const Function& f, std::span<const double> arguments, std::span<double> out,
              Workspace& w) {
  Evaluator<double> evaluator(f, w);
  evaluator(arguments);
  for (int i = 0; i < f.components(); ++i) out[i] = evaluator.component(i);
}

double evaluate_op(Op op, std::span<const double> arguments) {
  using T = double;
  const auto operand = [&](std::size_t i) { return i < arguments.size() ? arguments[i] : 0.0; };
  [[maybe_unused]] const T a = operand(0);
  [[maybe_unused]] const T b = operand(1);
  [[maybe_unused]] const T c = operand(2);
  [[maybe_unused]] const T d = operand(3);
  switch (op) {
#define DURER_OP(name, arity, expression, doc) \
  case Op::name:                               \
    return expression;
#include "functions/ops.def"
#undef DURER_OP
    case Op::internal:
    case Op::call:
    case Op::external:
    case Op::select:
    case Op::loop:
    case Op::waves: break;
  }
  return 0;
}

}  // namespace durer::functions

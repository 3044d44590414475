#include <algorithm>

#include "functions/machine.h"

namespace durer::functions {

void call_external(const External& e, const Context& c, const double* a, double* out) {
  e.point(e.self.get(), c, a, out);
}

double evaluate(const Function& f, std::span<const double> arguments, Workspace& w) {
  double result = 0;
  execute<double>(
      f, w, [&](double* frame) { std::copy(arguments.begin(), arguments.end(), frame); },
      [&](const double* frame) { result = frame[f.results[0]]; });
  return result;
}

void evaluate(const Function& f, std::span<const double> arguments, std::span<double> out,
              Workspace& w) {
  execute<double>(
      f, w, [&](double* frame) { std::copy(arguments.begin(), arguments.end(), frame); },
      [&](const double* frame) {
        for (std::size_t i = 0; i < f.results.size(); ++i) out[i] = frame[f.results[i]];
      });
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
  case Op::name: return expression;
#include "functions/ops.def"
#undef DURER_OP
    case Op::internal: case Op::call: case Op::external: case Op::select: case Op::loop: break;
  }
  return 0;
}

}  // namespace durer::functions

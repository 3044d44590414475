// The rewriting that decides the last bits of a compiled function, and sometimes more (language
// §6.3). The rules are those of the reference program, found by asking it:
// - operations on constants are done at once;
// - x - c is x + (-c), and x / c is x · (1/c), where c is written without parentheses or functions;
// - such constants that follow each other in a sum are added first: x + 0.1 + 0.2 is x + (0.1 +
// 0.2).
//   If the first of them is a product after a minus, the others are subtracted with it:
//   x - 2*3 + 1 is x - (6 + 1). Pictures depend on that slip;
// - in the second and later arguments of a call, sums are not rearranged, and what operations on
//   constants give is no constant to the operation around them;
// - pow() of constants is the C library's, where they are written without parentheses or functions.
// pow(x, 2) to pow(x, 8) are products everywhere else; in later arguments the reference program calls
// the C library instead, which is ten times as slow and differs by an ulp.
#include <cmath>

#include "functions/builder.h"
#include "functions/evaluate.h"

namespace durer::functions {

using Form = Value::Form;

std::optional<double> FunctionBuilder::constant_of(Value v) const {
  const auto place = constant_values_.find(v.index);
  if (place == constant_values_.end()) return std::nullopt;
  return place->second;
}

std::optional<Value> FunctionBuilder::folded(Op op, std::span<const Value> operands) {
  std::array<double, 4> c{};
  bool plain = true;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const auto value = constant_of(operands[i]);
    if (!value) return std::nullopt;
    c[i] = *value;
    plain = plain && operands[i].is_plain_constant();
  }
  if ((op == Op::add || op == Op::subtract) && !plain)
    return std::nullopt;  // it is a chain: see below
  if (op == Op::power && !plain && !in_later_argument()) return std::nullopt;  // products: see below
  if (op == Op::divide && operands[1].is_plain_constant() && in_later_argument()) {
    if (c[1] == 0) report(BuildProblem::division_by_zero);
    op = Op::multiply;
    c[1] = 1 / c[1];
  }
  Value v = constant(evaluate_op(op, std::span(c).first(operands.size())));
  const bool arithmetic = op == Op::add || op == Op::subtract || op == Op::multiply ||
                          op == Op::divide || op == Op::negate;
  v.form = plain && arithmetic && !in_later_argument() ? Form::product : Form::other;
  return v;
}

std::optional<Value> FunctionBuilder::rewritten(Op op, Value a, Value b) {
  const auto left = constant_of(a);
  const auto right = constant_of(b);
  switch (op) {
    case Op::add:
      if (left == 0.0) return group(b);
      if (right) return sum_with_constant(a, b, *right, false);
      break;
    case Op::subtract:
      if (right) return sum_with_constant(a, b, *right, true);
      break;
    case Op::multiply:
      if (left == 1.0) return group(b);
      if (right == 1.0) return group(a);
      if (a.index == b.index) return emit(Op::square, {&a, 1});
      break;
    case Op::divide:
      if (right) return quotient_by_constant(a, b, *right);
      break;
    case Op::power:
      if (right) return constant_power(a, *right);
      break;
    default: break;
  }
  return std::nullopt;
}

Value FunctionBuilder::sum_with_constant(Value a, Value c_value, double c, bool minus) {
  if (c == 0) return c_value.is_plain_constant() ? a : group(a);
  const double signed_c = minus ? -c : c;
  if (!c_value.is_plain_constant() || in_later_argument()) {
    return emit(Op::add, std::array{a, constant(signed_c)});
  }
  OpenSum sum{a.index, signed_c, false};
  if (a.form == Form::open_sum) {
    sum = open_sums_.at(a.index);
    sum.constant += signed_c;
  } else if (minus && c_value.form == Form::product) {
    sum = {a.index, c, true};
  }
  Value v = emit(sum.subtracted ? Op::subtract : Op::add,
                 std::array{Value{sum.base}, constant(sum.constant)});
  open_sums_[v.index] = sum;
  v.form = Form::open_sum;
  return v;
}

Value FunctionBuilder::quotient_by_constant(Value a, Value divisor, double c) {
  if (c == 1) return group(a);
  if (!divisor.is_plain_constant()) return emit(Op::divide, std::array{a, divisor});
  if (c == 0) {
    report(BuildProblem::division_by_zero);
    return constant(0);
  }
  return op(Op::multiply, a, constant(1 / c));
}

std::optional<Value> FunctionBuilder::constant_power(Value base, double exponent) {
  if (exponent == 0) {
    report(BuildProblem::constant_zeroth_power);
    return group(constant(1));
  }
  if (!(exponent >= 2 && exponent <= 8) || exponent != std::trunc(exponent)) return std::nullopt;
  const auto squared = [&](Value v) { return emit(Op::square, {&v, 1}); };
  const auto product = [&](Value u, Value v) { return emit(Op::multiply, std::array{u, v}); };
  const Value x = group(base);
  const Value x2 = squared(x);
  if (exponent == 2) return x2;
  if (exponent == 3) return product(x2, x);
  const Value x4 = squared(x2);
  switch (static_cast<int>(exponent)) {
    case 4: return x4;
    case 5: return product(x4, x);
    case 6: return product(x4, x2);
    case 7: return product(product(x4, x), x2);
    default: return squared(x4);
  }
}

}  // namespace durer::functions

#include "functions/builder.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "functions/evaluate.h"
#include "functions/internals.h"

namespace durer::functions {
namespace {

/// A callee up to this many plain instructions is copied into its caller: a call costs about four.
constexpr std::size_t inline_limit = 24;
/// Calls and nested blocks recurse on the machine stack while evaluating, some 300 bytes each.
constexpr std::uint32_t depth_limit = 200;
constexpr std::size_t size_limit = 1'000'000;

bool is_inlinable(const Function& f) {
  return f.code.size() <= inline_limit && f.selects.empty() && f.loops.empty();
}

}  // namespace

FunctionBuilder::FunctionBuilder(int parameters) {
  f_.parameters = static_cast<std::uint32_t>(parameters);
  next_ = f_.parameters;
}

Value FunctionBuilder::parameter(int index) const {
  assert(index >= 0 && static_cast<std::uint32_t>(index) < f_.parameters);
  return {static_cast<Register>(index)};
}

Value FunctionBuilder::constant(double value) {
  value += 0.0;  // there is no -0 among constants, as in the oracle
  const auto [place, is_new] = constants_.try_emplace(std::bit_cast<std::uint64_t>(value), next_);
  if (is_new) constant_values_[next_++] = value;
  return {place->second, Value::Form::literal};
}

Value FunctionBuilder::op(Op op, Value a) { return this->op(op, std::span(&a, 1)); }
Value FunctionBuilder::op(Op op, Value a, Value b) { return this->op(op, std::array{a, b}); }

Value FunctionBuilder::op(Op op, std::span<const Value> operands) {
  assert(static_cast<std::size_t>(op) < plain_op_count);
  assert(static_cast<int>(operands.size()) == op_table[static_cast<std::size_t>(op)].arity);
  if (const auto v = folded(op, operands)) return *v;
  if (operands.size() == 2) {
    if (const auto v = rewritten(op, operands[0], operands[1])) return *v;
  }
  return emit(op, operands);
}

Value FunctionBuilder::degrees(Value a) {
  return op(Op::multiply, a, constant(180 / std::numbers::pi));
}
Value FunctionBuilder::radians(Value a) {
  return op(Op::multiply, a, constant(std::numbers::pi / 180));
}

// ---- instructions
// --------------------------------------------------------------------------------

Value FunctionBuilder::emit(Op op, std::span<const Value> operands) {
  Key key{op, 0, {}};
  for (const Value& v : operands) key.operands.push_back(v.index);
  if (op == Op::add || op == Op::multiply) std::sort(key.operands.begin(), key.operands.end());
  return {emit_instruction(std::move(key), 0, 1)};
}

Register FunctionBuilder::emit_instruction(Key key, std::uint16_t count, std::uint32_t results) {
  const auto [place, is_new] = known_.try_emplace(key, next_);
  if (!is_new) return place->second;
  if (f_.code.size() >= size_limit) report(BuildProblem::too_large);
  next_ += results;

  Instruction in{key.op, count, place->second, 0, key.callee};
  const bool listed = static_cast<std::size_t>(key.op) >= plain_op_count || key.operands.size() > 2;
  if (listed) {
    in.a = static_cast<std::uint32_t>(f_.operands.size());
    f_.operands.insert(f_.operands.end(), key.operands.begin(), key.operands.end());
  } else {
    in.a = key.operands[0];
    in.b = key.operands.size() == 2 ? key.operands[1] : 0;
  }
  f_.code.push_back(in);
  trail_.push_back(std::move(key));
  return place->second;
}

// ---- calls
// ---------------------------------------------------------------------------------------

std::uint32_t FunctionBuilder::add_callee(const FunctionRef& f) {
  const auto place = std::find(f_.callees.begin(), f_.callees.end(), f);
  const auto index = static_cast<std::uint32_t>(place - f_.callees.begin());
  if (place == f_.callees.end()) f_.callees.push_back(f);
  return index;
}

std::uint32_t FunctionBuilder::add_external(const External& e) {
  const auto place = std::find_if(f_.externals.begin(), f_.externals.end(), [&](const External& o) {
    return o.point == e.point && o.self == e.self && o.components == e.components;
  });
  const auto index = static_cast<std::uint32_t>(place - f_.externals.begin());
  if (place == f_.externals.end()) f_.externals.push_back(e);
  return index;
}

std::vector<Value> FunctionBuilder::emit_call(Op op, std::uint32_t callee, int components,
                                              std::span<const Value> arguments) {
  Key key{op, callee, {}};
  for (const Value& v : arguments) key.operands.push_back(v.index);
  const auto results = static_cast<std::uint16_t>(components);
  const Register first = emit_instruction(std::move(key), results, results);
  std::vector<Value> values;
  for (Register i = 0; i < results; ++i) values.push_back({first + i});
  return values;
}

std::vector<Value> FunctionBuilder::call(const FunctionRef& f, std::span<const Value> arguments) {
  if (arguments.size() != f->parameters) {
    report(BuildProblem::wrong_argument_count);
    return std::vector<Value>(f->results.size(), constant(0));
  }
  if (is_inlinable(*f)) return inlined(*f, arguments);
  f_.depth = std::max(f_.depth, f->depth + 1);
  if (f_.depth > depth_limit) report(BuildProblem::too_deep);
  return emit_call(Op::call, add_callee(f), f->components(), arguments);
}

std::vector<Value> FunctionBuilder::external(const External& e, std::span<const Value> arguments) {
  if (static_cast<int>(arguments.size()) != e.arity) {
    report(BuildProblem::wrong_argument_count);
    return std::vector<Value>(static_cast<std::size_t>(e.components), constant(0));
  }
  return emit_call(Op::external, add_external(e), e.components, arguments);
}

Value FunctionBuilder::internal(int number, std::span<const Value> arguments) {
  if (number < 0 || number >= static_cast<int>(internal_functions.size())) {
    report(BuildProblem::no_such_internal);
    return constant(0);
  }
  const auto index = static_cast<std::uint16_t>(number);
  if (static_cast<int>(arguments.size()) != 3 + internal_functions[index].extra) {
    report(BuildProblem::wrong_argument_count);
    return constant(0);
  }
  Key key{Op::internal, index, {}};
  for (const Value& v : arguments) key.operands.push_back(v.index);
  return {emit_instruction(std::move(key), index, 1)};
}

/// The callee's instructions as they are: its own builder has rewritten them already, and constant
/// arguments must not change how it rounds.
std::vector<Value> FunctionBuilder::inlined(const Function& f, std::span<const Value> arguments) {
  std::vector<Value> values(f.registers);
  std::copy(arguments.begin(), arguments.end(), values.begin());
  for (std::size_t i = 0; i < f.constants.size(); ++i) {
    values[f.parameters + i] = constant(f.constants[i]);
  }
  for (const Instruction& in : f.code) {
    std::vector<Value> operands;
    const auto listed = [&](std::uint32_t n) {
      for (std::uint32_t i = 0; i < n; ++i) operands.push_back(values[f.operands[in.a + i]]);
    };
    std::vector<Value> results;
    if (in.op == Op::internal) {
      listed(3 + static_cast<std::uint32_t>(internal_functions[in.count].extra));
      results = {internal(in.count, operands)};
    } else if (in.op == Op::call) {
      listed(f.callees[in.b]->parameters);
      results = call(f.callees[in.b], operands);
    } else if (in.op == Op::external) {
      listed(static_cast<std::uint32_t>(f.externals[in.b].arity));
      results = external(f.externals[in.b], operands);
    } else {
      const int arity = op_table[static_cast<std::size_t>(in.op)].arity;
      if (arity > 2) {
        listed(static_cast<std::uint32_t>(arity));
      } else {
        operands = {values[in.a]};
        if (arity == 2) operands.push_back(values[in.b]);
      }
      results = {emit(in.op, operands)};
    }
    std::copy(results.begin(), results.end(), values.begin() + in.dst);
  }
  std::vector<Value> results;
  for (const Register r : f.results) results.push_back(group(values[r]));
  return results;
}

Value FunctionBuilder::member(std::span<const Value> components, Member m) {
  const auto slot = [&](std::size_t i) {
    return i < components.size() ? group(components[i]) : group(constant(0));
  };
  const auto times = [&](std::size_t i, double k) {
    return op(Op::multiply, constant(k), slot(i));
  };
  switch (m) {
    case Member::x:
    case Member::u:
    case Member::red: return slot(0);
    case Member::y:
    case Member::v:
    case Member::green: return slot(1);
    case Member::z:
    case Member::blue: return slot(2);
    case Member::t:
    case Member::filter: return slot(3);
    case Member::transmit: return slot(4);
    case Member::gray:
      return group(op(Op::add, op(Op::add, times(0, 0.297), times(1, 0.589)), times(2, 0.114)));
    case Member::hf: {
      const Value low = op(Op::divide, slot(1), constant(255));
      return group(op(Op::multiply, op(Op::add, slot(0), low), constant(0.996093)));
    }
  }
  return slot(0);
}

// ---- select() and loops
// --------------------------------------------------------------------------

Value FunctionBuilder::open_block(Op op, std::uint32_t index) {
  if (blocks_.size() >= depth_limit) report(BuildProblem::too_deep);
  const auto here = static_cast<std::uint32_t>(f_.code.size());
  const Value result{next_++};
  f_.code.push_back({op, 0, result.index, 0, index});
  blocks_.push_back({here, {}, here + 1, trail_.size()});
  return result;
}

void FunctionBuilder::close_side(Value result) {
  OpenBlock& block = blocks_.back();
  const auto end = static_cast<std::uint32_t>(f_.code.size());
  block.sides.push_back({block.side_begin, end, result.index});
  block.side_begin = end;
  while (trail_.size() > block.known) {  // what one side computes, others must not count on
    known_.erase(trail_.back());
    trail_.pop_back();
  }
}

void FunctionBuilder::select_begin(Value condition) {
  const auto index = static_cast<std::uint32_t>(f_.selects.size());
  f_.selects.emplace_back();
  f_.selects.back().condition = condition.index;
  static_cast<void>(open_block(Op::select, index));
}

void FunctionBuilder::select_next(Value side) { close_side(side); }

Value FunctionBuilder::select_end() {
  const OpenBlock block = std::move(blocks_.back());
  blocks_.pop_back();
  assert(block.sides.size() == 2 || block.sides.size() == 3);
  const Instruction in = f_.code[block.instruction];
  Select& s = f_.selects[in.b];
  s.negative = block.sides[0];
  s.zero = block.sides[1];
  s.positive = block.sides.back();
  s.two_way = block.sides.size() == 2;
  if (block.instruction + 1 < f_.code.size()) return {in.dst};

  // No side computes anything: a plain choice does.
  const Select plain = s;
  f_.code.pop_back();
  f_.selects.pop_back();
  return emit(Op::choose, std::array{Value{plain.condition}, Value{plain.negative.result},
                                     Value{plain.zero.result}, Value{plain.positive.result}});
}

Value FunctionBuilder::loop_begin(bool product, Value from, Value to) {
  const auto index = static_cast<std::uint32_t>(f_.loops.size());
  const Value counter{next_++};
  f_.loops.push_back({from.index, to.index, counter.index, {}, product});
  static_cast<void>(open_block(Op::loop, index));
  return counter;
}

Value FunctionBuilder::loop_end(Value body) {
  close_side(body);
  const OpenBlock block = std::move(blocks_.back());
  blocks_.pop_back();
  const Instruction& in = f_.code[block.instruction];
  f_.loops[in.b].body = block.sides[0];
  return {in.dst};
}

void FunctionBuilder::report(BuildProblem p) {
  if (!problem_) problem_ = p;
}

// ---- whole functions
// -----------------------------------------------------------------------------

namespace {

Function whole(int parameters, auto make) {
  FunctionBuilder b(parameters);
  std::vector<Value> arguments;
  for (int i = 0; i < parameters; ++i) arguments.push_back(b.parameter(i));
  const std::vector<Value> results = make(b, arguments);
  return b.finish(results);
}

}  // namespace

Function make_internal_function(int number) {
  const int parameters = 3 + internal_functions[static_cast<std::size_t>(number)].extra;
  return whole(parameters, [&](FunctionBuilder& b, const std::vector<Value>& a) {
    return std::vector{b.internal(number, a)};
  });
}

Function make_external_function(const External& external) {
  return whole(external.arity, [&](FunctionBuilder& b, const std::vector<Value>& a) {
    return b.external(external, a);
  });
}

Function make_transform_function(const Affine& map) {
  return whole(3, [&](FunctionBuilder& b, const std::vector<Value>& p) {
    std::vector<Value> image;
    for (int k = 0; k < 3; ++k) {
      const auto term = [&](std::size_t i, double m) {
        const Value factor = b.constant(m);
        return FunctionBuilder::group(m == 0 ? factor : b.op(Op::multiply, p[i], factor));
      };
      const Value xy = b.op(Op::add, term(0, map.x[k]), term(1, map.y[k]));
      const Value xyz = b.op(Op::add, xy, term(2, map.z[k]));
      image.push_back(b.op(Op::add, xyz, FunctionBuilder::group(b.constant(map.t[k]))));
    }
    return image;
  });
}

Function make_spline_function(std::shared_ptr<const Spline> spline) {
  External e;
  e.name = "spline";
  e.arity = 1;
  e.components = spline->dimension();
  e.self = std::move(spline);
  e.point = [](const void* self, const Context&, const double* t, double* out) {
    const Spline& s = *static_cast<const Spline*>(self);
    const SplineValue v = s.at(*t);
    std::copy_n(v.begin(), s.dimension(), out);
  };
  return make_external_function(e);
}

}  // namespace durer::functions

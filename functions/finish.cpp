// The last step of building: keeps what the results need and numbers registers densely.
#include <algorithm>
#include <cassert>
#include <limits>

#include "functions/builder.h"
#include "functions/operands.h"

namespace durer::functions {
namespace {

constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();

/// Which instructions and registers the results depend on.
struct Needed {
  std::vector<bool> instruction;
  std::vector<bool> reg;
};
Needed needed_by(const Function& f, std::span<const Register> results, Register register_count) {
  std::vector<std::uint32_t> producer(register_count, absent);
  for (std::uint32_t i = 0; i < f.code.size(); ++i) {
    for (std::uint32_t k = 0; k < results_of(f.code[i]); ++k) producer[f.code[i].dst + k] = i;
    if (f.code[i].op == Op::loop) producer[f.loops[f.code[i].b].counter] = i;
  }
  Needed needed{std::vector<bool>(f.code.size()), std::vector<bool>(register_count)};
  std::vector<Register> open(results.begin(), results.end());
  while (!open.empty()) {
    const Register r = open.back();
    open.pop_back();
    if (needed.reg[r]) continue;
    needed.reg[r] = true;
    const std::uint32_t i = producer[r];
    if (i == absent || needed.instruction[i]) continue;
    needed.instruction[i] = true;
    for_operands(f, f.code[i], [&](const Register& operand) { open.push_back(operand); });
  }
  return needed;
}

}  // namespace

Function FunctionBuilder::finish(std::span<const Value> results) {
  assert(blocks_.empty());
  Function f = std::move(f_);
  for (const Value& v : results) f.results.push_back(v.index);
  const Needed needed = needed_by(f, f.results, next_);

  // Registers: parameters, constants, then results in the order of the code.
  std::vector<Register> renumbered(next_, absent);
  Register next = 0;
  while (next < f.parameters) {
    renumbered[next] = next;
    ++next;
  }
  for (const auto& [r, value] : constant_values_) {
    if (!needed.reg[r]) continue;
    renumbered[r] = next++;
    f.constants.push_back(value);
  }
  std::vector<std::uint32_t> place(f.code.size() + 1);
  std::vector<Instruction> kept;
  for (std::size_t i = 0; i < f.code.size(); ++i) {
    place[i] = static_cast<std::uint32_t>(kept.size());
    if (!needed.instruction[i]) continue;
    const Instruction& in = f.code[i];
    kept.push_back(in);
    for (std::uint32_t k = 0; k < results_of(in); ++k) renumbered[in.dst + k] = next++;
    if (in.op == Op::loop) renumbered[f.loops[in.b].counter] = next++;
  }
  place.back() = static_cast<std::uint32_t>(kept.size());
  f.code = std::move(kept);
  f.registers = next;

  const auto moved = [&](Branch& b) {
    b.begin = place[b.begin];
    b.end = place[b.end];
  };
  for (Instruction& in : f.code) {
    for_operands(f, in, [&](Register& r) { r = renumbered[r]; });
    in.dst = renumbered[in.dst];
    if (in.op == Op::loop) {
      Loop& l = f.loops[in.b];
      l.counter = renumbered[l.counter];
      moved(l.body);
    } else if (in.op == Op::select) {
      Select& s = f.selects[in.b];
      for (Branch* side : {&s.negative, &s.zero, &s.positive}) moved(*side);
    }
  }
  for (Register& r : f.results) r = renumbered[r];
  return f;
}

}  // namespace durer::functions

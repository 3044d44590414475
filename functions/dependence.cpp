#include "functions/dependence.h"

#include <algorithm>

#include "functions/operands.h"

namespace durer::functions {
namespace {

/// `waves` without the pairs of angles before the first, and behind the last, of which one changes.
/// Whole pairs, because the sine of an angle may depend on its partner: by its last bit, where one of
/// them is too large to be taken together with another.
Instruction trimmed(const Function& f, Instruction waves, const std::vector<bool>& changes) {
  const std::uint32_t angles = waves.count / 2U;
  const auto pair_changes = [&](std::uint32_t first) {
    return changes[f.operands[waves.a + first]] ||
           (first + 1 < angles && changes[f.operands[waves.a + first + 1]]);
  };
  std::uint32_t begin = 0;
  while (!pair_changes(begin)) begin += 2;
  std::uint32_t end = (angles + 1) / 2 * 2;
  while (!pair_changes(end - 2)) end -= 2;
  waves.count = static_cast<std::uint16_t>(2 * (std::min(end, angles) - begin));
  waves.a += begin;
  waves.dst += 2 * begin;
  return waves;
}

}  // namespace

Function depending_on(const Function& f, unsigned changed) {
  Function part = f;
  const auto branches = [](const Instruction& in) {
    return in.op == Op::select || in.op == Op::loop;
  };
  if (std::any_of(f.code.begin(), f.code.end(), branches)) return part;
  std::vector<bool> changes(f.registers);
  for (Register r = 0; r < f.parameters; ++r) changes[r] = (changed >> r & 1U) != 0;
  part.code.clear();
  for (const Instruction& in : f.code) {
    bool depends = false;
    for_operands(f, in, [&](const Register& r) { depends = depends || changes[r]; });
    if (!depends) continue;
    const Instruction kept = in.op == Op::waves ? trimmed(f, in, changes) : in;
    part.code.push_back(kept);
    for (std::uint32_t i = 0; i < results_of(kept); ++i) changes[kept.dst + i] = true;
  }
  return part;
}

Function with_single_waves(const Function& f) {
  Function single = f;
  single.code.clear();
  for (const Instruction& in : f.code) {
    if (in.op != Op::waves) {
      single.code.push_back(in);
      continue;
    }
    for (std::uint32_t i = 0; i < in.count / 2U; ++i) {
      single.code.push_back({Op::waves, 2, in.dst + 2 * i, in.a + i, 0});
    }
  }
  return single;
}

Function moved(Function part, unsigned changed, Register distance) {
  std::vector<bool> moves(part.registers);
  for (Register r = 0; r < part.parameters; ++r) moves[r] = (changed >> r & 1U) != 0;
  for (const Instruction& in : part.code) {
    for (std::uint32_t i = 0; i < results_of(in); ++i) moves[in.dst + i] = true;
    if (in.op == Op::loop) moves[part.loops[in.b].counter] = true;
  }
  const auto move = [&](Register& r) {
    if (moves[r]) r += distance;
  };
  for (Instruction& in : part.code) {
    for_operands(part, in, move);
    in.dst += distance;
    if (in.op == Op::loop) move(part.loops[in.b].counter);
  }
  for (Register& r : part.results) move(r);
  part.registers += distance;
  return part;
}

}  // namespace durer::functions

#include "functions/dependence.h"

#include <algorithm>

#include "functions/operands.h"

namespace durer::functions {
namespace {

/// The waves of those angles of `in` that change, one by one.
void add_changing_waves(const Function& f, const Instruction& in, std::vector<bool>& changes,
                        Function& part) {
  for (std::uint32_t i = 0; i < in.count / 2U; ++i) {
    if (!changes[f.operands[in.a + i]]) continue;
    part.code.push_back({Op::waves, 2, in.dst + 2 * i, in.a + i, 0});
    changes[in.dst + 2 * i] = true;
    changes[in.dst + 2 * i + 1] = true;
  }
}

/// The instructions to which registers lead that change.
Function changing(const Function& f, std::vector<bool> changes) {
  Function part = f;
  const auto branches = [](const Instruction& in) {
    return in.op == Op::select || in.op == Op::loop;
  };
  if (std::any_of(f.code.begin(), f.code.end(), branches)) return part;
  part.code.clear();
  for (const Instruction& in : f.code) {
    bool depends = false;
    for_operands(f, in, [&](const Register& r) { depends = depends || changes[r]; });
    if (!depends) continue;
    if (in.op == Op::waves) {
      add_changing_waves(f, in, changes, part);
      continue;
    }
    part.code.push_back(in);
    for (std::uint32_t i = 0; i < results_of(in); ++i) changes[in.dst + i] = true;
  }
  return part;
}

}  // namespace

Function depending_on(const Function& f, unsigned changed) {
  std::vector<bool> changes(f.registers);
  for (Register r = 0; r < f.parameters; ++r) changes[r] = (changed >> r & 1U) != 0;
  return changing(f, std::move(changes));
}

Function with_single_waves(const Function& f) {
  return changing(f, std::vector<bool>(f.registers, true));
}

}  // namespace durer::functions

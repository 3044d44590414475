#include "functions/dependence.h"

#include <algorithm>

#include "functions/operands.h"

namespace durer::functions {

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
    part.code.push_back(in);
    for (std::uint32_t i = 0; i < results_of(in); ++i) changes[in.dst + i] = true;
  }
  return part;
}

}  // namespace durer::functions

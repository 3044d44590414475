// What the instructions of a tape read and write. Private to this folder.
#pragma once

#include <type_traits>

#include "functions/internals.h"
#include "functions/tape.h"

namespace durer::functions {

/// How many registers an instruction writes.
[[nodiscard]] inline std::uint32_t results_of(const Instruction& in) {
  return in.op == Op::call || in.op == Op::external || in.op == Op::waves ? in.count : 1;
}

/// Calls `use` with a reference to every register an instruction reads.
template <class F, class Use>
void for_operands(F& f, std::conditional_t<std::is_const_v<F>, const Instruction, Instruction>& in,
                  Use use) {
  const auto listed = [&](std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) use(f.operands[in.a + i]);
  };
  switch (in.op) {
    case Op::internal:
      listed(3 + static_cast<std::size_t>(internal_functions[in.count].extra));
      break;
    case Op::call: listed(f.callees[in.b]->parameters); break;
    case Op::external: listed(static_cast<std::size_t>(f.externals[in.b].arity)); break;
    case Op::select: {
      auto& s = f.selects[in.b];
      use(s.condition);
      for (auto* side : {&s.negative, &s.zero, &s.positive}) use(side->result);
      break;
    }
    case Op::loop: {
      auto& l = f.loops[in.b];
      use(l.from);
      use(l.to);
      use(l.body.result);
      break;
    }
    case Op::waves: listed(in.count / 2U); break;
    default: {
      const int arity = op_table[static_cast<std::size_t>(in.op)].arity;
      if (arity > 2) {
        listed(static_cast<std::size_t>(arity));
      } else {
        use(in.a);
        if (arity == 2) use(in.b);
      }
    }
  }
}

}  // namespace durer::functions

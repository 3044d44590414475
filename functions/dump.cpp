#include <fmt/format.h>

#include <iterator>

#include "functions/internals.h"
#include "functions/tape.h"

namespace durer::functions {
namespace {

std::string listed(const Function& f, std::uint32_t first, std::size_t n) {
  std::string text;
  for (std::size_t i = 0; i < n; ++i) text += fmt::format(" r{}", f.operands[first + i]);
  return text;
}
std::string side(const Branch& b) { return fmt::format(" [{}, {}) r{}", b.begin, b.end, b.result); }

std::string what(const Function& f, const Instruction& in) {
  switch (in.op) {
    case Op::internal: {
      const InternalInfo& info = internal_functions[in.count];
      return std::string(info.name) + listed(f, in.a, 3 + static_cast<std::size_t>(info.extra));
    }
    case Op::call:
      return fmt::format("call {}", in.b) + listed(f, in.a, f.callees[in.b]->parameters);
    case Op::external:
      return f.externals[in.b].name +
             listed(f, in.a, static_cast<std::size_t>(f.externals[in.b].arity));
    case Op::select: {
      const Select& s = f.selects[in.b];
      return fmt::format("select r{}", s.condition) + side(s.negative) + side(s.zero) +
             (s.two_way ? "" : side(s.positive));
    }
    case Op::loop: {
      const Loop& l = f.loops[in.b];
      return fmt::format("{} r{} from r{} to r{}", l.product ? "prod" : "sum", l.counter, l.from,
                         l.to) +
             side(l.body);
    }
    case Op::waves: return "waves" + listed(f, in.a, in.count / 2U);
    default: break;
  }
  const OpInfo& info = op_table[static_cast<std::size_t>(in.op)];
  if (info.arity > 2) return info.name + listed(f, in.a, static_cast<std::size_t>(info.arity));
  return info.arity == 2 ? fmt::format("{} r{} r{}", info.name, in.a, in.b)
                         : fmt::format("{} r{}", info.name, in.a);
}

}  // namespace

std::string dump(const Function& f) {
  std::string text = fmt::format("parameters {}\n", f.parameters);
  for (std::size_t i = 0; i < f.constants.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "r{} = {}\n", f.parameters + i, f.constants[i]);
  }
  for (std::size_t i = 0; i < f.code.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{}: r{} = {}\n", i, f.code[i].dst,
                   what(f, f.code[i]));
  }
  text += "result";
  for (const Register r : f.results) text += fmt::format(" r{}", r);
  return text + "\n";
}

}  // namespace durer::functions

// --trace-macros: a line for every macro call and return.
#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {
namespace {

constexpr std::size_t longest_text = 24;

std::string shortened(const Value& value) {
  if (const Num* n = value.get<Num>()) {
    if (n->length == 1) return fmt::format("{:g}", n->v[0]);
    std::string s;
    for (int i = 0; i < n->length; ++i) {
      s += fmt::format("{}{:g}", i == 0 ? "<" : ",", n->v[static_cast<std::size_t>(i)]);
    }
    return s + ">";
  }
  if (const auto* text = value.get<Shared<Text>>()) {
    std::string s = (*text)->bytes();
    for (char& c : s) c = c == '\n' || c == '\t' || c == '\r' ? ' ' : c;
    if (s.size() > longest_text) s = s.substr(0, longest_text) + "…";
    return '"' + s + '"';
  }
  if (const auto* array = value.get<std::shared_ptr<Array>>()) {
    std::string s = "array";
    for (const std::size_t size : (*array)->sizes) s += fmt::format("[{}]", size);
    return s;
  }
  const std::string_view kind = kind_name(value);
  return std::string(kind.starts_with("a ")    ? kind.substr(2)
                     : kind.starts_with("an ") ? kind.substr(3)
                                               : kind);
}

}  // namespace

/// `Knob(0.5, <1,2,3>) at desk.pov:88`, indented by the depth of the call.
void Interpreter::trace_call(const Frame& frame, const ast::Tree& tree, const ast::Macro& macro) {
  std::string line = fmt::format("{:{}}{} {}(", "", 2 * (macro_depth_ - 1), macro_depth_,
                                 name_of(macro.name));
  for (std::uint32_t i = 0; i < macro.params.count; ++i) {
    const Value* v = Environment::value_of(env_.find(tree.params[macro.params.first + i].name));
    line += fmt::format("{}{}", i == 0 ? "" : ", ", v == nullptr ? "nothing" : shortened(*v));
  }
  const durer::Place place = sources_.place(frame.call.begin);
  options_.on_trace(fmt::format("{}) at {}:{}", line, place.path, place.line));
}

void Interpreter::trace_return(const Frame& frame) {
  options_.on_trace(fmt::format("{:{}}{} end of {}", "", 2 * (macro_depth_ - 1), macro_depth_,
                                name_of(frame.name)));
}

}  // namespace durer::interpreter

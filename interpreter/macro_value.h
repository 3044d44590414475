// The value of a macro call, worked out where it stands.
#pragma once

#include "interpreter/interpreter.h"

namespace durer::interpreter {

/// Runs the statements of the body, then reads its value while its scope is still open. `read`
/// takes the tree and the expression at the end of the body.
template <typename Read>
auto Interpreter::macro_value(const ast::Tree& tree, ast::ExprId id, const MacroRef& ref,
                              Read read) {
  const ast::Tree& body_tree = *ref.tree;
  const ast::Body body = ref.macro->items;
  struct Leave {
    Interpreter& in;
    std::size_t depth;
    ~Leave() {
      while (in.frames_.size() > depth) in.pop();
    }
  } const leave{*this, frames_.size()};
  enter_macro(tree, id, MacroRef(ref), {body.first + body.count, 0}, false);
  if (run_statements(body_tree, {body.first, body.count - 1}) == Flow::broken) {
    fail(Code::evaluation, tree.exprs[id].span, "this macro was left by `#break` without a value");
  }
  return read(body_tree, body_tree.items[body.first + body.count - 1].ref);
}

}  // namespace durer::interpreter

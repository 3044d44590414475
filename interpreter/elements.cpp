// Elements of arrays by their subscripts (language §5.1).
#include <cmath>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

Interpreter::Subscript Interpreter::read_subscript(const ast::Tree& tree, ast::ExprId id) {
  const Num subscript = evaluate(tree, id, 1);
  if (subscript.length != 1) {
    fail(Code::wrong_kind, tree.exprs[id].span,
         fmt::format("expected a float as subscript, found {}", kind_name(subscript)));
  }
  return {subscript.v[0], tree.exprs[id].span};
}

Interpreter::Subscripts Interpreter::read_subscripts(const ast::Tree& tree, ast::Range list) {
  Subscripts out;
  for (std::uint32_t i = 0; i < list.count; ++i) {
    const ast::ExprId id = tree.expr_lists[list.first + i];
    if (!out.add(read_subscript(tree, id))) {
      fail(Code::limit, tree.exprs[id].span, "an array access has at most 20 subscripts");
    }
  }
  return out;
}

Interpreter::Subscripts Interpreter::read_subscripts(const ast::Tree& tree, ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  if (const auto* index = std::get_if<ast::Index>(&e.node))
    return read_subscripts(tree, index->subscripts);
  // Made by directives: one bracketed part per subscript.
  Subscripts out;
  const Nested part(*this, tree, std::get<ast::OpenGroup>(e.node).items);
  while (peek().kind == Token::Kind::bracket_open) {
    const Span span = next().span;
    if (!out.add({read_scalar("subscript"), span})) {
      fail(Code::limit, span, "an array access has at most 20 subscripts");
    }
    const Token close = next();
    if (close.kind != Token::Kind::bracket_close) unexpected(close, "`]`");
  }
  return out;
}

/// Where the subscripts from number `used` on lead in `array`, row-major.
std::size_t Interpreter::flat_index(const Subscripts& list, const Array& array, Span span,
                                    std::size_t& used) {
  std::size_t flat = 0;
  for (const std::size_t size : array.sizes) {
    if (used >= list.size()) {
      fail(Code::missing_argument, span,
           fmt::format("this array has {} dimensions, here are {} subscripts", array.sizes.size(),
                       list.size()));
    }
    const Subscript& s = list[used++];
    const double v = std::floor(s.value + epsilon);
    if (!(v >= 0 && v < static_cast<double>(size))) {
      fail(Code::out_of_range, s.span,
           fmt::format("subscript {:g} is outside the array, which has {} elements here", v, size),
           fmt::format("subscripts go from 0 to {}", size - 1));
    }
    flat = flat * size + static_cast<std::size_t>(v);
  }
  return flat;
}

Value* Interpreter::element(SymbolId name, const Subscripts& list, Span span, bool for_writing,
                            bool must_exist) {
  Value* v = Environment::value_of(env_.find(name));
  if (v == nullptr) unknown_name(name, span);
  for (std::size_t used = 0; used < list.size();) {
    auto* array = v->get<std::shared_ptr<Array>>();
    if (array == nullptr) {
      fail(Code::wrong_kind, span,
           fmt::format("`{}` is {}, it takes no more subscripts", name_of(name), kind_name(*v)));
    }
    if (for_writing) own_array(*v);
    if (for_writing && (*array)->grows) grow(**array, list[used].value, list[used].span);
    v = &(*array)->elements[flat_index(list, **array, span, used)];
  }
  if (must_exist && !v->defined()) {
    fail(Code::evaluation, span, "this array element has no value yet");
  }
  return v;
}

}  // namespace durer::interpreter

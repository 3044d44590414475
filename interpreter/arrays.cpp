// Arrays as they are written: sizes and elements (language §5.1).
#include <cmath>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace a = grammar::additions;

namespace {
constexpr double most_elements = 1e8;
}

/// Makes room for the element that is to be assigned.
void Interpreter::grow(Array& array, double subscript, Span span) {
  const double at = std::floor(subscript + epsilon);
  if (!(at >= static_cast<double>(array.elements.size()))) return;
  if (at >= most_elements) {
    fail(Code::limit, span, "this array is too large", "arrays hold up to 100 million elements");
  }
  array.elements.resize(static_cast<std::size_t>(at) + 1);
  array.sizes[0] = array.elements.size();
}

/// One more size; `total` counts the elements.
void Interpreter::add_size(Array& array, double written, std::size_t& total, Span span) {
  const double v = std::floor(written + epsilon);
  if (!(v >= 1))
    fail(Code::out_of_range, span, fmt::format("an array cannot have {:g} elements", v));
  if (v * static_cast<double>(total) > most_elements) {
    fail(Code::limit, span, "this array is too large", "arrays hold up to 100 million elements");
  }
  array.sizes.push_back(static_cast<std::size_t>(v));
  total *= static_cast<std::size_t>(v);
}

/// Elements between braces; `lenient`: some may be left out.
void Interpreter::read_array_level(Array& array, std::size_t level, std::size_t first, bool lenient,
                                   Span span) {
  expect_open("array");
  const std::size_t size = array.sizes[level];
  std::size_t inner = 1;  // elements per step of this level
  for (std::size_t i = level + 1; i < array.sizes.size(); ++i) inner *= array.sizes[i];
  for (std::size_t i = 0; array.grows || i < size; ++i) {
    const Token& t = peek();
    if (t.kind == Token::Kind::close) {
      if (lenient || array.grows) break;
      fail(Code::missing_argument, t.span,
           fmt::format("this array needs {} elements, here are {}", size, i));
    }
    if (lenient && t.is_punct(',')) {
      next();
      continue;
    }
    const Span at = t.span;
    if (array.grows) grow(array, static_cast<double>(i), at);
    if (level + 1 < array.sizes.size()) {
      read_array_level(array, level + 1, first + i * inner, lenient, span);
    } else {
      Value value = read_value();
      store(array.elements[first + i], std::move(value), true, &array, at);
    }
    optional_comma();
  }
  const Token t = next();
  if (t.kind != Token::Kind::close) {
    fail(Code::unexpected_item, t.span,
         fmt::format("this array takes {} elements, here are more", size));
  }
}

/// After the word `array`: sizes and, maybe, elements. Since 3.8 `mixed` may stand before the sizes
/// and `optional` before the elements, and an array without size grows.
std::shared_ptr<Array> Interpreter::read_array(Span span) {
  auto array = std::make_shared<Array>();
  std::size_t total = 1;
  bool brackets = false;
  const auto is_name = [&](const Token& t, SymbolId name) {
    const auto* n = t.node<ast::Name>();
    return additions_ && n != nullptr && n->name == name;
  };
  if (is_name(raw_next(), a::mixed)) {
    next();
    array->mixed = true;
  } else if (const auto* index = raw_next().node<ast::Index>();
             additions_ && index != nullptr && index->name == a::mixed) {
    const Token t = next();
    array->mixed = brackets = true;
    for (std::uint32_t i = 0; i < index->subscripts.count; ++i) {
      const ast::ExprId id = t.tree->expr_lists[index->subscripts.first + i];
      add_size(*array, read_subscript(*t.tree, id).value, total, span);
    }
  }
  // Elements follow immediately or not at all, so it is safe to look at what is written next.
  while (raw_next().kind == Token::Kind::bracket_open) {
    next();
    if (additions_ && !brackets && raw_next().kind == Token::Kind::bracket_close) {
      next();
      break;  // `array[]` is `array`
    }
    brackets = true;
    add_size(*array, read_scalar("size of an array"), total, span);
    const Token close = next();
    if (close.kind != Token::Kind::bracket_close) unexpected(close, "`]` after the size");
  }
  if (array->sizes.size() > 5) fail(Code::out_of_range, span, "an array has at most 5 dimensions");
  if (array->sizes.empty()) {
    if (version() < 380)
      fail(Code::missing_argument, span, "expected `[` and a size after `array`");
    array->grows = true;
    array->sizes = {0};
    total = 0;
  }
  array->elements.resize(total);
  const bool lenient = is_name(raw_next(), a::optional);
  if (lenient) next();
  if (raw_next().kind == Token::Kind::open) read_array_level(*array, 0, 0, lenient, span);
  return array;
}

}  // namespace durer::interpreter

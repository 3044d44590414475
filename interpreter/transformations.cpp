// `translate`, `rotate`, `scale`, `matrix`, `transform` (objects §6).
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// `translate`, `rotate` or `scale` by a vector.
Transform Interpreter::transformation(SymbolId word, dvec3 by, Span span) {
  if (word == w::translate) return Transform::translate(by);
  if (word == w::rotate) return Transform::rotate_deg(by);
  for (int i = 0; i < 3; ++i) {
    if (by[i] != 0) continue;
    warn(Code::degenerate, span,
         fmt::format("`scale` with {} = 0; 1 is used instead", "xyz"[i]));
    by[i] = 1;
  }
  return Transform::scale(by);
}

/// The transformation that starts with `t`, or nothing if it starts none.
std::optional<Transform> Interpreter::read_transformation(const Token& t) {
  if (t.kind != Token::Kind::word) return std::nullopt;
  switch (t.word) {
    case w::translate:
    case w::rotate:
    case w::scale: return transformation(t.word, read_vector(), t.span);
    case w::matrix: return read_matrix(t);
    case w::transform: return read_transform_block();
    default: return std::nullopt;
  }
}

Transform Interpreter::read_matrix(const Token& word) {
  std::array<double, 12> m{};
  const std::size_t n = read_numbers(m);
  if (n != 12) {
    fail(Code::missing_argument, word.span,
         fmt::format("`matrix` takes 12 numbers in `< >`, here are {}", n));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(m[i]) < epsilon && std::abs(m[i + 3]) < epsilon && std::abs(m[i + 6]) < epsilon) {
      warn(Code::degenerate, word.span,
           fmt::format("column {} of the matrix is zero; its diagonal element becomes 1", i));
      m[4 * i] = 1;
    }
  }
  const auto matrix = Transform::matrix(m);
  if (!matrix)
    fail(Code::degenerate, word.span, "this matrix is singular",
         "its three rows must not lie in one plane");
  return *matrix;
}

/// After the word `transform`: `{ … }` or a bare identifier.
Transform Interpreter::read_transform_block() {
  const auto identifier = [&](const Token& t) -> std::optional<Transform> {
    if (t.kind != Token::Kind::expr) return std::nullopt;
    const Value* v = lookup(*t.tree, t.expr, true);
    if (v == nullptr) return std::nullopt;
    const auto* ref = v->get<Shared<Transform>>();
    if (ref == nullptr) {
      fail(Code::wrong_kind, t.span, fmt::format("expected a transform, found {}", kind_name(*v)));
    }
    return **ref;
  };
  const Token first = next();
  if (first.kind != Token::Kind::open) {
    if (const auto t = identifier(first)) return *t;
    unexpected(first, "`{` or a transform after `transform`");
  }
  Transform sum;
  bool inverted = false;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.is(w::inverse)) {
      inverted = true;
    } else if (const auto step = read_transformation(t)) {
      sum = sum.then(*step);
    } else if (const auto named = identifier(t)) {
      sum = sum.then(*named);
    } else {
      unexpected(t, "a transformation");
    }
  }
  return inverted ? sum.inverse() : sum;
}

}  // namespace durer::interpreter

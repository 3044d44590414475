// Splines: how they are written and called (language §5.2).
#include <fmt/format.h>

#include "functions/spline.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;
using functions::Spline;
using functions::SplineKind;

namespace {
std::optional<SplineKind> kind_of(const Token& t) {
  if (t.is(w::linear_spline)) return SplineKind::linear;
  if (t.is(w::quadratic_spline)) return SplineKind::quadratic;
  if (t.is(w::cubic_spline)) return SplineKind::cubic;
  if (t.is(w::natural_spline)) return SplineKind::natural;
  return std::nullopt;
}
}  // namespace

/// After the word `spline`: `{ [spline] [kind] key, value, … }`.
std::shared_ptr<const Spline> Interpreter::read_spline(Span span) {
  expect_open("spline");
  std::vector<Spline::Entry> entries;
  int dimension = 2;
  SplineKind kind = SplineKind::linear;
  if (const Token t = peek(); t.is_place()) {
    const Value* v = lookup(*t.tree, t.expr, false);
    if (const auto* copied = v == nullptr ? nullptr : v->get<Shared<Spline>>()) {
      entries = (*copied)->entries();
      dimension = (*copied)->dimension();
      kind = (*copied)->kind();
      next();
    }
  }
  while (const auto written = kind_of(peek())) {
    kind = *written;
    next();
  }
  optional_comma();
  functions::SplineValue components{};
  while (peek().kind != Token::Kind::close) {
    if (accept_punct(';')) continue;
    Spline::Entry entry;
    entry.key = read_scalar("key");
    optional_comma();
    const Num value = read_full(2);
    // Components that an entry does not have are those of the one before it, as it was written.
    std::copy_n(value.v.begin(), value.length, components.begin());
    entry.value = components;
    dimension = std::max(dimension, value.length);
    entries.push_back(entry);
    optional_comma();
  }
  next();
  if (entries.empty()) {
    fail(Code::missing_argument, span, "a spline needs at least one entry",
         "write keys and values: `spline { linear_spline 0, <0,0,0> 1, <1,2,0> }`");
  }
  return std::make_shared<const Spline>(kind, dimension, entries);
}

/// `S(key)` or `S(key, kind)`.
Num Interpreter::call_spline(const Spline& spline, const ast::Tree& tree, const ast::Expr& e) {
  double key = 0;
  SplineKind kind = spline.kind();
  if (const auto* call = std::get_if<ast::Call>(&e.node)) {
    const std::size_t given = read_arguments(tree, e, {&key, 1});
    if (given != 1 || call->args.count > 1) {
      fail(Code::missing_argument, e.span, "a spline is called with one key",
           "and maybe with another kind: `S(0.5, linear_spline)`");
    }
  } else {
    Nested part(*this, tree, std::get<ast::OpenGroup>(e.node).items);
    key = read_scalar("key");
    if (accept_punct(',')) {
      const Token t = next();
      const auto written = kind_of(t);
      if (!written) {
        unexpected(t, "linear_spline, quadratic_spline, cubic_spline or natural_spline");
      }
      kind = *written;
    }
    part.finish("`)`");
  }
  Num n;
  n.v = spline.at(key, kind);
  n.length = spline.dimension();
  return n;
}

}  // namespace durer::interpreter

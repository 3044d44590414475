// Polynomial surfaces: `poly`, `cubic`, `quartic`, `polynomial` (objects §12.3).
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// `poly { n, <…> }`, `cubic { <…> }`, `quartic { <…> }` and `polynomial { n, xyz(i,j,k): c, … }`
/// (objects §12.3).
scene::Object Interpreter::read_polynomial(std::uint32_t type, const Token& word) {
  scene::Object o = primitive(type, word);
  double degree = word.word == w::cubic ? 3 : 4;
  if (word.word == w::poly || word.word == w::polynomial) {
    degree = std::trunc(read_scalar("the degree"));
    optional_comma();
  }
  if (!(degree >= 2 && degree <= 35)) {
    fail(Code::out_of_range, word.span, "the degree of a polynomial surface is 2 to 35");
  }
  const auto n = static_cast<std::size_t>(degree);
  std::vector<double> terms((n + 1) * (n + 2) * (n + 3) / 6);
  if (word.word == w::polynomial) {
    while (accept(w::xyz)) {
      std::array<std::size_t, 3> power{};
      read_exponents(power, word.span);
      if (power[0] + power[1] + power[2] > n) {
        fail(Code::out_of_range, last_span_,
             fmt::format("these exponents add up to more than {}", n));
      }
      const Token colon = next();
      if (!colon.is_punct(':')) unexpected(colon, "`:` and a factor");
      const std::size_t a = n - power[0];
      const std::size_t b = a - power[1];
      terms[(a + 2) * (a + 1) * a / 6 + (b + 1) * b / 2 + (b - power[2])] = read_scalar("factor");
      optional_comma();
    }
  } else {
    const std::size_t found = read_numbers(terms);
    if (found != terms.size()) {
      fail(Code::missing_argument, word.span,
           fmt::format("a surface of degree {} takes {} numbers in `< >`, here are {}", n,
                       terms.size(), found));
    }
  }
  terms.insert(terms.begin(), degree);
  o.args = terms;
  return o;
}

/// `(i, j, k)` after `xyz`.
void Interpreter::read_exponents(std::array<std::size_t, 3>& power, Span span) {
  const Token t = next();
  last_span_ = t.span;
  const auto* g = t.node<ast::OpenGroup>();
  if (g == nullptr || g->kind != ast::OpenGroup::Kind::paren)
    unexpected(t, "`(` and three exponents");
  const Nested part(*this, *t.tree, g->items);
  for (std::size_t& p : power) {
    const double v = read_scalar("exponent");
    if (!(v >= 0 && v <= 35)) fail(Code::out_of_range, span, "exponents are 0 to 35");
    p = static_cast<std::size_t>(v);
    optional_comma();
  }
}

}  // namespace durer::interpreter

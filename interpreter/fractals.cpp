// `julia_fractal` (objects §10.12).
#include <array>
#include <cmath>

#include "interpreter/object_reader.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

/// In the order of tracer::JuliaFunction.
constexpr std::array functions = {w::sqr,  w::cube,  w::exp,  w::reciprocal, w::sin,  w::asin,
                                  w::sinh, w::asinh, w::cos,  w::acos,       w::cosh, w::acosh,
                                  w::tan,  w::atan,  w::tanh, w::atanh,      w::ln,   w::pwr};

}  // namespace

/// One expression of `width` components, behind the words that are read already.
void ObjectReader::put_vector(std::size_t at, int width) {
  in_.last_span_ = in_.peek().span;
  const Num v = in_.fit(in_.read_num(width), width);
  std::copy_n(v.v.begin(), width, args_.begin() + static_cast<std::ptrdiff_t>(at));
}

void ObjectReader::julia_fractal() {
  // Parameter, kind, function, power, iterations, precision, slice and its distance.
  args_.assign({0, 0, 0, 0, 0, 0, 0, 0, 20, 20, 0, 0, 0, 1, 0});
  put_vector(0, 4);
  for (;;) {
    if (accept(w::quaternion)) {
      args_[4] = 0;
    } else if (accept(w::hypercomplex)) {
      args_[4] = 1;
    } else if (accept(w::max_iteration)) {
      args_[8] = std::floor(in_.read_scalar("number of iterations"));
    } else if (accept(w::precision)) {
      args_[9] = in_.read_scalar("the precision");
    } else if (accept(w::slice)) {
      put_vector(10, 4);
      in_.optional_comma();
      args_[14] = in_.read_scalar("the distance of the slice");
    } else if (!julia_function()) {
      return;
    }
  }
}

bool ObjectReader::julia_function() {
  // Words such as `sin` are names of functions everywhere else, and come as names.
  const Token t = in_.peek();
  const auto* name = t.node<ast::Name>();
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (!t.is(functions[i]) && (name == nullptr || name->name != functions[i])) continue;
    in_.next();
    args_[5] = static_cast<double>(i);
    if (functions[i] == w::pwr) read_power();
    return true;
  }
  return false;
}

/// `(re, im)` after `pwr`.
void ObjectReader::read_power() {
  const Token t = in_.next();
  const auto* g = t.node<ast::OpenGroup>();
  if (g == nullptr || g->kind != ast::OpenGroup::Kind::paren) {
    in_.unexpected(t, "`(` and the real and imaginary part of the exponent");
  }
  const Interpreter::Nested part(in_, *t.tree, g->items);
  args_[6] = number("real part");
  args_[7] = number("imaginary part");
}

}  // namespace durer::interpreter

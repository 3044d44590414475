// Prisms and other objects that are words and a list of points (objects §10, §11).
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/object_reader.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// Objects that their operand table does not describe; nothing for the others.
std::optional<scene::Object> Interpreter::read_listed(std::uint32_t type, const Token& word) {
  scene::Object o;
  o.kind = scene::NodeKind::primitive;
  o.type = type;
  o.origin = origin(word.span);
  ObjectReader reader(*this, o, word);
  switch (word.word) {
    case w::blob: reader.blob(); break;
    case w::lathe: reader.lathe(); break;
    case w::prism: reader.prism(); break;
    case w::sor: reader.sor(); break;
    default: return std::nullopt;
  }
  check_operands(*registry_.primitives[type], o.args, word);
  return o;
}

/// A number and the comma that may follow it.
double ObjectReader::number(const char* what) {
  const double x = in_.read_scalar(what);
  in_.optional_comma();
  return x;
}

/// `linear_spline` and its like, as their place among tracer::Spline.
bool ObjectReader::spline_word(double& kind) {
  constexpr std::array words = {w::linear_spline, w::quadratic_spline, w::cubic_spline,
                                w::bezier_spline};
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!accept(words[i])) continue;
    kind = static_cast<double>(i);
    return true;
  }
  return false;
}

/// `count` vectors of `width` components. Memory grows with what is there, not with the count.
void ObjectReader::points(double count, int width) {
  count = std::trunc(count);
  if (!(count >= 0 && count <= 1e9)) {
    in_.fail(Code::out_of_range, word_.span, fmt::format("there is no list of {} points", count));
  }
  for (double i = 0; i < count; ++i) {
    if (i > 0) in_.optional_comma();
    const Token t = in_.peek();
    if (t.kind != Token::Kind::expr && t.kind != Token::Kind::punct) {
      Diagnostic d;
      d.code = Code::missing_argument;
      d.span = t.span;
      d.message = fmt::format("expected {} points, here are {}", count, i);
      d.labels.push_back({word_.span, "in this block"});
      in_.fail(std::move(d));
    }
    in_.last_span_ = t.span;
    const Num v = in_.fit(in_.read_num(width), width);
    args_.insert(args_.end(), v.v.begin(), v.v.begin() + width);
  }
}

/// One vector of three components and the comma that may follow it.
void ObjectReader::vector() {
  in_.last_span_ = in_.peek().span;
  const dvec3 v = in_.read_vector();
  args_.insert(args_.end(), {v.x, v.y, v.z});
  in_.optional_comma();
}

/// `prism { [spline] [sweep] h1, h2, n, <x,z> … [open] }` (objects §10.8).
void ObjectReader::prism() {
  args_.assign(5, 0.0);
  for (;;) {
    if (spline_word(args_[0])) continue;
    if (accept(w::linear_sweep)) {
      args_[1] = 0;
    } else if (accept(w::conic_sweep)) {
      args_[1] = 1;
    } else {
      break;
    }
  }
  args_[2] = number("a height");
  args_[3] = number("a height");
  points(number("the number of points"), 2);
  if (accept(w::open)) args_[4] = 1;
}

/// `lathe { [spline] n, <r,y> … }` (objects §10.7).
void ObjectReader::lathe() {
  args_.assign(1, 0.0);
  spline_word(args_[0]);
  points(number("the number of points"), 2);
}

/// `sor { n, <r,y> … [open] }` (objects §10.9).
void ObjectReader::sor() {
  args_.assign(1, 0.0);
  points(number("the number of points"), 2);
  if (accept(w::open)) args_[0] = 1;
}

}  // namespace durer::interpreter

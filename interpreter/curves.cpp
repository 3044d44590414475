// Prisms and other objects that are words and a list of points (objects §10, §11).
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/object_reader.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// Objects that their operand table does not describe; nothing for the others.
scene::Object Interpreter::read_listed(std::uint32_t type, const Token& word) {
  scene::Object o = primitive(type, word);
  ObjectReader reader(*this, o, word);
  switch (word.word) {
    case w::bicubic_patch: reader.bicubic_patch(); break;
    case w::blob: reader.blob(); break;
    case w::height_field: reader.height_field(); break;
    case w::julia_fractal: reader.julia_fractal(); break;
    case w::lathe: reader.lathe(); break;
    case w::polygon: reader.polygon(); break;
    case w::prism: reader.prism(); break;
    case w::sor: reader.sor(); break;
    default: reader.sphere_sweep(); break;
  }
  reader.finish();
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

/// `sphere_sweep { spline n, <x,y,z>, r … [tolerance T] }` (objects §10.10).
void ObjectReader::sphere_sweep() {
  args_.assign(2, 0.0);
  if (accept(w::cubic_spline)) {
    args_[0] = 1;
  } else if (accept(w::b_spline)) {
    args_[0] = 2;
  } else if (!accept(w::linear_spline)) {
    in_.unexpected(in_.next(), "`linear_spline`, `cubic_spline` or `b_spline`");
  }
  in_.optional_comma();
  const double count = number("the number of spheres");
  for (double i = 0; i < std::trunc(count); ++i) {
    vector();
    args_.push_back(in_.read_scalar("a radius"));
    if (i + 1 < std::trunc(count)) in_.optional_comma();
  }
  args_[1] = accept(w::tolerance) ? in_.read_scalar("a tolerance") : 1e-6;
}

/// `polygon { n, <x,y,z> … }` (objects §11.4).
void ObjectReader::polygon() {
  args_.push_back(std::trunc(number("the number of points")));
  points(args_[0], 3);
}

/// `bicubic_patch { type T u_steps U v_steps V flatness F [uv_vectors …] 16 points }`, or the type
/// and both steps as bare numbers, as it was written once (objects §11.7).
void ObjectReader::bicubic_patch() {
  double type = -1;
  args_.assign({0, 0, 0, 0, 0, 1, 0, 1, 1, 0, 1});
  if (in_.starts_number(in_.peek())) {
    in_.warn(Code::deprecated, word_.span, "the settings of this patch are numbers without words",
             "write `type T u_steps U v_steps V`");
    type = number("the type");
    if (type == 2 || type == 3) args_[2] = number("flatness");
    args_[0] = number("u_steps");
    args_[1] = number("v_steps");
  } else {
    for (;;) {
      if (accept(w::type)) {
        type = number("the type");
      } else if (accept(w::u_steps)) {
        args_[0] = std::trunc(number("u_steps"));
      } else if (accept(w::v_steps)) {
        args_[1] = std::trunc(number("v_steps"));
      } else if (accept(w::flatness)) {
        args_[2] = number("flatness");
      } else if (accept(w::accuracy)) {
        number("accuracy");  // without effect in the oracle, too
      } else {
        break;
      }
    }
    if (accept(w::uv_vectors)) {
      args_.resize(3);
      points(4, 2);
      in_.optional_comma();
    }
  }
  if (!(type >= 0))
    in_.fail(Code::missing_argument, word_.span, "a patch needs `type 0` or `type 1`");
  if (type > 1)
    in_.warn(Code::out_of_range, word_.span,
             "there is no such type of patch; it is taken for type 1");
  points(16, 3);
}

}  // namespace durer::interpreter

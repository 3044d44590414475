// Objects that functions describe: isosurface and parametric (objects §10.13, §11.8).
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// `contained_by { box { A, B } }` or `contained_by { sphere { C, r } }`, after its word.
scene::Container Interpreter::read_container() {
  scene::Container c;
  expect_open("contained_by");
  const Token shape = next();
  if (!shape.is(w::box) && !shape.is(w::sphere)) unexpected(shape, "`box` or `sphere`");
  expect_open(name_of(shape.word));
  const dvec3 first = read_vector();
  optional_comma();
  if (shape.is(w::box)) {
    const dvec3 second = read_vector();
    c.lo = glm::min(first, second);
    c.hi = glm::max(first, second);
  } else {
    c.kind = scene::Container::Kind::sphere;
    c.centre = first;
    c.radius = std::abs(read_scalar("radius"));
  }
  expect_close(name_of(shape.word), shape.span);
  expect_close("contained_by", shape.span);
  return c;
}

/// A number that must be positive; otherwise a warning, and `fallback`.
double Interpreter::read_positive(const Token& word, double fallback) {
  const double v = read_scalar(name_of(word.word));
  if (v > 0) return v;
  warn(Code::out_of_range, word.span,
       fmt::format("`{}` must be positive; taken as {:g}", name_of(word.word), fallback));
  return fallback;
}

scene::Object Interpreter::read_isosurface(std::uint32_t type, const Token& word) {
  const Token function = next();
  if (!function.is(w::function)) unexpected(function, "`function` and its formula");
  scene::Isosurface s;
  s.function = read_scene_function(std::array<SymbolId, 3>{w::x, w::y, w::z});
  for (;;) {
    const Token t = peek();
    if (t.kind != Token::Kind::word) break;
    if (t.word == w::contained_by) {
      next();
      s.container = read_container();
    } else if (t.word == w::threshold) {
      next();
      s.threshold = read_scalar("threshold");
    } else if (t.word == w::accuracy) {
      next();
      s.accuracy = read_positive(t, scene::Isosurface().accuracy);
    } else if (t.word == w::max_gradient) {
      next();
      s.max_gradient = read_positive(t, scene::Isosurface().max_gradient);
    } else if (t.word == w::evaluate) {
      next();
      for (int i = 0; i < 3; ++i) {
        if (i > 0) optional_comma();
        s.evaluate[i] = read_scalar("evaluate");
      }
    } else if (t.word == w::max_trace) {
      next();
      s.max_trace = read_max_trace(t);
    } else if (t.word == w::all_intersections) {
      next();
      s.max_trace = most_traces;
    } else if (t.word == w::open) {
      next();
      s.open = true;
    } else {
      break;
    }
  }
  scene::Object o = primitive(type, word);
  o.extras.edit().isosurface = std::make_shared<const scene::Isosurface>(std::move(s));
  return o;
}

/// 1 … 10, with a warning for what is not.
int Interpreter::read_max_trace(const Token& word) {
  const double v = std::trunc(read_scalar("max_trace"));
  if (v >= 1 && v <= most_traces) return static_cast<int>(v);
  const int used = v > most_traces ? most_traces : 1;
  warn(Code::out_of_range, word.span,
       fmt::format("`max_trace` is 1 to {}; taken as {}", most_traces, used));
  return used;
}

scene::Object Interpreter::read_parametric(std::uint32_t type, const Token& word) {
  scene::Parametric s;
  for (std::size_t i = 0; i < s.functions.size(); ++i) {
    if (i > 0) optional_comma();
    const Token function = next();
    if (!function.is(w::function)) {
      unexpected(function, "three functions of u and v, for x, y and z");
    }
    s.functions[i] = read_scene_function(std::array<SymbolId, 2>{w::u, w::v});
  }
  const Num a = fit(read_num(2), 2);
  optional_comma();
  const Num b = fit(read_num(2), 2);
  s.from = {std::min(a.v[0], b.v[0]), std::min(a.v[1], b.v[1])};
  s.to = {std::max(a.v[0], b.v[0]), std::max(a.v[1], b.v[1])};
  for (;;) {
    const Token t = peek();
    if (t.kind != Token::Kind::word) break;
    if (t.word == w::contained_by) {
      next();
      s.container = read_container();
    } else if (t.word == w::accuracy) {
      next();
      s.accuracy = read_positive(t, scene::Parametric().accuracy);
    } else if (t.word == w::max_gradient) {
      next();
      s.max_gradient = read_positive(t, scene::Parametric().max_gradient);
    } else if (t.word == w::precompute) {
      next();
      read_precompute(t);
    } else {
      break;
    }
  }
  scene::Object o = primitive(type, word);
  o.extras.edit().parametric = std::make_shared<const scene::Parametric>(std::move(s));
  return o;
}

/// `precompute 18 x,y,z`: how the oracle spends memory for speed. Checked, and of no other use.
void Interpreter::read_precompute(const Token& word) {
  const double depth = std::trunc(read_scalar("precompute"));
  if (!(depth >= 1 && depth <= 20)) {
    fail(Code::out_of_range, word.span, "the depth of `precompute` is 1 to 20");
  }
  optional_comma();
  for (const SymbolId axis : {w::x, w::y, w::z}) {
    const Token t = peek();
    const auto* name = t.node<ast::Name>();
    if (name == nullptr || name->name != axis) continue;
    next();
    optional_comma();
  }
}

}  // namespace durer::interpreter

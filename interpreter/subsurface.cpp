// `subsurface { … }` in `global_settings` and in finishes (participating-and-global §4).
#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

void Interpreter::read_subsurface(const Token& word) {
  expect_open("subsurface");
  scene::Subsurface s = scene_.settings.subsurface.value_or(scene::Subsurface{});
  const auto samples = [&](const Token& t) {
    const double n = read_float();
    if (!(n >= 1 && n <= 1e7)) {
      fail(Code::out_of_range, t.span, "`samples` must be at least 1");
    }
    return static_cast<int>(n);
  };
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.is(w::samples)) {
      s.samples = samples(t);
      optional_comma();
      s.single_samples = samples(t);
    } else if (t.is(w::radiosity)) {
      s.radiosity = read_switch(true);
    } else {
      bad_setting(t, "subsurface", word.span, "radiosity samples");
    }
  }
  scene_.settings.subsurface = s;
}

/// `subsurface { translucency COLOUR }` of a finish.
void Interpreter::read_translucency(scene::Finish& f, const Token& word) {
  expect_open("subsurface");
  f.subsurface = true;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.is(w::translucency)) {
      f.translucency = read_rgb();
    } else if (t.is(w::anisotropy)) {
      read_rgb();
      warn(Code::scene, t.span, "`anisotropy` has no effect",
           "light below a surface is scattered in all directions alike");
    } else {
      bad_setting(t, "subsurface", word.span, "anisotropy translucency");
    }
  }
}

}  // namespace durer::interpreter

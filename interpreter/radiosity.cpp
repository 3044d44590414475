// `radiosity { … }` in `global_settings`, in objects and in `#default` (participating-and-global §2.1).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

constexpr std::string_view settings =
    "adc_bailout always_sample brightness count error_bound gray_threshold load_file "
    "low_error_factor max_sample maximum_reuse media minimum_reuse nearest_count normal "
    "pretrace_end pretrace_start recursion_limit save_file subsurface";

}  // namespace

/// A number of `radiosity` that must lie in a range; `above` may be excluded.
double Interpreter::read_radiosity_number(const Token& word, double lo, bool lo_excluded,
                                          double hi) {
  const double x = read_float();
  if (x < lo || (lo_excluded && x == lo) || x > hi) {
    const std::string range = std::isinf(hi) ? fmt::format("{} {}", lo_excluded ? "above" : "at least", lo)
                                             : fmt::format("{} {} and at most {}",
                                                           lo_excluded ? "above" : "at least", lo, hi);
    fail(Code::out_of_range, word.span, fmt::format("`{}` must be {}", name_of(word.word), range));
  }
  return x;
}

void Interpreter::read_radiosity(const Token& word) {
  expect_open("radiosity");
  if (version() < 350) {
    warn(Code::scene, word.span, "`radiosity` in a scene for version 3.1 or older",
         "its settings have other meanings and defaults since 3.5");
  }
  constexpr double any = HUGE_VAL;
  scene::Radiosity r = scene_.settings.radiosity.value_or(scene::Radiosity{});
  bool minimum_given = false;
  bool maximum_given = false;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.kind != Token::Kind::word) bad_setting(t, "radiosity", word.span, settings);
    const auto number = [&](double lo, bool lo_excluded, double hi) {
      return read_radiosity_number(t, lo, lo_excluded, hi);
    };
    switch (t.word) {
      case w::adc_bailout: r.adc_bailout = number(0, true, any); break;
      case w::always_sample: r.always_sample = read_switch(true); break;
      case w::brightness: r.brightness = number(0, true, any); break;
      case w::count: read_radiosity_count(r, t); break;
      case w::error_bound: r.error_bound = number(0, true, any); break;
      case w::gray_threshold: r.gray_threshold = number(0, false, 1); break;
      case w::low_error_factor: r.low_error_factor = number(0, true, any); break;
      case w::max_sample: r.max_sample = read_float(); break;
      case w::maximum_reuse:
        r.maximum_reuse = number(0, true, any);
        maximum_given = true;
        break;
      case w::minimum_reuse:
        r.minimum_reuse = number(0, false, any);
        minimum_given = true;
        break;
      case w::media: r.media = read_switch(true); break;
      case w::nearest_count:
        r.nearest_count = static_cast<int>(number(1, false, 20));
        if (accept_punct(',')) {
          r.adaptive_count = static_cast<int>(number(0, false, r.nearest_count - 1));
        }
        break;
      case w::normal: r.normal = read_switch(true); break;
      case w::pretrace_end: r.pretrace_end = number(0, true, 1); break;
      case w::pretrace_start: r.pretrace_start = number(0, true, 1); break;
      case w::recursion_limit: r.recursion_limit = static_cast<int>(number(1, false, 20)); break;
      case w::subsurface: r.subsurface = read_switch(true); break;
      case w::load_file:
      case w::save_file:
        read_text(true);
        warn(Code::scene, t.span, fmt::format("`{}` has no effect in a scene", name_of(t.word)),
             "use the options `Radiosity_From_File` and `Radiosity_To_File`");
        break;
      default: bad_setting(t, "radiosity", word.span, settings);
    }
  }
  check_reuse(r, minimum_given, maximum_given, word.span);
  if (r.pretrace_end > r.pretrace_start) {
    fail(Code::out_of_range, word.span, "`pretrace_end` must not be above `pretrace_start`");
  }
  scene_.settings.radiosity = r;
}

void Interpreter::read_radiosity_count(scene::Radiosity& r, const Token& word) {
  r.count = static_cast<int>(read_radiosity_number(word, 0, true, 1e6));
  r.pool = std::max(1600, r.count);
  if (accept_punct(',')) {
    r.pool = static_cast<int>(read_radiosity_number(word, r.count, false, 1e8));
  }
}

void Interpreter::check_reuse(scene::Radiosity& r, bool minimum_given, bool maximum_given,
                              Span span) {
  if (r.minimum_reuse <= r.maximum_reuse / 2) return;
  if (!minimum_given) {
    r.minimum_reuse = r.maximum_reuse / 2;
    warn(Code::scene, span,
         fmt::format("`maximum_reuse` is near the default of `minimum_reuse`: {} is used for it",
                     r.minimum_reuse));
  } else if (!maximum_given) {
    r.maximum_reuse = 2 * r.minimum_reuse;
    warn(Code::scene, span,
         fmt::format("`minimum_reuse` is near the default of `maximum_reuse`: {} is used for it",
                     r.maximum_reuse));
  } else if (r.minimum_reuse >= r.maximum_reuse) {
    fail(Code::out_of_range, span, "`minimum_reuse` must be below `maximum_reuse`");
  } else {
    warn(Code::scene, span, "`minimum_reuse` should be at most half of `maximum_reuse`");
  }
}

/// `radiosity { importance F }` of an object or of `#default`.
float Interpreter::read_importance(const Token& word) {
  expect_open("radiosity");
  float importance = 0;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (!t.is(w::importance)) bad_setting(t, "radiosity", word.span, "importance");
    importance = static_cast<float>(read_radiosity_number(t, 0, true, 1));
  }
  return importance;
}

}  // namespace durer::interpreter

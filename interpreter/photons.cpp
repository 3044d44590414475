// `photons { … }` in `global_settings`, in objects, light groups and light sources
// (participating-and-global §3.1, §3.2).
#include <cstring>
#include <span>

#include <fmt/format.h>

#include "base/read_file.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

constexpr std::string_view settings =
    "adc_bailout autostop count expand_thresholds gather jitter load_file max_trace_level media "
    "radius save_file spacing";
constexpr std::string_view object_settings = "collect pass_through reflection refraction target";
constexpr std::string_view light_settings = "area_light reflection refraction";

// Two lists, of surfaces and media: a count, then records of 20 bytes (§3.14).
bool is_photon_file(std::span<const std::uint8_t> bytes) {
  for (int list = 0; list < 2; ++list) {
    std::uint32_t count = 0;
    if (bytes.size() < sizeof count) return false;
    std::memcpy(&count, bytes.data(), sizeof count);
    constexpr std::size_t record = 20;
    const std::size_t length = sizeof count + record * count;
    if (bytes.size() < length) return false;
    bytes = bytes.subspan(length);
  }
  return bytes.empty();
}

}  // namespace

/// A number of `photons` that is at least `least`, or above it.
double Interpreter::read_photon_number(const Token& word, double least, bool least_excluded) {
  const double x = read_float();
  if (x < least || (least_excluded && x == least)) {
    fail(Code::out_of_range, word.span,
         fmt::format("`{}` must be {} {}", name_of(word.word),
                     least_excluded ? "above" : "at least", least));
  }
  return x;
}

void Interpreter::read_photons(const Token& word) {
  expect_open("photons");
  scene::Photons p = scene_.settings.photons.value_or(scene::Photons{});
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.kind != Token::Kind::word) bad_setting(t, "photons", word.span, settings);
    const auto whole = [&](double least) {
      return static_cast<int>(std::min(read_photon_number(t, least), 1e9));
    };
    switch (t.word) {
      case w::spacing: p.spacing = read_photon_number(t, 0, true); break;
      case w::count: p.count = whole(0); break;
      case w::gather:
        p.gather_min = whole(0);
        optional_comma();
        p.gather_max = whole(p.gather_min);
        if (p.gather_max == 0) {
          warn(Code::scene, t.span, "`gather 0, 0` switches photons off");
        }
        break;
      case w::radius: read_photon_radii(p); break;
      case w::media:
        p.media_steps = whole(0);
        optional_comma();
        if (starts_number(peek())) p.media_factor = read_photon_number(t, 0, true);
        break;
      case w::jitter: p.jitter = read_float(); break;
      case w::autostop: p.autostop = read_float(); break;
      case w::expand_thresholds:
        p.expand_increase = read_float();
        optional_comma();
        p.expand_min = static_cast<int>(read_float());
        if (p.expand_increase < 0 || p.expand_min < 0) {
          warn(Code::out_of_range, t.span, "`expand_thresholds` below 0 are taken for 0");
          p.expand_increase = std::max(p.expand_increase, 0.0);
          p.expand_min = std::max(p.expand_min, 0);
        }
        break;
      case w::max_trace_level: p.max_trace_level = static_cast<int>(read_float()); break;
      case w::adc_bailout: p.adc_bailout = read_float(); break;
      case w::load_file:
      case w::save_file: read_photon_file(p, t); break;
      default: bad_setting(t, "photons", word.span, settings);
    }
  }
  scene_.settings.photons = std::move(p);
}

/// `radius [R [, F [, RM [, FM]]]]`: what is not written, or not positive, stays as it is.
void Interpreter::read_photon_radii(scene::Photons& p) {
  for (double* number :
       {&p.surface_radius, &p.surface_factor, &p.media_radius, &p.media_factor_of_radius}) {
    if (!starts_number(peek())) return;
    const double x = read_float();
    if (x > 0) *number = x;
    optional_comma();
  }
}

void Interpreter::read_photon_file(scene::Photons& p, const Token& word) {
  const bool load = word.word == w::load_file;
  if (!p.save_file.empty() || !p.loaded.empty()) {
    warn(Code::scene, word.span, "of `load_file` and `save_file` only the last one counts");
    p.save_file.clear();
    p.loaded.clear();
  }
  const Span span = peek().span;
  const std::string name = read_text(true).bytes();
  if (!load) {
    check_writable(name, span);
    p.save_file = name;
    return;
  }
  const auto path = find_file(name, span, {});
  if (!path) missing_file(name, span, {});
  const std::optional<std::string> bytes = durer::read_file(*path);
  if (!bytes) fail(Code::file_not_found, span, fmt::format("`{}` cannot be read", *path));
  p.loaded.assign(bytes->begin(), bytes->end());
  if (!is_photon_file(p.loaded)) {
    fail(Code::file_not_found, span, fmt::format("`{}` is no photon file, or not whole", *path));
  }
}

/// `photons { … }` of an object or a light group.
void Interpreter::read_object_photons(scene::ObjectPhotons& p, const Token& word) {
  expect_open("photons");
  grammar::SymbolId last = 0;  // of the words that can contradict each other
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.kind != Token::Kind::word) bad_setting(t, "photons", word.span, object_settings);
    switch (t.word) {
      case w::target:
        p.target = starts_number(peek()) ? std::max(0.0, read_float()) : 1;
        last = t.word;
        break;
      case w::refraction:
        p.refraction = read_switch(true);
        last = t.word;
        break;
      case w::reflection: p.reflection = read_switch(true); break;
      case w::pass_through:
        p.pass_through = read_switch(true);
        last = t.word;
        break;
      case w::collect: p.collect = read_switch(true); break;
      default: bad_setting(t, "photons", word.span, object_settings);
    }
  }
  settle_pass_through(p, last, word.span);
}

/// A target that lets photons through as if it were not there cannot bend them (§3.2).
void Interpreter::settle_pass_through(scene::ObjectPhotons& p, grammar::SymbolId last, Span span) {
  if (!p.pass_through || p.target == 0 || p.refraction == false) return;
  const bool bends = last == w::refraction || (last == w::target && p.refraction == true);
  if (bends) {
    p.pass_through = false;
  } else {
    p.refraction = false;
  }
  warn(Code::scene, span, "a target that refracts photons cannot `pass_through`",
       bends ? "`pass_through` is off" : "`refraction` is off");
}

void Interpreter::read_light_photons(scene::LightPhotons& p, const Token& word) {
  expect_open("photons");
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) return;
    if (t.is_punct(';')) continue;
    if (t.kind != Token::Kind::word) bad_setting(t, "photons", word.span, light_settings);
    switch (t.word) {
      case w::refraction: p.refraction = read_switch(true); break;
      case w::reflection: p.reflection = read_switch(true); break;
      case w::area_light: p.area = true; break;
      default: bad_setting(t, "photons", word.span, light_settings);
    }
  }
}

}  // namespace durer::interpreter

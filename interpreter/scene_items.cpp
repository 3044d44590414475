// Background and global settings (shading §1.2, §7.1; language §8).
#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

void Interpreter::read_background() {
  expect_open("background");
  Colour c = read_colour();
  expect_close("background", {});
  // The effective version of this moment decides (shading §7.1).
  const int effective = version_given_ ? declared_version_ : 362;
  if (effective < 370) {
    c.filter = 0;
    c.transmit = options_.output_alpha ? 1.0F : 0.0F;
  } else if (!options_.output_alpha) {
    c.rgb *= 1 - c.transmit;
    c.filter = c.transmit = 0;
  }
  scene_.background = c;
}

void Interpreter::read_global_settings(Span span) {
  expect_open("global_settings");
  scene::Settings& s = scene_.settings;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) return;
    if (t.is_punct(';')) continue;
    static constexpr std::string_view settings =
        "adc_bailout ambient_light assumed_gamma charset hf_gray_16 irid_wavelength "
        "max_intersections "
        "max_trace_level mm_per_unit noise_generator number_of_waves photons radiosity subsurface";
    if (t.kind != Token::Kind::word) bad_setting(t, "global_settings", span, settings);
    switch (t.word) {
      case w::adc_bailout: s.adc_bailout = static_cast<float>(read_float()); break;
      case w::ambient_light: s.ambient_light = read_rgb(); break;
      case w::irid_wavelength: s.irid_wavelength = read_rgb(); break;
      case w::assumed_gamma: read_assumed_gamma(t); break;
      case w::max_trace_level: read_max_trace_level(t); break;
      case w::max_intersections:
        read_float();
        if (version() >= 370) warn(Code::deprecated, t.span, "`max_intersections` has no effect");
        break;
      case w::hf_gray_16:
        read_switch(true);
        warn(Code::deprecated, t.span, "`hf_gray_16` has no effect", "use `Grayscale_Output=on`");
        break;
      case w::mm_per_unit: s.mm_per_unit = read_float(); break;
      case w::noise_generator: {
        const int n = static_cast<int>(read_float());
        if (n < 1 || n > 3) fail(Code::out_of_range, t.span, "`noise_generator` is 1, 2 or 3");
        s.noise_generator = n;
        break;
      }
      case w::number_of_waves:
        s.number_of_waves = static_cast<int>(read_float());
        if (s.number_of_waves <= 0) {
          warn(Code::out_of_range, t.span, "`number_of_waves` must be positive; 1 is used");
          s.number_of_waves = 1;
        }
        break;
      case w::charset:
        if (accept(w::utf8)) {
          charset_ = Charset::utf8;
        } else if (accept(w::ascii)) {
          charset_ = Charset::ascii;
        } else if (accept(w::sys)) {
          charset_ = Charset::system;
        } else {
          unexpected(peek(), "`ascii`, `utf8` or `sys`");
        }
        break;
      case w::radiosity: read_radiosity(t); break;
      case w::photons: read_photons(t); break;
      case w::subsurface: read_subsurface(t); break;
      default: bad_setting(t, "global_settings", span, settings);
    }
  }
}

void Interpreter::read_max_trace_level(const Token& word) {
  int n = static_cast<int>(read_float());
  if (n > 256) {
    warn(Code::out_of_range, word.span, "`max_trace_level` is at most 256");
    n = 256;
  }
  scene_.settings.max_trace_level = std::max(n, 1);
}

void Interpreter::read_assumed_gamma(const Token& word) {
  GammaCurve curve = GammaCurve::srgb();
  if (!accept(w::srgb)) {
    const double g = read_float();
    if (g <= 0) fail(Code::out_of_range, word.span, "`assumed_gamma` must be positive");
    if (g < 1)
      warn(Code::out_of_range, word.span, "an `assumed_gamma` below 1 is hardly what you want");
    curve = GammaCurve::power(static_cast<float>(g));
  }
  if (assumed_gamma_given_) {
    warn(Code::scene, word.span, "only the first `assumed_gamma` counts");
    return;
  }
  assumed_gamma_given_ = true;
  scene_.settings.assumed_gamma = curve;
}

/// What only the end of the scene decides: gamma mode and effective version (shading §1.1, §1.2).
void Interpreter::finish_settings() {
  scene::Settings& s = scene_.settings;
  s.declared_version = std::max(declared_version_, 350);
  s.effective_version = version_given_ ? s.declared_version : 362;
  const bool modern = s.effective_version >= 370;
  if (s.radiosity) s.radiosity->background_importance = default_importance_;
  if (assumed_gamma_given_) {
    s.gamma_mode = modern ? scene::GammaMode::explicit_ : scene::GammaMode::legacy;
  } else {
    s.gamma_mode = modern ? scene::GammaMode::implied : scene::GammaMode::off;
    s.assumed_gamma = GammaCurve{};
  }
  if (s.noise_generator == 0) s.noise_generator = declared_version_ >= 350 ? 2 : 1;
  if (scene_.background == Colour{.rgb = vec3(0.0F), .filter = 0, .transmit = 1} &&
      !options_.output_alpha) {
    scene_.background.transmit = 0;
  }
}

}  // namespace durer::interpreter

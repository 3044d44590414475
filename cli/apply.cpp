#include "cli/apply.h"

#include <cmath>

namespace durer::cli::apply {

Problem return_action(ShellHook& hook, std::string_view value) {
  const bool reversed = value.starts_with('-') || value.starts_with('!');
  static constexpr std::string_view letters = "isaquf";  // in the order of Action
  const std::string letter = lower(value.substr(reversed ? 1 : 0, 1));
  const std::size_t index = letter.empty() ? std::string::npos : letters.find(letter);
  if (index == std::string::npos) return expected("one of I S A Q U F, or with `-` before", value);
  hook.action = static_cast<Action>(index);
  hook.on_success = reversed;
  return {};
}

Problem ignored_boolean(Settings& /*s*/, std::string_view value) {
  return parse_bool(value) ? Problem() : expected("on or off", value);
}

Problem ignored_number(Settings& /*s*/, std::string_view value) {
  return parse_number(value) ? Problem() : expected("a number", value);
}

Problem ignored_text(Settings& /*s*/, std::string_view /*value*/) { return {}; }

Problem only_off(Settings& /*s*/, std::string_view value) {
  const auto b = parse_bool(value);
  if (!b) return expected("on or off", value);
  return *b ? Problem("this is not supported yet") : Problem();
}

Problem only_empty(Settings& /*s*/, std::string_view value) {
  return value.empty() ? Problem() : Problem("this is not supported yet");
}

Problem input(Settings& s, std::string_view value) {
  s.input = value;
  s.inputs.emplace_back(value);
  return {};
}

Problem output_type(Settings& s, std::string_view value) {
  const bool compressed = same_word(value, "C");
  const bool system = same_word(value, "S");  // the system's own type, PNG on Unix
  const image::Format* format = image::format_named(compressed ? "tga" : system ? "png" : value);
  if (!format) {
    std::string names;
    for (const image::Format* f : image::formats()) names += fmt::format(" {}", f->name);
    return fmt::format("unknown type `{}`, there are N T C J P B E H S and{}", value, names);
  }
  s.format = format;
  s.compressed_tga = compressed;
  return {};
}

Problem dither_method(Settings& s, std::string_view value) {
  using image::Dither;
  constexpr std::pair<std::string_view, Dither> methods[] = {
      {"B2", Dither::b2}, {"B3", Dither::b3}, {"B4", Dither::b4},
      {"D1", Dither::d1}, {"D2", Dither::d2}, {"FS", Dither::fs}};
  for (const auto& [name, method] : methods) {
    if (!same_word(name, value)) continue;
    s.dither_method = method;
    return {};
  }
  return expected("B2, B3, B4, D1, D2 or FS", value);
}

Problem file_gamma(Settings& s, std::string_view value) {
  const auto curve = parse_gamma(value);
  if (!curve) return expected("sRGB or a number greater than 0", value);
  s.file_gamma = *curve;
  return {};
}

Problem integrator(Settings& s, std::string_view value) {
  s.paths = same_word(value, "path");
  return s.paths || same_word(value, "trace") ? Problem() : expected("trace or path", value);
}

Problem size(Settings& s, std::string_view value) {
  const auto both = parse_size(value);
  if (!both) return expected("a size such as 800x600", value);
  if (auto problem = whole<&Settings::width, 1, 65535>(s, std::to_string(both->width))) {
    return problem;
  }
  return whole<&Settings::height, 1, 65535>(s, std::to_string(both->height));
}

Problem library_path(Settings& s, std::string_view value) {
  if (value.empty()) return "expected a folder";
  s.library_paths.emplace_back(value);
  return {};
}

Problem declare(Settings& s, std::string_view value) {
  const std::size_t equals = value.find('=');
  const std::string_view name = trim(value.substr(0, equals));
  const bool is_name = !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_';
  }) && std::isdigit(static_cast<unsigned char>(name.front())) == 0;
  if (!is_name || equals == std::string_view::npos) return expected("name=value", value);
  const std::string_view raw = trim(value.substr(equals + 1));
  if (const auto x = parse_number(raw)) {
    s.declares.emplace_back(name, *x);
    return {};
  }
  const std::string_view inner = unquote(raw);
  if (inner.size() == raw.size()) return expected("a number or a \"string\"", raw);
  s.declares.emplace_back(name, std::string(inner));
  return {};
}

Problem clock(Settings& s, std::string_view value) {
  if (auto problem = number<&Settings::clock>(s, value)) return problem;
  s.clock_given = true;
  return {};
}

Problem version(Settings& s, std::string_view value) {
  const auto v = parse_number(value);
  if (!v || *v < 1) return expected("a version such as 3.7", value);
  if (*v > 3.7 + 1e-9)
    return fmt::format("language version {} is not known, 3.7 is the last", value);
  s.version = static_cast<int>(std::lround(*v * 100));
  return {};
}

Problem aa_gamma(Settings& s, std::string_view value) {
  const auto x = parse_number(value);
  if (!x || *x <= 0) return expected("a number greater than 0", value);
  s.aa_gamma = *x;
  return {};
}

Problem all_console(Settings& s, std::string_view value) {
  const auto b = parse_bool(value);
  if (!b) return expected("on or off", value);
  for (StreamSettings& stream : s.streams) stream.console = *b;
  return {};
}

Problem diagnostics_format(Settings& s, std::string_view value) {
  s.json = same_word(value, "json");
  return s.json || same_word(value, "text") ? Problem() : expected("text or json", value);
}

Problem dump_scene(Settings& s, std::string_view value) {
  const auto b = parse_bool(value);
  s.dump_scene = b && !*b                   ? DumpFormat::none
                 : same_word(value, "json") ? DumpFormat::json
                                            : DumpFormat::text;
  const bool known = b || same_word(value, "json") || same_word(value, "text");
  return known ? Problem() : expected("text or json", value);
}

/// Nothing that comes later may take it back: an INI file could.
Problem untrusted(Settings& s, std::string_view value) {
  const auto b = parse_bool(value);
  if (!b) return expected("on or off", value);
  if (s.untrusted && !*b) return "an untrusted run cannot become a trusted one";
  s.untrusted = *b;
  return {};
}

}  // namespace durer::cli::apply

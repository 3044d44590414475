#include "cli/output_name.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/values.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;

/// Folder (with its last slash) and name; either may be empty.
std::pair<std::string, std::string> split(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return {"", path};
  return {path.substr(0, slash + 1), path.substr(slash + 1)};
}

/// Step 2 of the rule: the type's own extension and a lone dot at the end go.
std::string without_own_extension(std::string name, std::string_view extension) {
  if (name.ends_with(extension)) {
    name.resize(name.size() - extension.size());
  } else if (name.ends_with('.')) {
    name.pop_back();
  }
  return name;
}

std::string text_of(const std::optional<FrameNumber>& frame) {
  return frame ? fmt::format("{:0{}}", frame->number, frame->digits) : "";
}

}  // namespace

std::string scene_stem(const Settings& s) {
  return s.input == "-" ? "stdin" : fs::path(s.input).stem().string();
}

Output output_of(const Settings& s, const std::optional<FrameNumber>& frame) {
  const image::Format* by_name = image::format_of(s.output);
  const image::Format* png = image::format_named("png");
  Output out{"", s.format ? s.format : by_name ? by_name : png};
  if (!s.write_output) return out;
  if (s.output == "-" || same_word(s.output, "stdout")) return {"-", out.format};

  auto [folder, name] = split(s.output);
  if (const std::size_t dot = name.rfind('.'); !s.format && by_name && dot > 0) {
    return {folder + name.substr(0, dot) + text_of(frame) + name.substr(dot), by_name};
  }
  // A given name goes where it says; a derived one goes beside the scene.
  if (s.output.empty()) folder = s.input == "-" ? "" : split(s.input).first;
  const std::string extension(by_name && !s.format ? name : out.format->extension);
  name = without_own_extension(std::move(name), extension);
  if (name.empty()) name = scene_stem(s);
  out.path = folder + name + text_of(frame) + extension;
  return out;
}

}  // namespace durer::cli

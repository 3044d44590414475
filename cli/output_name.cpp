#include "cli/output_name.h"

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

std::string scene_stem(const Settings& s) {
  return s.input == "-" ? "stdin" : fs::path(s.input).stem().string();
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

}  // namespace

Output output_of(const Settings& s) {
  const image::Format* by_name = image::format_of(s.output);
  const image::Format* png = image::format_named("png");
  Output out{"", s.format ? s.format : by_name ? by_name : png};
  if (!s.write_output) return out;
  if (s.output == "-" || same_word(s.output, "stdout")) return {"-", out.format};

  auto [folder, name] = split(s.output);
  if (!s.format && by_name && name.rfind('.') > 0) return {s.output, by_name};
  // A given name goes where it says; a derived one goes beside the scene.
  if (s.output.empty()) folder = s.input == "-" ? "" : split(s.input).first;
  const std::string extension(by_name && !s.format ? name : out.format->extension);
  name = without_own_extension(std::move(name), extension);
  if (name.empty()) name = scene_stem(s);
  out.path = folder + name + extension;
  return out;
}

}  // namespace durer::cli

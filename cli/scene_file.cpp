#include "cli/scene_file.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "base/find_file.h"
#include "cli/values.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders_for(const std::string& name, const Settings& settings) {
  std::vector<fs::path> folders = {""};
  if (name.starts_with('/')) return folders;
  folders.insert(folders.end(), settings.library_paths.begin(), settings.library_paths.end());
  return folders;
}

constexpr std::array<const char*, 4> suffixes = {"", ".pov", ".POV", ".scene"};

/// Empty if there is none.
std::string find_scene(const Settings& s, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const char* suffix : suffixes) names.push_back(s.input + suffix);
  const auto found = find_file(names, folders_for(s.input, s), true);
  if (!found) return {};
  if (found->other_spelling) {
    Diagnostic d;
    d.severity = Severity::warning;
    d.code = Code::file_found_elsewhere;
    d.message =
        fmt::format("there is no `{}`; `{}` is taken instead", s.input, found->path.string());
    diagnostics.report(std::move(d));
  }
  return found->path.string();
}

void report_missing(std::string message, Diagnostics& diagnostics) {
  Diagnostic d;
  d.code = Code::file_not_found;
  d.message = std::move(message);
  diagnostics.report(std::move(d));
}

}  // namespace

std::optional<std::string> read_file(const std::string& path) {
  if (path == "-") return std::string(std::istreambuf_iterator<char>(std::cin), {});
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

std::optional<SceneText> read_scene(Settings& settings, Diagnostics& diagnostics) {
  if (settings.input != "-") {
    std::string path = find_scene(settings, diagnostics);
    if (path.empty()) {
      report_missing(fmt::format("there is no scene `{}`", settings.input), diagnostics);
      return std::nullopt;
    }
    settings.input = std::move(path);
  }
  auto text = read_file(settings.input);
  if (!text) {
    report_missing(fmt::format("cannot read `{}`", settings.input), diagnostics);
    return std::nullopt;
  }
  return SceneText{settings.input, std::move(*text)};
}

std::string stdlib_folder() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& folder : {program / "../share/durer/include", fs::path(DURER_STDLIB)}) {
    if (fs::is_directory(folder, ignored)) return folder.lexically_normal().string();
  }
  return {};
}

std::vector<std::string> installed_include_folders() {
  std::vector<std::string> found;
  std::error_code ignored;
  for (const char* root : {"/usr/local/share/", "/usr/share/"}) {
    for (const char* version : {"povray-3.7", "povray-3.8", "povray"}) {
      const fs::path folder = fs::path(root) / version / "include";
      if (fs::is_directory(folder, ignored)) found.push_back(folder.string());
    }
  }
  return found;
}

}  // namespace durer::cli

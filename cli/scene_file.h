// The scene's text, and the folders in which it looks for others.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "cli/settings.h"

namespace durer::cli {

/// The text of a scene, read once for all frames.
struct SceneText {
  std::string path;
  std::string text;
};

/// Reads the scene: the exact name first, then with `.pov` or `.scene` behind it, in
/// the working folder and the library folders; then in other letter cases, with a warning.
/// "-" is standard input. Sets `settings.input` to the name that was found.
[[nodiscard]] std::optional<SceneText> read_scene(Settings& settings, Diagnostics& diagnostics);

/// All of one file ("-": standard input), or nothing.
[[nodiscard]] std::optional<std::string> read_file(const std::string& path);

/// The folder of the language's own includes beside the program; empty if there is none.
[[nodiscard]] std::string stdlib_folder();
/// Include folders of an installed POV-Ray.
[[nodiscard]] std::vector<std::string> installed_include_folders();

}  // namespace durer::cli

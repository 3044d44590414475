// Syntax trees → scene. Public.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/diagnostic.h"
#include "base/source.h"
#include "scene/object_queries.h"
#include "scene/scene.h"
#include "scene/type_info.h"

namespace durer::interpreter {

struct Options {
  /// Searched in order for includes: the scene's folder, `include_paths`, the built-in library
  /// (`stdlib_path`, may be empty), then the folders of an installed POV-Ray (`fallback_paths`).
  std::vector<std::string> include_paths;
  std::string stdlib_path;
  std::vector<std::string> fallback_paths;
  /// `Declare=name=value` from command line or INI, in order; the first of a name wins.
  std::vector<std::pair<std::string, std::variant<double, std::string>>> declares;
  int width = 160;
  int height = 120;
  double clock = 0;
  bool clock_on = false;
  int version = 0;  // hundredths, from the command line; 0: not given
  bool output_alpha = false;
  /// Answers `trace`, `inside` and the extents; without it they are errors.
  scene::ObjectQueries* queries = nullptr;
  /// Receives #debug, #render and #statistics text as it is produced (no newline added).
  std::function<void(std::string_view)> on_debug;
};

/// Reads `path` ("-" or text given by `main_file`) and interprets it. Errors are reported; then the
/// result is empty.
[[nodiscard]] std::optional<scene::Scene> interpret(SourceMap& sources, FileId main_file,
                                                    const scene::Registry& registry,
                                                    const Options& options,
                                                    Diagnostics& diagnostics);

}  // namespace durer::interpreter

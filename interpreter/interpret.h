// Syntax trees → scene. Public.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/diagnostic.h"
#include "base/picture.h"
#include "base/source.h"
#include "scene/object_queries.h"
#include "scene/pigment_queries.h"
#include "scene/scene.h"
#include "scene/type_info.h"

namespace durer::interpreter {

/// Where a scene stops being taken for sound: each is an error that names the option to raise it.
/// 0: no limit.
struct Limits {
  std::size_t macro_depth = 1000;   // calls inside one another
  std::uint64_t loop_turns = 0;     // of all loops and macro calls together
  double seconds = 0;               // of interpreting
  std::size_t memory = 0;           // bytes the process may hold
  std::size_t include_depth = 100;  // files inside one another
};

/// The numbers of an animation that a scene can read (language §9.6); all zero for a still.
struct AnimationFrame {
  int number = 0;
  int first = 0;
  int last = 0;  // one more for a cyclic animation
  double first_clock = 0;
  double last_clock = 0;
  double clock_delta = 0;
};

struct Options {
  /// Searched in order: the scene's folder, `include_paths`, the library (`stdlib_path`, may be
  /// empty), an installed POV-Ray's folders (`fallback_paths`), the library's folder `stand-ins`.
  std::vector<std::string> include_paths;
  std::string stdlib_path;
  std::vector<std::string> fallback_paths;
  /// `Declare=name=value` from command line or INI, in order; the first of a name wins.
  std::vector<std::pair<std::string, std::variant<double, std::string>>> declares;
  int width = 160;
  int height = 120;
  double clock = 0;
  bool clock_on = false;
  AnimationFrame frame;
  int version = 0;  // hundredths, from the command line; 0: not given
  /// Read before the scene, as an include (+HI); empty: none.
  std::string header_file;
  Limits limits;
  /// Files may be read only below the scene's folder and the folders searched, and `#fopen` may
  /// write only files named in `writable`.
  bool confined = false;
  std::vector<std::string> writable;
  bool output_alpha = false;
  /// Take the shorter ways: compiled formulas, prepared statements, blocks read once. They change
  /// nothing but the time it takes; without them tests see the long way.
  bool shortcuts = true;
  /// Answers `trace`, `inside` and the extents; without it they are errors.
  scene::ObjectQueries* queries = nullptr;
  /// Evaluates the patterns and pigments of functions; without it they are errors.
  scene::PigmentQueries* pigments = nullptr;
  /// Reads the pictures of height fields; without it they are errors.
  PictureReader read_picture;
  /// Receives #debug, #render and #statistics text as it is produced (no newline added).
  std::function<void(std::string_view)> on_debug;
  /// Receives, once the scene is read, one line that says what was taken for granted: "language
  /// 3.62 (no #version); assumed_gamma 1 (.scene)".
  std::function<void(std::string_view)> on_assumptions;
  /// Receives a line for every macro call and return (--trace-macros).
  std::function<void(std::string_view)> on_trace;
};

/// Reads `path` ("-" or text given by `main_file`) and interprets it. Errors are reported; then the
/// result is empty.
[[nodiscard]] std::optional<scene::Scene> interpret(SourceMap& sources, FileId main_file,
                                                    const scene::Registry& registry,
                                                    const Options& options,
                                                    Diagnostics& diagnostics);

}  // namespace durer::interpreter

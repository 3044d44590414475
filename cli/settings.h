// Everything the command line and INI files can say, with its defaults.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/gamma.h"
#include "image/image.h"

namespace durer::cli {

/// The message streams of POV-Ray, each with a switch and perhaps a copy in a file.
enum class Stream : std::uint8_t { debug, fatal, render, statistic, warning };
inline constexpr std::size_t stream_count = 5;

struct StreamSettings {
  bool console = true;
  std::string file;  // empty: no copy
};

/// The scene as data, instead of a picture.
enum class DumpFormat : std::uint8_t { none, text, json };

/// When a shell command may run.
enum class Moment : std::uint8_t {
  pre_scene,
  pre_frame,
  post_frame,
  post_scene,
  user_abort,
  fatal_error
};
inline constexpr std::size_t moment_count = 6;

/// What follows from the exit code of a shell command.
enum class Action : std::uint8_t { ignore, skip, skip_all, quit, user_abort, fatal };

struct ShellHook {
  std::string command;  // empty: none
  Action action = Action::ignore;
  bool on_success = false;  // the action is taken when the command succeeds, not when it fails
};

struct Settings {
  // Files
  std::string input;                // "-": standard input
  std::vector<std::string> inputs;  // all that were named; `check` takes several
  std::string output;               // as given; see output_name.h
  bool write_output = true;
  const image::Format* format = nullptr;  // null: by the extension of `output`, else PNG
  bool compressed_tga = false;
  int bits = 8;
  bool greyscale = false;
  bool alpha = false;
  int compression = -1;
  bool dither = false;
  image::Dither dither_method = image::Dither::fs;
  GammaCurve file_gamma = GammaCurve::srgb();
  std::vector<std::string> library_paths;
  std::string create_ini;

  // Size and part
  int width = 800;
  int height = 600;
  std::optional<double> start_column, end_column, start_row, end_row;  // numbers or fractions

  // Sampling
  bool antialias = false;
  int sampling_method = 1;
  double aa_threshold = 0.3;
  int aa_depth = 3;
  bool jitter = true;
  double jitter_amount = 1;
  double aa_gamma = 2.5;
  int quality = 9;
  int block_size = 32;
  int threads = 0;  // 0: one per processor
  bool paths = false;  // light is followed along random paths
  int path_samples = 64;
  int path_bounces = 64;

  // The scene's world
  std::vector<std::pair<std::string, std::variant<double, std::string>>> declares;
  double clock = 0;
  bool clock_given = false;
  int version = 0;          // hundredths; 0: not given
  std::string header_file;  // read before the scene

  // Animation; see animation.h
  std::optional<int> initial_frame, final_frame;
  double initial_clock = 0;
  double final_clock = 1;
  std::optional<double> subset_start, subset_end;  // frame numbers or fractions
  int frame_step = 1;
  bool cyclic = false;
  bool continue_trace = false;
  ShellHook hooks[moment_count];

  // Bounds of what a scene may take; not given: see limits.h
  std::optional<int> max_macro_depth, max_include_depth, max_frames;
  std::optional<double> max_loop_turns, max_seconds, max_render_seconds, max_memory, max_pixels;
  bool untrusted = false;

  // For people and programs that look into scenes
  DumpFormat dump_scene = DumpFormat::none;
  bool trace_macros = false;

  // Messages
  bool json = false;  // as JSON, for programs
  StreamSettings streams[stream_count];
  std::string all_file;
  bool append_files = false;
  int warning_level = 10;
  std::optional<bool> verbose;
  bool quiet = false;
  bool show = false;

  /// What was set, in order, for `Create_Ini`.
  std::vector<std::pair<std::string, std::string>> history;
  /// Keywords that an INI file has set.
  std::vector<std::string> from_ini;
};

}  // namespace durer::cli

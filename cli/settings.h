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

struct Settings {
  // Files
  std::string input;   // "-": standard input
  std::string output;  // as given; see output_name.h
  bool write_output = true;
  const image::Format* format = nullptr;  // null: by the extension of `output`, else PNG
  bool compressed_tga = false;
  int bits = 8;
  bool greyscale = false;
  bool alpha = false;
  int compression = -1;
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

  // The scene's world
  std::vector<std::pair<std::string, std::variant<double, std::string>>> declares;
  double clock = 0;
  bool clock_given = false;
  int version = 0;  // hundredths; 0: not given
  int initial_frame = 0;
  int final_frame = 0;

  // Messages
  StreamSettings streams[stream_count];
  std::string all_file;
  bool append_files = false;
  int warning_level = 10;
  std::optional<bool> verbose;
  bool quiet = false;
  bool show = false;

  /// What was set, in order, for `Create_Ini`.
  std::vector<std::pair<std::string, std::string>> history;
};

}  // namespace durer::cli

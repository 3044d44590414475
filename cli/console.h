// The five message streams of POV-Ray: each may speak on standard error and into files.
#pragma once

#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "cli/settings.h"

namespace durer::cli {

class Console {
 public:
  /// Opens the files that the settings name; `problem` tells which cannot be. They stay open, so
  /// that later frames append to what the first has written.
  Console(const Settings& settings, std::string& problem);

  /// Sends `text` as it is, without a line break of its own. `quiet` leaves errors only.
  void print(Stream stream, std::string_view text);
  /// Errors go to the fatal stream, all else to that of warnings, unless Warning_Level is 0.
  void print(const Diagnostic& d, const SourceMap& sources);
  /// All that were kept, and how many were not.
  void print(const Diagnostics& diagnostics);
  /// One error without a place. Returns the exit code of errors.
  int fail(Code code, std::string message, std::string help = {});

  /// True if the stream reaches standard error.
  [[nodiscard]] bool speaks(Stream stream) const;
  [[nodiscard]] bool json() const { return json_; }

 private:
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  using File = std::unique_ptr<std::FILE, Close>;
  [[nodiscard]] static File open(const std::string& path, bool append, std::string& problem);
  void to_files(Stream stream, std::string_view text);
  void to_console(Stream stream, std::string_view text);

  bool console_[stream_count] = {};
  File files_[stream_count];
  File all_;
  bool json_ = false;
  bool warnings_ = true;
};

/// True if messages on standard error may be coloured (a terminal, and NO_COLOR is not set).
[[nodiscard]] bool colour_wanted();

}  // namespace durer::cli

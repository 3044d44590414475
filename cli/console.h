// The five message streams of POV-Ray: each may speak on standard error and into files.
#pragma once

#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

#include "cli/settings.h"

namespace durer::cli {

class Console {
 public:
  /// Opens the files that the settings name; `problem` tells which cannot be.
  Console(const Settings& settings, std::string& problem);

  /// Sends `text` as it is, without a line break of its own. `quiet` leaves errors only.
  void print(Stream stream, std::string_view text);
  /// True if the stream reaches standard error.
  [[nodiscard]] bool speaks(Stream stream) const;

 private:
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  using File = std::unique_ptr<std::FILE, Close>;
  [[nodiscard]] static File open(const std::string& path, bool append, std::string& problem);

  bool console_[stream_count] = {};
  File files_[stream_count];
  File all_;
};

}  // namespace durer::cli

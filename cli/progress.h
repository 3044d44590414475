// How far a render has come, as text.
#pragma once

#include <cstdio>
#include <string>

#include "tracer/render.h"

namespace durer::cli {

/// "2.41 M", "950", "12.0 k".
[[nodiscard]] std::string count_text(double count);
/// "12 ms", "7.3 s", "1:05", "2:03:04".
[[nodiscard]] std::string time_text(double seconds);
/// "42 %, 1.20 M rays/s, 0:12 left"; without the time left before it can be guessed.
[[nodiscard]] std::string progress_text(const tracer::Progress& progress);
/// The same behind a bar, in at most `columns` columns: "[=====>    ] 42 %, …".
[[nodiscard]] std::string progress_bar(const tracer::Progress& progress, int columns);

/// Shows progress on standard error: one line that changes on a terminal, now and then a line
/// otherwise. Not for several threads at a time.
class ProgressLine {
 public:
  /// `columns` 0: not a terminal.
  ProgressLine(std::FILE* to, int columns) : to_(to), columns_(columns) {}
  void show(const tracer::Progress& progress);
  /// Clears the line, so that other text can follow.
  void clear();

 private:
  std::FILE* to_;
  int columns_;
  bool drawn_ = false;
  double last_ = 0;  // seconds, in the render's own time
};

}  // namespace durer::cli

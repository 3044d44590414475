// Which frames there are, and what each is called and sees (language §9.6).
#pragma once

#include <optional>

#include "cli/settings.h"
#include "interpreter/interpret.h"

namespace durer::cli {

/// Frames `from` to `to` by `step`, all of them numbered `first` to `last`.
struct Animation {
  int first = 1;
  int last = 1;  // the one after the last frame, if cyclic
  int from = 1;
  int to = 1;
  int step = 1;
  float first_clock = 0;
  float last_clock = 1;
  /// Frame numbers in file names have the digits of `last`.
  int digits = 1;

  [[nodiscard]] double clock_delta() const;
  /// In single precision, as the language has it.
  [[nodiscard]] double clock(int frame) const;
  /// What the scene can read; all numbers have six significant digits, as in POV-Ray.
  [[nodiscard]] interpreter::AnimationFrame values(int frame) const;
  [[nodiscard]] int count() const { return (to - from) / step + 1; }
};

/// None: a still picture. That is (Initial_Frame, Final_Frame) = (0, 0), where 0 stands for an
/// option that was not given, and (1, 1).
[[nodiscard]] std::optional<Animation> animation_of(const Settings& settings);

}  // namespace durer::cli

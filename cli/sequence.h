// A run: its frames, with the shell commands between them.
#pragma once

#include <functional>

#include "cli/animation.h"
#include "cli/shell.h"

namespace durer::cli {

/// One picture of a run.
struct FrameTask {
  int index = 0;  // 0, 1, 2… in this run
  int count = 1;  // of frames in this run
  std::optional<Animation> animation;
  int number = 0;  // in the animation; 0 for a still picture
  double clock = 0;
  bool clock_on = false;
};

/// What a run does to the world, so that tests can watch it.
struct SequenceActions {
  std::function<int(const FrameTask&)> render;  // returns an exit code
  std::function<int(const std::string&)> shell;
  std::function<ShellNames(const FrameTask&)> names;
};

/// The frame at `index`; a still picture has one.
[[nodiscard]] FrameTask frame_task(const Settings& settings, int index);

/// Renders all frames; the first that fails or is interrupted ends the run. Returns the exit code.
[[nodiscard]] int run_sequence(const Settings& settings, const SequenceActions& actions);

}  // namespace durer::cli

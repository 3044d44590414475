// What a run may take, and what a scene of a stranger may not do.
#pragma once

#include <cstdint>

#include "cli/options.h"
#include "interpreter/interpret.h"

namespace durer::cli {

/// 0: no limit.
struct RunLimits {
  interpreter::Limits reading;  // of each frame's scene
  double render_seconds = 0;    // of each frame
  double pixels = 0;
  int frames = 0;
};

/// The limits that were given, else those of untrusted or trusted runs.
[[nodiscard]] RunLimits limits_of(const Settings& settings);

/// In an untrusted run: names a setting that must not be there at all (a shell command), or that
/// only the command line may make (what is written, where is read, how much).
[[nodiscard]] Problem check_untrusted(const Settings& settings);

/// Says which limit the size of the picture or the number of frames exceeds.
[[nodiscard]] Problem check_extent(const Settings& settings);

}  // namespace durer::cli

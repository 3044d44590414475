// Where the picture goes (language §9.5).
#pragma once

#include <optional>
#include <string>

#include "cli/settings.h"

namespace durer::cli {

struct Output {
  std::string path;  // "-": standard output; empty: nothing is written
  const image::Format* format = nullptr;
};

/// The number that goes into the name of a frame of an animation.
struct FrameNumber {
  int number = 0;
  int digits = 1;  // zeros in front make it this long
};

/// The name and type of the picture. With a type given, POV-Ray's rule: `+Oout.jpg +FN` gives
/// out.jpg.png. Without one, the extension of a given name decides: `+Oout.jpg` gives out.jpg.
/// The number of a frame stands before the extension: out07.jpg.
[[nodiscard]] Output output_of(const Settings& settings,
                               const std::optional<FrameNumber>& frame = std::nullopt);

/// The scene's name without folder and extension; "stdin" for standard input.
[[nodiscard]] std::string scene_stem(const Settings& settings);

}  // namespace durer::cli

// Where the picture goes (language §9.5).
#pragma once

#include <string>

#include "cli/settings.h"

namespace durer::cli {

struct Output {
  std::string path;  // "-": standard output; empty: nothing is written
  const image::Format* format = nullptr;
};

/// The name and type of the picture. With a type given, POV-Ray's rule: `+Oout.jpg +FN` gives
/// out.jpg.png. Without one, the extension of a given name decides: `+Oout.jpg` gives out.jpg.
[[nodiscard]] Output output_of(const Settings& settings);

}  // namespace durer::cli

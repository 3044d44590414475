// The part of the picture that is rendered (language §9.4).
#pragma once

#include <optional>
#include <string>

#include "cli/settings.h"

namespace durer::cli {

/// 0-based, end exclusive.
struct Window {
  int first_column = 0;
  int end_column = 0;
  int first_row = 0;
  int end_row = 0;
};

/// Start below 1 and end up to 1 are fractions of the size, larger values are pixel numbers that
/// count from 1; so `End_Column=1` is the whole width. `problem` tells what lies outside.
[[nodiscard]] std::optional<Window> window_of(const Settings& settings, std::string& problem);

/// Makes everything outside the window opaque black, as the oracle does (with alpha too).
void blacken_outside(image::Image& image, const Window& window);

}  // namespace durer::cli

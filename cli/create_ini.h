// `Create_Ini`: the settings of a run as an INI file that repeats it.
#pragma once

#include <optional>
#include <string>

#include "cli/settings.h"

namespace durer::cli {

/// All settings that were given: of those that replace each other the last, of those that add up
/// (Library_Path, Declare) every one.
[[nodiscard]] std::string ini_text(const Settings& settings);

/// Writes it where `settings.create_ini` says, if it does; returns what went wrong.
[[nodiscard]] std::optional<std::string> create_ini(const Settings& settings);

}  // namespace durer::cli

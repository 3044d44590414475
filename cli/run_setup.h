// What all commands that take options begin with.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/settings.h"

namespace durer::cli {

/// Settings and console of a run. `exit` is set when there is nothing more to do: an error, or
/// help.
struct RunSetup {
  Settings settings;
  std::unique_ptr<Console> console;
  std::optional<int> exit;
};

/// Reads the default INI file and the words of the command line, and checks them as a whole. What
/// is wrong has been printed.
[[nodiscard]] RunSetup set_up(const std::vector<std::string>& words);

}  // namespace durer::cli

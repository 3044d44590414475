// --help and --version, from the table of options.
#pragma once

#include <string>

namespace durer::cli {

[[nodiscard]] std::string version_text();
[[nodiscard]] std::string help_text();
/// docs/command-line.md.
[[nodiscard]] std::string help_markdown();

}  // namespace durer::cli

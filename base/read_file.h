// Whole files as strings.
#pragma once

#include <optional>
#include <string>

namespace durer {

/// The bytes of a file, pipe or device; none if it cannot be read.
[[nodiscard]] std::optional<std::string> read_file(const std::string& path);

}  // namespace durer

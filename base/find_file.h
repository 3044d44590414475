// Files by names that were written on another system.
#pragma once

#include <filesystem>

namespace durer {

/// The file `name` below `folder` (empty: the working folder) in any letter case, with backslashes
/// taken for slashes. Of several spellings the first by name, so that every machine finds the same
/// one; the exact spelling of each part wins. Empty if there is none.
[[nodiscard]] std::filesystem::path find_any_case(const std::filesystem::path& folder,
                                                  const std::string& name);

}  // namespace durer

// Files by names that were written on another system, in folders that are searched in order.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace durer {

/// The file `name` below `folder` (empty: the working folder) in any letter case, with backslashes
/// taken for slashes. Of several spellings the first by name, so that every machine finds the same
/// one; the exact spelling of each part wins. Empty if there is none.
[[nodiscard]] std::filesystem::path find_any_case(const std::filesystem::path& folder,
                                                  const std::string& name);

/// True for files, pipes and devices: whatever can be opened and read.
[[nodiscard]] bool is_readable_file(const std::filesystem::path& path);

struct FoundFile {
  std::filesystem::path path;
  bool other_spelling = false;  // letter case or kind of slash differ from the name asked for
};

/// The first of `names` that is a file, each looked for in all `folders` before the next; absolute
/// names are taken as they are. If none is spelled so, `tolerant` tries other spellings
/// (find_any_case). Files that `accepts` refuses count as absent.
[[nodiscard]] std::optional<FoundFile> find_file(
    std::span<const std::string> names, std::span<const std::filesystem::path> folders,
    bool tolerant,
    const std::function<bool(const std::filesystem::path&)>& accepts = is_readable_file);

/// `path` with `..` and symbolic links resolved as far as it exists.
[[nodiscard]] std::filesystem::path resolved(const std::filesystem::path& path);

/// True if `path` lies in `folder` or below it, both resolved.
[[nodiscard]] bool lies_below(const std::filesystem::path& path,
                              const std::filesystem::path& folder);

/// The name in any of `folders` that is nearest to `name`, which is not there; empty if none is
/// near.
[[nodiscard]] std::string nearest_file_name(const std::string& name,
                                            std::span<const std::filesystem::path> folders);

}  // namespace durer

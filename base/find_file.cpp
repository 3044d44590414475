#include "base/find_file.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "base/suggest.h"

namespace durer {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string s) {
  std::ranges::transform(s, s.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

/// The entry of `folder` that is spelled like `part` but for letter case.
fs::path entry_like(const fs::path& folder, const fs::path& part) {
  const std::string wanted = lower(part.string());
  fs::path best;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (lower(entry.path().filename().string()) != wanted) continue;
    if (best.empty() || entry.path() < best) best = entry.path();
  }
  return best;
}

}  // namespace

fs::path find_any_case(const fs::path& folder, const std::string& name) {
  std::string slashed = name;
  std::ranges::replace(slashed, '\\', '/');
  fs::path found = slashed.starts_with('/') ? fs::path() : folder.empty() ? fs::path(".") : folder;
  std::error_code error;
  for (const fs::path& part : fs::path(slashed)) {
    if (fs::exists(found / part, error)) {
      found /= part;
      continue;
    }
    found = entry_like(found, part);
    if (found.empty()) return {};
  }
  return is_readable_file(found) ? found.lexically_normal() : fs::path();
}

bool is_readable_file(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

std::optional<FoundFile> find_file(std::span<const std::string> names,
                                   std::span<const fs::path> folders, bool tolerant,
                                   const std::function<bool(const fs::path&)>& accepts) {
  for (const std::string& name : names) {
    for (const fs::path& folder : folders) {
      // An absolute name replaces the folder.
      const fs::path path = folder / name;
      if (is_readable_file(path) && accepts(path)) return FoundFile{path, false};
    }
  }
  if (!tolerant) return std::nullopt;
  for (const std::string& name : names) {
    for (const fs::path& folder : folders) {
      const fs::path path = find_any_case(folder, name);
      if (!path.empty() && accepts(path)) return FoundFile{path, true};
    }
  }
  return std::nullopt;
}

fs::path resolved(const fs::path& path) {
  std::error_code error;
  fs::path absolute = fs::absolute(path.empty() ? fs::path(".") : path, error);
  fs::path real = fs::weakly_canonical(absolute, error);
  return error ? absolute.lexically_normal() : real;
}

bool lies_below(const fs::path& path, const fs::path& folder) {
  const fs::path inner = resolved(path);
  fs::path outer = resolved(folder);
  if (!outer.has_filename()) outer = outer.parent_path();  // "a/b/" is "a/b"
  const auto [end, rest] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  (void)rest;
  return end == outer.end();
}

std::string nearest_file_name(const std::string& name, std::span<const fs::path> folders) {
  const fs::path wanted(name);
  std::vector<std::string> names;
  for (const fs::path& folder : folders) {
    const fs::path place = folder / wanted.parent_path();
    std::error_code error;
    for (const auto& entry :
         fs::directory_iterator(place.empty() ? fs::path(".") : place, error)) {
      if (is_readable_file(entry.path())) names.push_back(entry.path().filename().string());
    }
  }
  std::ranges::sort(names);  // so that every machine suggests the same one
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto near = closest(wanted.filename().string(), views);
  return near ? (wanted.parent_path() / *near).string() : std::string();
}

}  // namespace durer

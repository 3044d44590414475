#include "base/find_file.h"

#include <algorithm>
#include <cctype>
#include <string>

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
  return fs::is_regular_file(found, error) ? found.lexically_normal() : fs::path();
}

}  // namespace durer

#include "cli/create_ini.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace durer::cli {
namespace {

std::string quoted(const std::string& value) {
  if (value.find_first_of(" \t;#'\"") == std::string::npos && !value.empty()) return value;
  const char quote = value.find('"') == std::string::npos ? '"' : '\'';
  return quote + value + quote;
}

bool adds_up(std::string_view keyword) { return keyword == "Library_Path" || keyword == "Declare"; }

}  // namespace

std::string ini_text(const Settings& settings) {
  std::string out;
  const auto& all = settings.history;
  for (auto it = all.begin(); it != all.end(); ++it) {
    const auto same = [&](const auto& later) { return later.first == it->first; };
    if (it->first == "Create_Ini") continue;
    if (!adds_up(it->first) && std::any_of(it + 1, all.end(), same)) continue;
    out += fmt::format("{}={}\n", it->first, quoted(it->second));
  }
  return out;
}

std::optional<std::string> create_ini(const Settings& settings) {
  if (settings.create_ini.empty()) return std::nullopt;
  std::ofstream out(settings.create_ini);
  out << ini_text(settings);
  out.close();
  if (out) return std::nullopt;
  return fmt::format("cannot write `{}`: {}", settings.create_ini, std::strerror(errno));
}

}  // namespace durer::cli

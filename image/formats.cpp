// The table of formats, and how they are found.
#include <algorithm>
#include <array>
#include <cctype>

#include "image/image.h"

namespace durer::image {

#define DURER_ENTRY(name) extern const Format name##_format;
#include "image/formats.def"
#undef DURER_ENTRY

namespace {

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// True if `word` ("jpeg", without a dot) is an extension of the format.
bool is_extension(const Format& format, std::string_view word) {
  if (same_word(format.extension.substr(1), word)) return true;
  std::string_view list = format.spellings;  // ".jpeg .jpe"
  while (!list.empty()) {
    const std::size_t blank = list.find(' ');
    if (same_word(list.substr(0, blank).substr(1), word)) return true;
    list = blank == std::string_view::npos ? std::string_view() : list.substr(blank + 1);
  }
  return false;
}

template <typename Matches>
const Format* find_format(const Matches& matches) {
  const auto all = formats();
  const auto found = std::ranges::find_if(all, [&](const Format* f) { return matches(*f); });
  return found == all.end() ? nullptr : *found;
}

}  // namespace

std::span<const Format* const> formats() {
  static constexpr std::array table = {
#define DURER_ENTRY(name) &name##_format,
#include "image/formats.def"
#undef DURER_ENTRY
  };
  return table;
}

const Format* format_of(std::string_view path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string_view::npos || path[dot] == '/') return nullptr;
  return find_format([&](const Format& f) { return is_extension(f, path.substr(dot + 1)); });
}

const Format* format_named(std::string_view name) {
  if (name.size() == 1) {
    return find_format([&](const Format& f) {
      return f.letter != 0 && same_word({&f.letter, 1}, name);
    });
  }
  return find_format(
      [&](const Format& f) { return same_word(f.name, name) || is_extension(f, name); });
}

}  // namespace durer::image

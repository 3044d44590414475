#include "cli/values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace durer::cli {
namespace {

char lower_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

constexpr std::string_view blanks = " \t\r\n\f\v";

}  // namespace

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), lower_letter);
  return out;
}

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, lower_letter, lower_letter);
}

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view unquote(std::string_view text) {
  const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
                      text.back() == text.front();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

std::optional<bool> parse_bool(std::string_view text) {
  static constexpr std::array<std::string_view, 5> yes = {"on", "true", "yes", "y", "1"};
  static constexpr std::array<std::string_view, 5> no = {"off", "false", "no", "n", "0"};
  const auto is_text = [&](std::string_view word) { return same_word(word, text); };
  if (std::ranges::any_of(yes, is_text)) return true;
  if (std::ranges::any_of(no, is_text)) return false;
  return std::nullopt;
}

std::optional<int> parse_int(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> parse_number(std::string_view text) {
  const std::string copy(text);  // strtod wants a terminator
  if (copy.empty() || blanks.find(copy.front()) != std::string_view::npos) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(copy.c_str(), &end);
  if (end != copy.c_str() + copy.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<Size> parse_size(std::string_view text) {
  const std::size_t cross = text.find_first_of("xX");
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = parse_int(text.substr(0, cross));
  const auto height = parse_int(text.substr(cross + 1));
  if (!width || !height) return std::nullopt;
  return Size{*width, *height};
}

std::optional<GammaCurve> parse_gamma(std::string_view text) {
  if (same_word(text, "srgb")) return GammaCurve::srgb();
  const auto number = parse_number(text);
  if (!number || *number <= 0) return std::nullopt;
  return GammaCurve::power(static_cast<float>(*number));
}

}  // namespace durer::cli

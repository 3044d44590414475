#include "interpreter/text.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <type_traits>

namespace durer::interpreter {
namespace {

/// Flips the case of the letters from `first_letter` on, without a branch, so that it is done many
/// codes at a time.
template <typename String>
void flip_case(String& s, std::size_t first, char first_letter) {
  using Code = std::make_unsigned_t<typename String::value_type>;
  constexpr unsigned letters = 26;
  constexpr unsigned case_bit = 'a' ^ 'A';
  auto* const codes = s.data();
  const std::size_t size = s.size();
  for (std::size_t i = first; i < size; ++i) {
    const auto code = static_cast<Code>(codes[i]);
    const auto place = static_cast<Code>(code - static_cast<Code>(first_letter));
    codes[i] = static_cast<typename String::value_type>(code ^ (place < letters ? case_bit : 0U));
  }
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

void Text::widen() {
  wide_.reserve(narrow_.size() + 16);
  for (const char c : narrow_) wide_ += static_cast<unsigned char>(c);
  narrow_.clear();
}

void Text::append(char16_t code) {
  if (wide_.empty()) {
    if (code < 256) {
      narrow_ += static_cast<char>(code);
      return;
    }
    widen();
  }
  wide_ += code;
}

void Text::append_wide(const Text& other, std::size_t first, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) append(other[first + i]);
}

void Text::erase(std::size_t first, std::size_t end) {
  if (wide_.empty()) {
    narrow_.erase(first, end - first);
    return;
  }
  wide_.erase(first, end - first);
}

void Text::to_upper(std::size_t first) {
  flip_case(narrow_, first, 'a');
  flip_case(wide_, first, 'a');
}

void Text::to_lower(std::size_t first) {
  flip_case(narrow_, first, 'A');
  flip_case(wide_, first, 'A');
}

int Text::difference(const Text& other) const {
  std::size_t i = 0;
  const std::size_t both = std::min(size(), other.size());
  while (i < both && (*this)[i] == other[i]) ++i;
  const int a = i < size() ? (*this)[i] : 0;
  const int b = i < other.size() ? other[i] : 0;
  return a - b;
}

std::strong_ordering operator<=>(const Text& a, const Text& b) {
  if (a.wide_.empty() && b.wide_.empty()) return a.narrow_.compare(b.narrow_) <=> 0;
  const std::size_t both = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (a[i] != b[i]) return a[i] <=> b[i];
  }
  return a.size() <=> b.size();
}

double Text::leading_number() const {
  // Plain digits, as nearly always; everything else that atof knows is left to it.
  if (wide_.empty() && !narrow_.empty() && (narrow_[0] == '.' || is_digit(narrow_[0]))) {
    const char* const end = narrow_.data() + narrow_.size();
    double x = 0;
    const auto read = std::from_chars(narrow_.data(), end, x);
    const bool hexadecimal = read.ptr != end && (*read.ptr == 'x' || *read.ptr == 'X');
    if (read.ec == std::errc() && !hexadecimal) return x;
  }
  return std::strtod(bytes().c_str(), nullptr);
}

std::string Text::bytes() const {
  std::string s;
  s.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) {
    s += (*this)[i] > 127 ? ' ' : static_cast<char>((*this)[i]);
  }
  return s;
}

}  // namespace durer::interpreter

// Strings of the language: 16-bit codes (language §1.4).
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>

namespace durer::interpreter {

/// Nearly every string holds codes below 256 only: those take a byte each, until a higher one
/// comes.
class Text {
 public:
  Text() = default;
  /// One code per byte, 0…255.
  explicit Text(std::string_view codes) : narrow_(codes) {}

  [[nodiscard]] std::size_t size() const { return wide_.empty() ? narrow_.size() : wide_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] char16_t operator[](std::size_t i) const {
    return wide_.empty() ? static_cast<unsigned char>(narrow_[i]) : wide_[i];
  }

  void append(char16_t code);
  /// One code per byte, 0…255.
  void append(std::string_view codes) {
    if (wide_.empty()) {
      narrow_.append(codes.data(), codes.size());
      return;
    }
    for (const char c : codes) wide_ += static_cast<unsigned char>(c);
  }
  void append(const Text& other) {
    if (wide_.empty() && other.wide_.empty()) {
      narrow_.append(other.narrow_.data(), other.narrow_.size());
      return;
    }
    append_wide(other, 0, other.size());
  }
  /// `count` codes of `other` from `first` on; they must be there. `other` may be this text.
  void append(const Text& other, std::size_t first, std::size_t count) {
    if (wide_.empty() && other.wide_.empty()) {
      narrow_.append(other.narrow_.data() + first, count);
      return;
    }
    append_wide(other, first, count);
  }
  void clear() {
    narrow_.clear();
    if (!wide_.empty()) wide_.clear();
  }
  void swap(Text& other) {
    narrow_.swap(other.narrow_);
    if (!wide_.empty() || !other.wide_.empty()) wide_.swap(other.wide_);
  }
  /// The same as `=`, in the memory that this text has already.
  void assign(const Text& other) {
    if (this == &other) return;
    clear();
    append(other);
  }
  /// Keeps `count` codes from `first` on; they must be there.
  void keep(std::size_t first, std::size_t count) {
    erase(first + count, size());
    erase(0, first);
  }
  /// Removes the codes from `first` to before `end`.
  void erase(std::size_t first, std::size_t end);
  /// Maps the ASCII letters from `first` on.
  void to_upper(std::size_t first);
  void to_lower(std::size_t first);

  /// Code by code, as unsigned numbers; a shorter text comes first.
  friend std::strong_ordering operator<=>(const Text& a, const Text& b);
  friend bool operator==(const Text& a, const Text& b) { return (a <=> b) == 0; }
  /// The difference of the first codes that differ, where the end counts 0 (`strcmp`).
  [[nodiscard]] int difference(const Text& other) const;

  /// The longest number at the beginning, as C's atof reads it; 0 if there is none.
  [[nodiscard]] double leading_number() const;
  /// Codes above 127 become spaces, as in every message of the language.
  [[nodiscard]] std::string bytes() const;

 private:
  void widen();
  void append_wide(const Text& other, std::size_t first, std::size_t count);
  std::string narrow_;
  std::u16string wide_;  // if not empty, everything; then narrow_ is empty
};

/// Lengths of numbers as text: of what `str` makes, and of a component in `vstr`, where the oracle
/// breaks down at some greater length.
inline constexpr std::size_t longest_number = 254;
inline constexpr std::size_t longest_component = 1000;

/// Appends what `str` makes of a number: C's printf with `decimals` places (< 0 means 6), padded to
/// `width` with blanks, or with zeros if it is negative. What is longer than `longest` is printed with
/// `g` instead of `f`, and is invalid if that is too long as well (language §3.5).
void append_number(double value, int width, int decimals, Text& out,
                   std::size_t longest = longest_number);

}  // namespace durer::interpreter

// The text formats among mesh files: words and numbers, line by line.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/mesh_files/mesh_file.h"

namespace durer::interpreter {

/// Takes a text apart, and knows the number of the line for messages.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : text_(text) {}

  /// Goes on to the next line that has a word; false at the end. Lines that end in `\` go on.
  bool next_line() {
    while (at_ < text_.size()) {
      if (started_) skip_line();
      started_ = true;
      if (!at_line_end()) return true;
    }
    return false;
  }
  /// True if no word follows in this line.
  bool at_line_end() {
    for (;;) {
      while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
      if (at_ >= text_.size()) return true;
      if (text_[at_] == '\\' && text_.find_first_not_of("\r", at_ + 1) != std::string_view::npos &&
          text_[text_.find_first_not_of("\r", at_ + 1)] == '\n') {
        at_ = text_.find('\n', at_) + 1;
        ++line_;
        continue;
      }
      return text_[at_] == '\n' || text_[at_] == '#';
    }
  }
  /// The next word of this line; empty if there is none.
  std::string_view word() {
    if (at_line_end()) return {};
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n') ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// What is left of this line, without blanks around it.
  std::string_view rest() {
    if (at_line_end()) return {};
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    at_ = end;
    return line;
  }
  float number() {
    const std::string_view w = word();
    return to_number(w);
  }
  float to_number(std::string_view w) {
    const char* begin = w.data() + (!w.empty() && w.front() == '+' ? 1 : 0);
    double x = 0;  // what a float cannot hold becomes 0 or infinite
    const auto [end, error] = std::from_chars(begin, w.data() + w.size(), x);
    if (w.empty() || (error != std::errc{} && error != std::errc::result_out_of_range) ||
        end != w.data() + w.size()) {
      fail(w.empty() ? "a number is missing" : fmt::format("`{}` is no number", shown(w)));
    }
    return static_cast<float>(x);
  }
  vec3 vector() {
    const float x = number();
    const float y = number();
    return {x, y, number()};
  }
  [[nodiscard]] std::size_t offset() const { return at_; }
  [[noreturn]] void fail(std::string_view what) const {
    throw MeshFileError{fmt::format("line {}: {}", line_, what)};
  }
  static std::string_view shown(std::string_view w) { return w.substr(0, 40); }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  void skip_line() {
    at_ = std::min(text_.find('\n', at_), text_.size());
    if (at_ < text_.size()) ++at_;
    ++line_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  bool started_ = false;
};

}  // namespace durer::interpreter

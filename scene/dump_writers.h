// Two ways to write a tree of named values: for people and for programs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace durer::scene {

/// Collects text and passes it on in larger pieces.
class DumpSink {
 public:
  explicit DumpSink(const std::function<void(std::string_view)>& write) : write_(write) {}
  DumpSink(const DumpSink&) = delete;
  DumpSink& operator=(const DumpSink&) = delete;
  ~DumpSink() { flush(); }
  void put(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() > 65536) flush();
  }

 private:
  void flush() {
    if (!buffer_.empty()) write_(buffer_);
    buffer_.clear();
  }
  const std::function<void(std::string_view)>& write_;
  std::string buffer_;
};

/// {"name": value, …}. Members are called with names, elements of lists with empty names.
class JsonWriter {
 public:
  static constexpr bool writes_defaults = true;
  /// JSON has no infinity: such numbers are strings.
  static std::string special(const std::string& number) { return '"' + number + '"'; }
  explicit JsonWriter(DumpSink& sink) : sink_(sink) {}

  void number(std::string_view name, std::string_view text) { element(name, text); }
  void word(std::string_view name, std::string_view text);
  void nothing(std::string_view name) { element(name, "null"); }
  void numbers(std::string_view name, const std::vector<std::string>& texts);
  void open_struct(std::string_view name) { open(name, '{'); }
  void close_struct() { close('}'); }
  void open_list(std::string_view name) { open(name, '['); }
  void close_list() { close(']'); }

 private:
  void element(std::string_view name, std::string_view text);
  void open(std::string_view name, char bracket);
  void close(char bracket);

  DumpSink& sink_;
  std::vector<bool> has_elements_;
};

/// Lines of `name value`, indented by two blanks for each struct or list around them. Elements of
/// lists are called by their index.
class TextWriter {
 public:
  static constexpr bool writes_defaults = false;
  static std::string special(const std::string& number) { return number; }
  explicit TextWriter(DumpSink& sink) : sink_(sink) {}

  void number(std::string_view name, std::string_view text) { line(name, text); }
  void word(std::string_view name, std::string_view text) { line(name, text); }
  void nothing(std::string_view name) { line(name, "-"); }
  void numbers(std::string_view name, const std::vector<std::string>& texts);
  void open_struct(std::string_view name) { open(name); }
  void close_struct() { indices_.pop_back(); }
  void open_list(std::string_view name) { open(name); }
  void close_list() { indices_.pop_back(); }

 private:
  void line(std::string_view name, std::string_view text);
  void open(std::string_view name);

  DumpSink& sink_;
  std::vector<std::uint64_t> indices_;  // of the next element, for each level
};

}  // namespace durer::scene

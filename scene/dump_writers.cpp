#include "scene/dump_writers.h"

#include <fmt/format.h>

namespace durer::scene {
namespace {

/// Length of the UTF-8 sequence at the start of `text`, 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t size = byte(0) < 0x80                      ? 1
                           : byte(0) >= 0xC2 && byte(0) < 0xE0 ? 2
                           : byte(0) >= 0xE0 && byte(0) < 0xF0 ? 3
                           : byte(0) >= 0xF0 && byte(0) < 0xF5 ? 4
                                                               : 0;
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  return size;
}

/// A JSON string; bytes that are not UTF-8 become U+FFFD.
std::string quoted(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const std::size_t size = utf8_length(text);
    const char c = text.front();
    if (size == 0) {
      out += "\xEF\xBF\xBD";
    } else if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (static_cast<unsigned char>(c) < ' ') {
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      out += text.substr(0, size);
    }
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return out + '"';
}

std::string joined(const std::vector<std::string>& texts, std::string_view before,
                   std::string_view after) {
  return fmt::format("{}{}{}", before, fmt::join(texts, ", "), after);
}

}  // namespace

void JsonWriter::element(std::string_view name, std::string_view text) {
  if (!has_elements_.empty()) {
    sink_.put(has_elements_.back() ? ",\n" : "\n");
    has_elements_.back() = true;
    sink_.put(std::string(has_elements_.size(), ' '));
  }
  if (!name.empty()) sink_.put(quoted(name) + ": ");
  sink_.put(text);
}

void JsonWriter::word(std::string_view name, std::string_view text) { element(name, quoted(text)); }

void JsonWriter::numbers(std::string_view name, const std::vector<std::string>& texts) {
  element(name, joined(texts, "[", "]"));
}

void JsonWriter::open(std::string_view name, char bracket) {
  element(name, std::string_view(&bracket, 1));
  has_elements_.push_back(false);
}

void JsonWriter::close(char bracket) {
  const bool broken = has_elements_.back();
  has_elements_.pop_back();
  if (broken) sink_.put("\n" + std::string(has_elements_.size(), ' '));
  sink_.put(std::string_view(&bracket, 1));
  if (has_elements_.empty()) sink_.put("\n");
}

void TextWriter::line(std::string_view name, std::string_view text) {
  sink_.put(std::string(indices_.empty() ? 0 : 2 * (indices_.size() - 1), ' '));
  if (name.empty()) {
    sink_.put(std::to_string(indices_.back()++));
  } else {
    sink_.put(name);
  }
  if (!text.empty()) sink_.put(" ");
  sink_.put(text);
  sink_.put("\n");
}

void TextWriter::numbers(std::string_view name, const std::vector<std::string>& texts) {
  line(name, joined(texts, "<", ">"));
}

void TextWriter::open(std::string_view name) {
  if (!indices_.empty()) line(name, "");
  indices_.push_back(0);
}

}  // namespace durer::scene

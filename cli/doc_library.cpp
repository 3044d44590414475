// Docstrings of the standard library (see stdlib/README.md for their form).
#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "cli/doc.h"
#include "cli/scene_file.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_lines = 40;  // of a declaration's source; the wood maps are longer

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
  while (!s.empty() && (s.back() == ' ' || s.back() == '\r')) s.remove_suffix(1);
  return s;
}

bool letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string_view first_word(std::string_view s) {
  return s.substr(0, static_cast<std::size_t>(std::find_if_not(s.begin(), s.end(), letter) - s.begin()));
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kinds = {{
    {"rgb", "colour"},          {"rgbf", "colour"},         {"rgbt", "colour"},
    {"rgbft", "colour"},        {"texture", "texture"},     {"pigment", "pigment"},
    {"finish", "finish"},       {"normal", "normal"},       {"interior", "interior"},
    {"material", "material"},   {"color_map", "colour map"}, {"sky_sphere", "sky sphere"},
    {"function", "function"},   {"camera", "camera"},
}};

/// What kind of thing a value is, by how it begins.
std::string kind_of(std::string_view value) {
  value = trimmed(value);
  const std::string_view word = first_word(value);
  for (const auto& [start, kind] : kinds) {
    if (word == start) return std::string(kind);
  }
  if (word == "array" || word == "seed" || word == "transform") return std::string(word);
  value = trimmed(value.substr(0, value.find("//")));
  if (value.ends_with('{')) return "object";
  if (value.ends_with(';')) return value.starts_with('<') ? "vector" : "number";
  return "object";
}

class Reader {
 public:
  Reader(std::string file, std::string_view text, std::vector<DocEntry>& entries)
      : file_(std::move(file)), lines_(lines_of(text)), entries_(entries) {}

  void read() {
    read_head();
    for (; at_ < lines_.size(); ++at_) {
      const std::string_view line = lines_[at_];
      if (line.starts_with("///")) {
        doc_.emplace_back(trimmed(line.substr(3)));
      } else if (line.starts_with("#macro ")) {
        read_macro(line.substr(7));
      } else if (line.starts_with("#declare ")) {
        read_declaration(line.substr(9));
      } else {
        doc_.clear();
      }
    }
  }

 private:
  /// The docstring that a file begins with is about the file.
  void read_head() {
    for (; at_ < lines_.size() && lines_[at_].starts_with("///"); ++at_) {
      doc_.emplace_back(trimmed(lines_[at_].substr(3)));
    }
    entries_.push_back({file_, "include", file_, "#include \"" + file_ + "\"", std::move(doc_), {}});
    doc_.clear();
  }

  void read_macro(std::string_view rest) {
    if (!doc_.empty()) {
      std::string usage(rest.substr(0, rest.find(')')));
      entries_.push_back({std::string(first_word(rest)), "macro", file_, usage + ")", doc_, {}});
    }
    doc_.clear();
  }

  void read_declaration(std::string_view rest) {
    if (rest.starts_with("deprecated ") && at_ + 1 < lines_.size()) {
      rest = trimmed(lines_[++at_]);
      doc_.emplace_back("Of old: its first use warns.");
    }
    const std::size_t equals = rest.find('=');
    const std::string name(first_word(rest));
    if (equals == std::string_view::npos) return doc_.clear();
    const std::string_view value = trimmed(rest.substr(equals + 1));
    if (value == "version;") return doc_.clear();  // a guard
    DocEntry entry{name, kind_of(value), file_, name, std::move(doc_), std::string(value)};
    doc_.clear();
    append_rest(entry.value);
    entries_.push_back(std::move(entry));
  }

  /// Lines that go on with a declaration: all until the next one, or an empty one.
  void append_rest(std::string& value) {
    for (std::size_t n = 1; at_ + 1 < lines_.size(); ++n) {
      const std::string_view next = lines_[at_ + 1];
      if (next.empty() || next.starts_with('#') || next.starts_with("//")) return;
      ++at_;
      if (n < most_lines) value.append("\n").append(next);
      if (n == most_lines) value.append("\n  …");
    }
  }

  std::string file_;
  std::vector<std::string_view> lines_;
  std::vector<DocEntry>& entries_;
  std::vector<std::string> doc_;
  std::size_t at_ = 0;
};

}  // namespace

void read_library_docs(const std::string& file, const std::string& text,
                       std::vector<DocEntry>& entries) {
  Reader(file, text, entries).read();
}

std::vector<DocEntry> library_docs(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& item : fs::directory_iterator(folder, ignored)) {
    const fs::path extension = item.path().extension();
    if (extension == ".inc" || extension == ".map") files.push_back(item.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<DocEntry> entries;
  for (const fs::path& file : files) {
    if (const auto text = read_file(file.string())) {
      read_library_docs(file.filename().string(), *text, entries);
    }
  }
  return entries;
}

}  // namespace durer::cli

// Where text comes from. All files of a run form one virtual text, so that a place in any file is
// one 32-bit number; file, line and column exist only when something is printed.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace durer {

/// Offset in the virtual text. 0 is "nowhere".
using Loc = std::uint32_t;

struct Span {
  Loc begin = 0;
  std::uint32_t size = 0;

  [[nodiscard]] Loc end() const { return begin + size; }
  /// The smallest span that covers both; a span at `nowhere` does not count.
  [[nodiscard]] Span to(Span last) const {
    if (begin == 0) return last;
    if (last.begin == 0) return *this;
    return {begin, last.end() - begin};
  }
  friend bool operator==(const Span&, const Span&) = default;
};

using FileId = std::uint32_t;

/// Place for people: 1-based line and column (in bytes).
struct Place {
  std::string_view path;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// Owns the text of every file read in a run. Texts never move, so views stay valid.
class SourceMap {
 public:
  /// Adds a file and returns its id. Fails (assert) beyond 4 GiB of text in all.
  FileId add(std::string path, std::string text);

  [[nodiscard]] std::string_view path(FileId file) const { return files_[file].path; }
  [[nodiscard]] std::string_view text(FileId file) const { return files_[file].text; }
  /// Offset of the first byte of `file` in the virtual text.
  [[nodiscard]] Loc base(FileId file) const { return files_[file].base; }
  [[nodiscard]] std::size_t size() const { return files_.size(); }

  [[nodiscard]] FileId file_of(Loc loc) const;
  /// "nowhere" gives an empty path and line 0.
  [[nodiscard]] Place place(Loc loc) const;
  [[nodiscard]] std::string_view text(Span span) const;
  /// The whole line that holds `loc`, without its line break.
  [[nodiscard]] std::string_view line_at(Loc loc) const;

 private:
  struct File {
    std::string path;
    std::string text;
    Loc base;
  };
  std::deque<File> files_;  // a deque: texts must not move
  Loc next_ = 1;
};

}  // namespace durer

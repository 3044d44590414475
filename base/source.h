// Where text comes from. All files of a run form one virtual text, so that a place in any file is
// one 32-bit number; file, line and column exist only when something is printed.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

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

/// Owns the text of every file read in a run. Texts never move, so views stay valid until `rest`.
class SourceMap {
 public:
  /// Adds a file and returns its id. Fails (assert) beyond 4 GiB of text in all.
  FileId add(std::string path, std::string text);

  [[nodiscard]] std::string_view path(FileId file) const { return files_[file].path; }
  [[nodiscard]] std::string_view text(FileId file) const { return awake(files_[file]); }
  /// Gives back the memory of texts of at least `least` bytes that can be read again from their
  /// files: only a message would still need them. Ends all views of texts.
  void rest(std::size_t least);
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
    mutable std::string text;
    Loc base;
    std::size_t size;
    mutable bool rests = false;
    std::vector<std::uint32_t> lines;  // offsets of the line breaks, once it has rested
  };
  [[nodiscard]] const std::string& awake(const File& file) const;
  std::deque<File> files_;  // a deque: texts must not move
  mutable std::mutex waking_;
  Loc next_ = 1;
};

}  // namespace durer

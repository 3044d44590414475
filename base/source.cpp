#include "base/source.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace durer {

FileId SourceMap::add(std::string path, std::string text) {
  assert(text.size() < std::numeric_limits<Loc>::max() - next_ - 1);
  files_.push_back({std::move(path), std::move(text), next_});
  // One extra position per file, so that "end of file" is a place of its own.
  next_ += static_cast<Loc>(files_.back().text.size()) + 1;
  return static_cast<FileId>(files_.size() - 1);
}

FileId SourceMap::file_of(Loc loc) const {
  const auto after = std::upper_bound(files_.begin(), files_.end(), loc,
                                      [](Loc l, const File& f) { return l < f.base; });
  return after == files_.begin() ? 0 : static_cast<FileId>(after - files_.begin() - 1);
}

Place SourceMap::place(Loc loc) const {
  if (loc == 0 || files_.empty()) return {};
  const File& file = files_[file_of(loc)];
  const std::size_t offset = std::min<std::size_t>(loc - file.base, file.text.size());
  const std::string_view before = std::string_view(file.text).substr(0, offset);
  const auto line = static_cast<std::uint32_t>(1 + std::count(before.begin(), before.end(), '\n'));
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {file.path, line, static_cast<std::uint32_t>(offset - line_start + 1)};
}

std::string_view SourceMap::text(Span span) const {
  if (span.begin == 0 || files_.empty()) return {};
  const File& file = files_[file_of(span.begin)];
  const std::size_t offset = std::min<std::size_t>(span.begin - file.base, file.text.size());
  return std::string_view(file.text).substr(offset, span.size);
}

std::string_view SourceMap::line_at(Loc loc) const {
  if (loc == 0 || files_.empty()) return {};
  const File& file = files_[file_of(loc)];
  const std::size_t offset = std::min<std::size_t>(loc - file.base, file.text.size());
  const std::size_t start =
      offset == 0 ? 0 : file.text.rfind('\n', offset - 1) + 1;  // npos + 1 is 0
  std::size_t end = file.text.find('\n', offset);
  if (end == std::string::npos) end = file.text.size();
  if (end > start && file.text[end - 1] == '\r') --end;
  return std::string_view(file.text).substr(start, end - start);
}

}  // namespace durer

#include "base/source.h"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <limits>
#include <optional>

#include "base/read_file.h"

namespace durer {

FileId SourceMap::add(std::string path, std::string text) {
  assert(text.size() < std::numeric_limits<Loc>::max() - next_ - 1);
  const std::size_t size = text.size();
  files_.push_back({std::move(path), std::move(text), next_, size, false, {}});
  // One extra position per file, so that "end of file" is a place of its own.
  next_ += static_cast<Loc>(size) + 1;
  return static_cast<FileId>(files_.size() - 1);
}

void SourceMap::rest(std::size_t least) {
  for (File& file : files_) {
    std::error_code error;
    if (file.rests || file.size < least ||
        !std::filesystem::is_regular_file(std::filesystem::path(file.path), error)) {
      continue;
    }
    if (file.lines.empty()) {
      for (std::size_t i = file.text.find('\n'); i != std::string::npos;
           i = file.text.find('\n', i + 1)) {
        file.lines.push_back(static_cast<std::uint32_t>(i));
      }
    }
    std::string().swap(file.text);  // assigning would keep the memory
    file.rests = true;
  }
}

/// The text; empty if the file has changed since it was given back.
const std::string& SourceMap::awake(const File& file) const {
  const std::lock_guard lock(waking_);
  if (!file.rests) return file.text;
  file.rests = false;
  if (auto text = read_file(file.path); text && text->size() == file.size) {
    file.text = *std::move(text);
  }
  return file.text;
}

FileId SourceMap::file_of(Loc loc) const {
  const auto after = std::upper_bound(files_.begin(), files_.end(), loc,
                                      [](Loc l, const File& f) { return l < f.base; });
  return after == files_.begin() ? 0 : static_cast<FileId>(after - files_.begin() - 1);
}

Place SourceMap::place(Loc loc) const {
  if (loc == 0 || files_.empty()) return {};
  const File& file = files_[file_of(loc)];
  const std::size_t offset = std::min<std::size_t>(loc - file.base, file.size);
  if (!file.lines.empty()) {
    const auto after = std::lower_bound(file.lines.begin(), file.lines.end(), offset);
    const std::size_t start = after == file.lines.begin() ? 0 : *(after - 1) + 1;
    return {file.path, static_cast<std::uint32_t>(after - file.lines.begin() + 1),
            static_cast<std::uint32_t>(offset - start + 1)};
  }
  const std::string_view before = std::string_view(awake(file)).substr(0, offset);
  const auto line = static_cast<std::uint32_t>(1 + std::count(before.begin(), before.end(), '\n'));
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {file.path, line, static_cast<std::uint32_t>(offset - line_start + 1)};
}

std::string_view SourceMap::text(Span span) const {
  if (span.begin == 0 || files_.empty()) return {};
  const File& file = files_[file_of(span.begin)];
  const std::string& text = awake(file);
  const std::size_t offset = std::min<std::size_t>(span.begin - file.base, text.size());
  return std::string_view(text).substr(offset, span.size);
}

std::string_view SourceMap::line_at(Loc loc) const {
  if (loc == 0 || files_.empty()) return {};
  const File& file = files_[file_of(loc)];
  const std::string& text = awake(file);
  const std::size_t offset = std::min<std::size_t>(loc - file.base, text.size());
  const std::size_t start =
      offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;  // npos + 1 is 0
  std::size_t end = text.find('\n', offset);
  if (end == std::string::npos) end = text.size();
  if (end > start && text[end - 1] == '\r') --end;
  return std::string_view(text).substr(start, end - start);
}

}  // namespace durer

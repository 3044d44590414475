// A diagnostic as text, in the look of style §5: claim, place, excerpt with carets, help, notes.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/diagnostic.h"

namespace durer {
namespace {

constexpr std::size_t tab_width = 8;
constexpr std::size_t longest_line = 160;  // columns of an excerpt: a mesh may be one line

// What to write under one line: the main place with `^`, labels with `-`.
struct Mark {
  std::size_t begin = 0;  // columns after tabs have been expanded, 0-based
  std::size_t size = 1;
  bool main = false;
  std::string_view words;
};

struct Palette {
  std::string_view severity, frame, main, label, bold, off;
};

Palette palette_for(Severity severity, bool colour) {
  if (!colour) return {};
  const std::string_view main = severity == Severity::error     ? "\x1b[1;31m"
                                : severity == Severity::warning ? "\x1b[1;33m"
                                                                : "\x1b[1;36m";
  return {main, "\x1b[1;34m", main, "\x1b[1;36m", "\x1b[1m", "\x1b[0m"};
}

std::string_view severity_text(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: return "error";
  }
  return "";
}

// UTF-8 continuation bytes take no column.
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::size_t column_of(std::string_view line, std::size_t bytes) {
  std::size_t column = 0;
  for (const char c : line.substr(0, bytes)) {
    if (c == '\t') {
      column += tab_width - column % tab_width;
    } else if (!continues(c)) {
      ++column;
    }
  }
  return column;
}

std::string expand_tabs(std::string_view line) {
  std::string text;
  std::size_t column = 0;
  for (const char c : line) {
    const std::size_t width = c == '\t' ? tab_width - column % tab_width : continues(c) ? 0 : 1;
    if (c == '\t') {
      text.append(width, ' ');
    } else {
      text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    column += width;
  }
  return text;
}

struct Line {
  std::string_view text;
  std::vector<Mark> marks;
};
using Lines = std::map<std::uint32_t, Line>;

void add_mark(Lines& lines, const SourceMap& sources, Span span, std::string_view words,
              bool main) {
  const Place place = sources.place(span.begin);
  Line& line = lines[place.line];
  line.text = sources.line_at(span.begin);
  const std::size_t first = std::min<std::size_t>(place.column - 1, line.text.size());
  // A span over several lines is underlined to the end of its first.
  const std::size_t last = std::min<std::size_t>(first + span.size, line.text.size());
  const std::size_t begin = column_of(line.text, first);
  const std::size_t size = std::max<std::size_t>(1, column_of(line.text, last) - begin);
  line.marks.push_back({begin, size, main, words});
}

// Underlines of one line. Words stand behind the last underline, the others on lines of their own
// below, from right to left, so that no text crosses a mark.
std::string underlines(std::vector<Mark> marks, const std::string& gutter, const Palette& paint) {
  std::sort(marks.begin(), marks.end(),
            [](const Mark& a, const Mark& b) { return a.begin < b.begin; });
  std::string out = gutter;
  std::size_t column = 0;
  for (const Mark& mark : marks) {
    if (mark.begin < column) continue;  // hidden by a wider one before it
    out.append(mark.begin - column, ' ');
    out += mark.main ? paint.main : paint.label;
    out.append(mark.size, mark.main ? '^' : '-');
    out += paint.off;
    column = mark.begin + mark.size;
  }
  const auto colour = [&](const Mark& m) { return m.main ? paint.main : paint.label; };
  if (!marks.back().words.empty()) {
    out += fmt::format(" {}{}{}", colour(marks.back()), marks.back().words, paint.off);
  }
  out += '\n';
  for (std::size_t i = marks.size() - 1; i-- > 0;) {
    if (marks[i].words.empty()) continue;
    out += fmt::format("{}{:{}}{}{}{}\n", gutter, "", marks[i].begin, colour(marks[i]),
                       marks[i].words, paint.off);
  }
  return out;
}

// Long lines are cut to a window around the marks.
void cut(std::string& text, std::vector<Mark>& marks) {
  std::size_t from = marks.front().begin;
  for (const Mark& m : marks) from = std::min(from, m.begin);
  from = from > longest_line / 2 ? from - longest_line / 2 : 0;
  if (text.size() <= longest_line) return;
  if (from > 0) {
    text = "..." + text.substr(std::min(from, text.size()));
    for (Mark& m : marks) m.begin -= from - 3;
  }
  if (text.size() > longest_line) text = text.substr(0, longest_line) + "...";
  for (Mark& m : marks) {
    m.begin = std::min(m.begin, longest_line);
    m.size = std::max<std::size_t>(1, std::min(m.size, longest_line + 3 - m.begin));
  }
}

std::string excerpt(Lines lines, std::size_t gutter_width, const Palette& paint) {
  const std::string empty = fmt::format("{:{}} {}|{}", "", gutter_width, paint.frame, paint.off);
  std::string out = empty + '\n';
  std::uint32_t before = 0;
  for (auto& [number, line] : lines) {
    if (before != 0 && number > before + 1) {
      out += fmt::format("{}{:.>{}}{}\n", paint.frame, "", std::max<std::size_t>(3, gutter_width),
                         paint.off);
    }
    before = number;
    std::string text = expand_tabs(line.text);
    cut(text, line.marks);
    while (!text.empty() && text.back() == ' ') text.pop_back();
    out += fmt::format("{}{:>{}} |{}{}{}\n", paint.frame, number, gutter_width, paint.off,
                       text.empty() ? "" : " ", text);
    out += underlines(line.marks, empty + ' ', paint);
  }
  return out;
}

// Labels in other files cannot share the excerpt: they get one of their own.
std::string excerpts(const Diagnostic& d, const SourceMap& sources, std::size_t width,
                     const Palette& paint) {
  const FileId home = sources.file_of(d.span.begin);
  Lines lines;
  add_mark(lines, sources, d.span, d.at, true);
  std::map<FileId, Lines> others;
  for (const Label& label : d.labels) {
    if (label.span.begin == 0) continue;
    const FileId file = sources.file_of(label.span.begin);
    add_mark(file == home ? lines : others[file], sources, label.span, label.text, false);
  }
  std::string out = excerpt(std::move(lines), width, paint);
  for (auto& [file, part] : others) {
    out += fmt::format("{:{}} {}-->{} {}:{}\n", "", width - 1, paint.frame, paint.off,
                       sources.path(file), part.begin()->first);
    out += excerpt(std::move(part), width, paint);
  }
  return out;
}

std::size_t gutter_width(const Diagnostic& d, const SourceMap& sources) {
  std::uint32_t last = sources.place(d.span.begin).line;
  for (const Label& label : d.labels) last = std::max(last, sources.place(label.span.begin).line);
  return std::max<std::size_t>(2, std::to_string(last).size());
}

}  // namespace

std::string render_diagnostic(const Diagnostic& d, const SourceMap& sources, bool colour) {
  const Palette paint = palette_for(d.severity, colour);
  std::string out = fmt::format("{}{}[{}]{}{}: {}{}\n", paint.severity, severity_text(d.severity),
                                code_text(d.code), paint.off, paint.bold, d.message, paint.off);
  const std::size_t width = gutter_width(d, sources);
  if (d.span.begin != 0) {
    const Place place = sources.place(d.span.begin);
    out += fmt::format("{:{}}{}-->{} {}:{}:{}\n", "", width, paint.frame, paint.off, place.path,
                       place.line, place.column);
    out += excerpts(d, sources, width, paint);
  }
  for (const std::string& help : d.help) {
    out += fmt::format("{:{}} {}={} help: {}\n", "", width, paint.frame, paint.off, help);
  }
  for (const Frame& frame : d.trace) {
    out += fmt::format("{:{}} {}={} note: {}", "", width, paint.frame, paint.off, frame.text);
    if (frame.span.begin != 0) {
      const Place place = sources.place(frame.span.begin);
      out += fmt::format(" at {}:{}:{}", place.path, place.line, place.column);
    }
    out += '\n';
  }
  return out;
}

}  // namespace durer

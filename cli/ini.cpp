// INI files: lines of `Keyword=value`, of switches and of further INI files, in sections.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "cli/reader.h"
#include "cli/values.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;

/// INI files may name each other; a circle must end.
constexpr int max_depth = 16;

std::optional<std::string> read_text(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

std::string found_path(std::string_view name, const std::vector<std::string>& libraries) {
  std::vector<std::string> folders = {""};
  if (!name.starts_with('/')) folders.insert(folders.end(), libraries.begin(), libraries.end());
  std::error_code ignored;
  for (const std::string& folder : folders) {
    for (const char* suffix : {"", ".ini", ".INI"}) {
      const fs::path path = fs::path(folder) / (std::string(name) + suffix);
      if (fs::is_regular_file(path, ignored)) return path.string();
    }
  }
  return {};
}

/// The line up to `;` or `#`, unless that stands in quotes.
std::string_view without_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == ';' || c == '#') {
      return line.substr(0, i);
    }
  }
  return line;
}

/// The first word of `text`; blanks in quotes belong to it.
std::string_view first_word(std::string_view text) {
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == ' ' || c == '\t') {
      return text.substr(0, i);
    }
  }
  return text;
}

/// True for `Keyword = …`; everything up to the end of the line is then its value.
bool is_assignment(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) return false;
  const std::string_view name = trim(text.substr(0, equals));
  return !name.empty() && name.find_first_of("+- \t\"'./[") == std::string_view::npos;
}

}  // namespace

void Reader::ini(std::string_view name, const Written& where) {
  std::string_view section;
  if (const std::size_t open = name.rfind('[');
      open != std::string_view::npos && name.ends_with(']')) {
    section = trim(name.substr(open + 1, name.size() - open - 2));
    name = trim(name.substr(0, open));
  }
  if (depth_ >= max_depth) {
    return error(fmt::format("`{}`: INI files are nested more than {} deep", name, max_depth),
                 where);
  }
  const std::string path = found_path(name, settings_->library_paths);
  auto text = path.empty() ? std::nullopt : read_text(path);
  if (!text) {
    return error(fmt::format("there is no INI file `{}`", name), where,
                 fmt::format("a scene ends in `.pov` or `.scene`, or is given as `+I{}`", name));
  }
  const FileId outer = file_;
  file_ = sources_->add(path, std::move(*text));
  ++depth_;
  ini_text(file_, section);
  --depth_;
  file_ = outer;
}

void Reader::ini_text(FileId file, std::string_view section) {
  std::string_view rest = sources_->text(file);
  bool active = true;  // what stands before the first header always counts
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = trim(without_comment(rest.substr(0, end)));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    if (line.starts_with('[') && line.ends_with(']')) {
      active = !section.empty() && same_word(trim(line.substr(1, line.size() - 2)), section);
    } else if (active) {
      ini_line(line);
    }
  }
}

void Reader::ini_line(std::string_view line) {
  while (!(line = trim(line)).empty()) {
    const std::string_view item = is_assignment(line) ? line : first_word(line);
    word(item, {std::string(item), span_of(item)});
    line.remove_prefix(item.size());
  }
}

Span Reader::span_of(std::string_view text) const {
  const auto offset = text.data() - sources_->text(file_).data();
  return {sources_->base(file_) + static_cast<Loc>(offset),
          static_cast<std::uint32_t>(text.size())};
}

void Reader::default_ini(const char* povini) {
  std::error_code ignored;
  if (povini && *povini) {
    const std::string name = povini;
    if (fs::is_regular_file(name, ignored)) return ini(name, {"POVINI=" + name, {}});
    Diagnostic d;
    d.severity = Severity::warning;
    d.code = Code::file_not_found;
    d.message = fmt::format("POVINI names `{}`, which is not there", name);
    diagnostics_->report(std::move(d));
  }
  if (fs::is_regular_file("povray.ini", ignored)) ini("povray.ini", {"povray.ini", {}});
}

}  // namespace durer::cli

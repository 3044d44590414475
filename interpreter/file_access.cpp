// Which files a scene may touch, and where they are looked for (language §4.9).
#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "base/find_file.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace fs = std::filesystem;

namespace {

std::string in_capitals(std::string_view s) {
  std::string out(s);
  std::ranges::transform(out, out.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return out;
}

/// The names that `name` may stand for: with each suffix behind it, then as it is; as it is first
/// if it has such a suffix already.
std::vector<std::string> candidates_of(const std::string& name,
                                       std::span<const std::string_view> suffixes) {
  std::vector<std::string> out;
  bool has_one = suffixes.empty();
  for (const std::string_view suffix : suffixes) {
    const std::string capitals = in_capitals(suffix);
    has_one = has_one || name.ends_with(suffix) || name.ends_with(capitals);
    out.push_back(name + std::string(suffix));
    out.push_back(name + capitals);
  }
  out.insert(has_one ? out.begin() : out.end(), name);
  return out;
}

fs::path folder_of(const SourceMap& sources, FileId file) {
  return fs::path(std::string(sources.path(file))).parent_path();
}

/// Where the pictures are that stand in for those of POV-Ray's packages.
fs::path stand_ins(const Options& options) {
  return fs::path(options.stdlib_path) / "stand-ins";
}

}  // namespace

/// The folders that are searched, in order, for a name written at `span`.
std::vector<fs::path> Interpreter::search_folders(Span span) const {
  std::vector<fs::path> folders;
  // The working folder is where its user happens to be: no business of a confined scene.
  if (!options_.confined) folders.emplace_back("");
  folders.push_back(folder_of(sources_, main_file_));
  for (const std::string& p : options_.include_paths) folders.emplace_back(p);
  if (!options_.stdlib_path.empty()) folders.emplace_back(options_.stdlib_path);
  for (const std::string& p : options_.fallback_paths) folders.emplace_back(p);
  if (span.begin != 0) folders.push_back(folder_of(sources_, sources_.file_of(span.begin)));
  if (!options_.stdlib_path.empty()) folders.push_back(stand_ins(options_));
  return folders;
}

/// The one place that decides whether a file may be read.
bool Interpreter::may_read(const fs::path& path) const {
  if (!options_.confined) return true;
  const auto holds = [&](const fs::path& folder) { return lies_below(path, folder); };
  if (holds(folder_of(sources_, main_file_))) return true;
  return std::ranges::any_of(options_.include_paths, holds) ||
         (!options_.stdlib_path.empty() && holds(options_.stdlib_path)) ||
         std::ranges::any_of(options_.fallback_paths, holds) || may_write(path);
}

/// The one place that decides whether a file may be written.
bool Interpreter::may_write(const fs::path& path) const {
  if (!options_.confined) return true;
  const fs::path wanted = resolved(path);
  return std::ranges::any_of(options_.writable,
                             [&](const std::string& w) { return resolved(w) == wanted; });
}

/// Where `name` is found: exact name first in every folder, then other spellings, with a warning.
std::optional<std::string> Interpreter::find_file(const std::string& name, Span span,
                                                  std::span<const std::string_view> suffixes,
                                                  bool tolerant) {
  const auto found =
      durer::find_file(candidates_of(name, suffixes), search_folders(span), tolerant,
                       [this](const fs::path& path) { return may_read(path); });
  if (!found) return std::nullopt;
  if (found->other_spelling) {
    warn(Code::file_found_elsewhere, span,
         fmt::format("there is no `{}`; `{}` is taken instead", name, found->path.string()),
         fmt::format("write `\"{}\"`", found->path.filename().string()));
  }
  if (!options_.stdlib_path.empty() && found->path.parent_path() == stand_ins(options_)) {
    warn(Code::file_found_elsewhere, span,
         fmt::format("there is no `{}`; one that stands in for POV-Ray's is taken", name),
         "its size and kind are the same, what it shows is not; add the folder of the other with "
         "`+L<folder>`");
  }
  return found->path.string();
}

/// Error: `find_file` found nothing.
void Interpreter::missing_file(const std::string& name, Span span,
                               std::span<const std::string_view> suffixes) {
  Diagnostic d;
  d.span = span;
  const std::vector<fs::path> folders = search_folders(span);
  // Only what the scene could name itself: nothing is told about files outside.
  const bool forbidden =
      options_.confined && durer::find_file(candidates_of(name, suffixes), folders, false);
  if (forbidden) {
    d.code = Code::file_forbidden;
    d.message = fmt::format("this scene may not read `{}`", name);
    d.help.push_back(
        "an untrusted scene reads only below its own folder and the library folders; add the "
        "folder with `+L<folder>`, or render without `--untrusted`");
  } else {
    d.code = Code::file_not_found;
    d.message = fmt::format("cannot find the file `{}`", name);
    if (const std::string near = nearest_file_name(name, folders); !near.empty()) {
      d.help.push_back(fmt::format("did you mean `\"{}\"`?", near));
    }
    d.help.push_back(
        "add its folder with `+L<folder>`; the scene's own folder and the current one are searched "
        "too");
    if (std::ranges::find(suffixes, ".ttf") != suffixes.end()) {
      d.help.push_back("or install fonts that can stand in: Debian's package fonts-liberation2");
    }
  }
  fail(std::move(d));
}

/// Error unless the scene may write `path`.
void Interpreter::check_writable(const std::string& path, Span span) {
  if (may_write(path)) return;
  fail(Code::file_forbidden, span, fmt::format("this scene may not write to `{}`", path),
       "an untrusted scene writes only files that the command line names; render without "
       "`--untrusted` if you trust it");
}

}  // namespace durer::interpreter

// Files: look-up, reading, includes (language §4.9).
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/read_file.h"
#include "grammar/parse.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::string lower(std::string s) {
  std::ranges::transform(s, s.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

/// `name` below `folder`, each part in any letter case. Empty if there is none.
fs::path find_any_case(const fs::path& folder, const fs::path& name) {
  fs::path found = folder.empty() ? fs::path(".") : folder;
  for (const fs::path& part : name) {
    if (part == "." || part == ".." || part == "/") {
      found /= part;
      continue;
    }
    if (std::error_code error; fs::exists(found / part, error)) {
      found /= part;
      continue;
    }
    const std::string wanted = lower(part.string());
    std::vector<fs::path> matches;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(found, error)) {
      if (lower(entry.path().filename().string()) == wanted) matches.push_back(entry.path());
    }
    if (matches.empty()) return {};
    // Several spellings: the first by name, so that every machine takes the same one.
    found = *std::ranges::min_element(matches);
  }
  return is_file(found) ? found : fs::path();
}

}  // namespace

/// Where `name` is found: exact name first in every folder, then other spellings, with a warning.
std::optional<std::string> Interpreter::find_file(const std::string& name, Span span,
                                                  bool tolerant) {
  std::vector<fs::path> folders = {""};
  const fs::path scene_folder = fs::path(std::string(sources_.path(0))).parent_path();
  folders.push_back(scene_folder);
  for (const std::string& p : options_.include_paths) folders.emplace_back(p);
  if (!options_.stdlib_path.empty()) folders.emplace_back(options_.stdlib_path);
  for (const std::string& p : options_.fallback_paths) folders.emplace_back(p);
  if (span.begin != 0) {
    folders.push_back(
        fs::path(std::string(sources_.path(sources_.file_of(span.begin)))).parent_path());
  }

  const std::string extension = lower(fs::path(name).extension().string());
  std::vector<std::string> candidates;
  if (extension == ".inc")
    candidates = {name, name + ".inc", name + ".INC"};
  else
    candidates = {name + ".inc", name + ".INC", name};
  for (const std::string& candidate : candidates) {
    for (const fs::path& folder : folders) {
      const fs::path path =
          fs::path(candidate).is_absolute() ? fs::path(candidate) : folder / candidate;
      if (is_file(path)) return path.string();
    }
  }
  if (!tolerant) return std::nullopt;
  for (std::string candidate : candidates) {
    std::ranges::replace(candidate, '\\', '/');
    for (const fs::path& folder : folders) {
      const fs::path found = find_any_case(folder, candidate);
      if (found.empty()) continue;
      warn(Code::file_found_elsewhere, span,
           fmt::format("there is no `{}`; `{}` is taken instead", name, found.string()),
           fmt::format("write `\"{}\"`", fs::path(found).filename().string()));
      return found.string();
    }
  }
  return std::nullopt;
}

/// The parsed text of a file; each file is parsed once.
const ast::Tree& Interpreter::load(const std::string& name, Span span) {
  const auto path = find_file(name, span);
  if (!path) {
    Diagnostic d;
    d.code = Code::file_not_found;
    d.span = span;
    d.message = fmt::format("cannot find the file `{}`", name);
    d.help.push_back(
        "add its folder with `+L<folder>`; the scene's own folder and the current one are searched "
        "too");
    fail(std::move(d));
  }
  std::error_code error;
  const std::string key = fs::weakly_canonical(*path, error).string();
  if (const auto it = trees_.find(key); it != trees_.end()) return *it->second;
  std::optional<std::string> text = durer::read_file(*path);
  if (!text) fail(Code::file_not_found, span, fmt::format("cannot read the file `{}`", *path));
  const FileId file = sources_.add(*path, *std::move(text));
  auto tree = grammar::parse(sources_, file, symbols_, diagnostics_);
  if (!tree) throw Failure{};
  remember(*tree);
  return *trees_.emplace(key, std::move(tree)).first->second;
}

void Interpreter::include(const std::string& name, Span span) {
  std::size_t open = 0;
  for (const Frame& f : frames_) open += f.kind == Frame::Kind::file ? 1 : 0;
  if (open >= 100) {
    fail(Code::limit, span, "files include each other too deeply", "does a file include itself?");
  }
  const ast::Tree& tree = load(name, span);
  Frame f;
  f.kind = Frame::Kind::file;
  f.tree = &tree;
  f.first = tree.top.first;
  f.pos = tree.top.first;
  f.end = tree.top.first + tree.top.count;
  f.call = span;
  push(f);
  env_.open_scope();
}

void Interpreter::run(const ast::Tree& tree, const ast::Directive& d, const ast::Include& node) {
  const Text name =
      node.value == ast::none ? read_text(true) : evaluate_text(tree, node.value, true);
  include(name.bytes(), node.value == ast::none ? d.span : tree.exprs[node.value].span);
}

}  // namespace durer::interpreter

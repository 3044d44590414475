// Includes (language §4.9).
#include <filesystem>

#include <fmt/format.h>

#include "base/read_file.h"
#include "grammar/parse.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view include_suffixes[] = {".inc"};
}

/// The parsed text of a file; each file is parsed once.
const ast::Tree& Interpreter::load(const std::string& name, Span span) {
  const auto path = find_file(name, span, include_suffixes);
  if (!path) {
    names_are_missing_ = true;
    missing_file(name, span, include_suffixes);
  }
  std::error_code error;
  const std::string key = fs::weakly_canonical(*path, error).string();
  if (const auto it = trees_.find(key); it != trees_.end()) return *it->second;
  std::optional<std::string> text = durer::read_file(*path);
  if (!text) fail(Code::file_not_found, span, fmt::format("cannot read the file `{}`", *path));
  const FileId file = sources_.add(*path, *std::move(text));
  auto tree = grammar::parse(sources_, file, symbols_, diagnostics_, true);
  if (!tree) {
    names_are_missing_ = true;
    failed_ = true;
    stop_here(false);
  }
  remember(*tree);
  return *trees_.emplace(key, std::move(tree)).first->second;
}

/// A file that is written may be included again: what was read of it before is not its text any more.
void Interpreter::forget_text(const std::string& path) {
  std::error_code error;
  const auto it = trees_.find(fs::weakly_canonical(path, error).string());
  if (it == trees_.end()) return;
  main_trees_.push_back(std::move(it->second));  // macros and functions may still refer to it
  trees_.erase(it);
}

void Interpreter::include(const std::string& name, Span span) {
  std::size_t open = 0;
  for (const Frame& f : frames_) open += f.kind == Frame::Kind::file ? 1 : 0;
  if (const std::size_t most = options_.limits.include_depth; most > 0 && open > most) {
    fail(Code::limit, span, "files include each other too deeply",
         fmt::format("does a file include itself? {} files inside one another are the limit "
                     "(--max-include-depth)",
                     most));
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

// `durer parse`: the syntax of files, nothing else.
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/scene_file.h"
#include "grammar/parse.h"

namespace durer::cli {
namespace {

bool parses(const std::string& path) {
  SourceMap sources;
  Diagnostics diagnostics(sources);
  auto text = read_file(path);
  if (!text) {
    fmt::print(stderr, "error: cannot read `{}`\n", path);
    return false;
  }
  const FileId file = sources.add(path == "-" ? "standard input" : path, std::move(*text));
  grammar::SymbolTable symbols;
  const bool good = grammar::parse(sources, file, symbols, diagnostics) != nullptr;
  for (const Diagnostic& d : diagnostics.all()) {
    fmt::print(stderr, "{}", render_diagnostic(d, sources, colour_wanted()));
  }
  return good;
}

}  // namespace

int parse_command(const std::vector<std::string>& words) {
  if (words.empty() || words.front() == "--help") {
    fmt::print(words.empty() ? stderr : stdout, "usage: durer parse FILE...\n");
    return words.empty() ? exit_code::error : exit_code::ok;
  }
  bool good = true;
  for (const std::string& path : words) good = parses(path) && good;
  return good ? exit_code::ok : exit_code::error;
}

}  // namespace durer::cli

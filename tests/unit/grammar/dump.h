// A tree in a few characters, for tests: operators in prefix form, words with a colon, marks
// quoted.
#pragma once

#include <string>
#include <string_view>

#include "grammar/parse.h"

namespace durer::test {

/// The items of `source`, such as `:sphere {0 ',' (+ 1 A)}`; diagnostics instead if there are any.
std::string dump(std::string_view source);

/// The first diagnostic as "code line:column message", or "none".
std::string diagnose(std::string_view source);

/// What parse() gives, with everything it refers to.
struct Parsed {
  SourceMap sources;
  Diagnostics diagnostics{sources};
  grammar::SymbolTable symbols;
  std::unique_ptr<const ast::Tree> tree;

  explicit Parsed(std::string_view source);
  [[nodiscard]] std::string items(ast::Range range) const;
  [[nodiscard]] std::string text(Span span) const { return std::string(sources.text(span)); }
};

}  // namespace durer::test

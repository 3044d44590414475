// Text → syntax tree. Public.
#pragma once

#include <memory>

#include "base/diagnostic.h"
#include "grammar/ast.h"

namespace durer::grammar {

/// Parses one file of `sources`. Syntax errors are reported with caret; then the result is null.
/// Accepts everything that language §1 and §7 allow, including half blocks and half expressions
/// inside directive bodies. `symbols` gains the names of the file. An `included` file may open
/// blocks that its includer closes, and close what that one has opened.
[[nodiscard]] std::unique_ptr<const ast::Tree> parse(const SourceMap& sources, FileId file,
                                                     SymbolTable& symbols, Diagnostics& diagnostics,
                                                     bool included = false);

/// The tree as canonical text: parsing it again gives an equal tree.
[[nodiscard]] std::string print(const ast::Tree& tree, const SymbolTable& symbols);

}  // namespace durer::grammar

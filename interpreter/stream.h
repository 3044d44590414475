// The pull stream: executing the directives of syntax trees turns them into one stream of tokens,
// pulled by whoever reads a block (docs/architecture.md, "Execution model").
#pragma once

#include <cstdint>
#include <vector>

#include "grammar/ast.h"
#include "interpreter/environment.h"
#include "scene/origin.h"

namespace durer::interpreter {

/// What a reader sees. Macro calls and directives never appear: they have been executed.
struct Token {
  enum class Kind : std::uint8_t {
    end,            // of the delimited part being read, or of the scene
    word,           // a reserved word that is no value
    expr,           // an expression without macro calls at its operator level: ready to evaluate
    open,           // {
    close,          // }
    bracket_open,   // [
    bracket_close,  // ]
    punct,          // anything else: `,` `;` operators; `<=` is 'l', `>=` 'g', `!=` 'n'
  };
  const ast::Tree* tree = nullptr;
  Span span;
  SymbolId word = 0;
  ast::ExprId expr = ast::none;
  Kind kind = Kind::end;
  char punct = 0;

  [[nodiscard]] bool is(SymbolId w) const { return kind == Kind::word && word == w; }
  [[nodiscard]] bool is_punct(char c) const { return kind == Kind::punct && punct == c; }
  [[nodiscard]] const ast::Expr& expression() const { return tree->exprs[expr]; }
  /// True if it may name something declared: a variable, an element, an entry.
  [[nodiscard]] bool is_place() const {
    return node<ast::Name>() != nullptr || node<ast::Index>() != nullptr ||
           node<ast::Member>() != nullptr || node<ast::Element>() != nullptr;
  }
  template <typename T>
  [[nodiscard]] const T* node() const {
    return kind == Kind::expr ? std::get_if<T>(&expression().node) : nullptr;
  }
};

/// One level of what is being read. The innermost is the last.
struct Frame {
  enum class Kind : std::uint8_t {
    file,    // an include or the scene itself; owns a scope
    macro,   // a macro body; owns a scope
    branch,  // the taken branch of an #if
    while_,
    for_,
    switch_,    // the cases from the matching one on
    group,      // { … } or [ … ]: delivers its closing mark at the end
    barrier,    // a delimited part read by a nested reader: delivers `end`
    expansion,  // an expression spelled out operand by operand
    literals,   // a long list of literals: `pos` and `end` are offsets in its text
  };
  Kind kind = Kind::branch;
  bool flatten = false;   // spell out every expression: operators stand next to this part
  bool brackets = false;  // group: which closing mark
  bool at_comma = false;  // literals: an element has been read
  const ast::Tree* tree = nullptr;
  std::uint32_t first = 0;  // items: the whole range, for loops
  std::uint32_t pos = 0;    // items: next
  std::uint32_t end = 0;
  std::uint32_t pieces = 0;     // expansion: its pieces lie from here to the top of the piece stack
  std::uint32_t node = 0;       // loops, switch: the directive; group: the GroupId
  std::uint32_t next_case = 0;  // switch_
  double limit = 0;             // for_
  double step = 0;
  Span call;                   // macro, file: where it was called
  SymbolId name = 0;           // macro: its name
  scene::OriginId origin = 0;  // macro, file: origin of the call, made when first needed
  bool has_origin = false;

  /// `pos` to `end` are items of the tree.
  [[nodiscard]] bool has_items() const {
    return kind != Kind::expansion && kind != Kind::literals;
  }
};

/// Part of an expression that is still to be delivered.
struct Piece {
  const ast::Tree* tree = nullptr;
  ast::ExprId expr = ast::none;  // none: the mark below
  char punct = 0;
  SymbolId word = 0;  // punct '.': a member name follows as a word
  bool is_word = false;
  bool flatten = false;
  Span span;
};

}  // namespace durer::interpreter

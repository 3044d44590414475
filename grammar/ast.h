// The syntax tree of one file: items, and the expressions in them. Everything lives in flat arrays
// and refers by 32-bit index, so that a tree of a 30 MB mesh stays small and cheap to walk.
//
// The language is spliced, not nested: a macro body or an `#if` branch may hold half a block, half
// an expression or a list of entries. So the tree has two layers. *Items* are what executing
// directives yields, one after the other, to whoever reads a block. *Expressions* are maximal
// closed runs of operands and operators, ready to be compiled. Where a parenthesis, a vector or an
// argument list holds a directive or anything else that is no plain expression, it becomes an
// `OpenGroup` of items and is read item by item.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "base/diagnostic.h"
#include "base/source.h"
#include "grammar/literals.h"
#include "grammar/vocabulary.h"

namespace durer::ast {

using grammar::SymbolId;
using ExprId = std::uint32_t;
using GroupId = std::uint32_t;
using DirectiveId = std::uint32_t;
inline constexpr std::uint32_t none = 0xFFFFFFFF;

/// How deep expressions may be stacked, and how deep groups, bodies and parentheses may be nested.
/// Generated sums of some thousand terms occur; deeper trees would endanger recursive readers.
inline constexpr std::uint16_t max_height = 5000;
inline constexpr std::uint32_t max_nesting = 1000;

/// A run of consecutive entries in one of the tree's arrays.
struct Range {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

// ---- expressions ------------------------------------------------------------------------------

enum class Op : std::uint8_t {
  add,
  sub,
  mul,
  div,  // additive level
  lt,
  le,
  eq,
  ne,
  ge,
  gt,
  and_,
  or_,  // full level only; and_, or_ have one precedence (language §2.2)
  neg,
  pos,
  not_,  // prefix
};

struct Number {
  double value = 0;
};
/// A string literal: index into Tree::strings. Only `\"` has been translated; whether the other
/// escapes are depends on the place (language §1.4).
struct String {
  std::uint32_t index = 0;
};
struct Name {
  SymbolId name = 0;
};
/// Parentheses are kept: they change the reading level and replicate components (language §2.4).
struct Paren {
  ExprId inner = none;
};
/// `<a, b, c>`: components in Tree::expr_lists.
struct Vector {
  Range components;
};
struct Unary {
  Op op = Op::neg;
  ExprId operand = none;
};
/// Inside a function body `&` has been bound tighter than `|` (language §6.2).
struct Binary {
  Op op = Op::add;
  ExprId left = none;
  ExprId right = none;
};
struct Conditional {
  ExprId condition = none;
  ExprId yes = none;
  ExprId no = none;
};
/// `name(a, b)` or `name[i](a, b)` with plain expressions as arguments (in Tree::expr_lists).
/// `callee` is a Name or an Index, or since 3.8 a Member or an Element.
struct Call {
  ExprId callee = none;
  Range args;
};
/// `name[i][j]`, subscripts in Tree::expr_lists.
struct Index {
  SymbolId name = 0;
  Range subscripts;
};
struct Member {
  ExprId object = none;
  SymbolId member = 0;
};
/// `place[i]` where the array is an entry of a dictionary: `object` is a Member or an Element.
struct Element {
  ExprId object = none;
  Range subscripts;
};
/// A delimited part whose content is no plain expression list: read item by item (Tree::items).
/// An index holds one `brackets` item per subscript; the others hold what stands inside.
struct OpenGroup {
  enum class Kind : std::uint8_t { paren, vector, call, index };
  Kind kind = Kind::paren;
  ExprId callee = none;  // call: a Name, Index or OpenGroup(index)
  SymbolId name = 0;     // index: the array
  Range items;
};

struct Expr {
  Span span;
  /// True if a user name stands before a parenthesis somewhere below, or an OpenGroup: only then
  /// can a macro be expanded inside, and the expression must be read operand by operand.
  bool may_expand = false;
  /// How many expressions lie on the longest way down, this one included; at most max_height, so
  /// that readers may recurse.
  std::uint16_t height = 1;
  std::variant<Number, String, Name, Paren, Vector, Unary, Binary, Conditional, Call, Index, Member,
               OpenGroup, Element>
      node;
};

// ---- items ------------------------------------------------------------------------------------

enum class ItemKind : std::uint8_t {
  expr,       // ref: ExprId. A maximal *additive-level* expression (full level only in OpenGroups
              // and function bodies, where nothing else can stand)
  word,       // ref: SymbolId of a reserved word that is no value
  braces,     // ref: GroupId: `{ items }`
  brackets,   // ref: GroupId: `[ items ]`
  directive,  // ref: DirectiveId
  literals,   // ref: into Tree::literals: a long list of numbers or vectors, commas included
  punct,      // detail: the character: `,` `;` or a stray mark. `<=` is 'l', `>=` 'g', `!=` 'n'
};

struct Item {
  ItemKind kind = ItemKind::punct;
  char detail = 0;
  std::uint32_t ref = 0;
  Span span;
};

/// A balanced pair of braces or brackets.
struct Group {
  Range items;
  Span open;
  Span close;
};

// ---- directives -------------------------------------------------------------------------------

/// `#declare X[i] =` and `#local`. With a plain expression (or string expression) and its `;`, or
/// its end, known at parse time, `value` holds it; otherwise the value is whatever items follow.
struct Declare {
  bool local = false;
  bool deprecated = false;
  bool deprecated_once = false;
  ExprId deprecated_message = none;
  SymbolId name = 0;
  Range subscripts;     // Tree::expr_lists
  ExprId place = none;  // the target if it is more than a name with subscripts: `D.key[i]`
  ExprId value = none;  // none: read from the items that follow
  bool semicolon = false;
  Span target;
};
/// Several targets at once: `(A, B) = (1, 2);` one after the other, `<A, B> = V;` components,
/// `{A, , B} = List;` elements. The value is whatever items follow.
struct Tuple {
  bool local = false;
  char kind = '(';
  Range targets;  // Tree::expr_lists; none for gaps
};
struct Undef {
  SymbolId name = 0;
  Range subscripts;
  ExprId place = none;
};

/// What a body comes to, as far as its text tells. Most bodies of loops and macros are no part of a
/// block: those run as plain statements, without delivering tokens one by one.
struct Body : Range {
  enum class Shape : std::uint8_t {
    open,        // anything
    statements,  // directives complete in themselves, and nothing else
    value,       // the same, and one expression at the end
  };
  Shape shape = Shape::open;
};

/// One branch of an #if chain. `condition` is a Paren or OpenGroup(paren) expression.
struct Branch {
  enum class Kind : std::uint8_t { if_, ifdef, ifndef, else_ };
  Kind kind = Kind::if_;
  ExprId condition = none;  // if_: the condition; ifdef, ifndef: a Name or an Index
  Body items;
  Span span;
};
struct If {
  Range branches;
};  // Tree::branches
struct While {
  ExprId condition = none;
  Body items;
};
struct For {
  SymbolId name = 0;
  ExprId start = none;
  ExprId end = none;
  ExprId step = none;
  Body items;
};
struct Case {
  enum class Kind : std::uint8_t { case_, range, else_ };
  Kind kind = Kind::case_;
  ExprId low = none;  // case_: the Paren; range: the first bound
  ExprId high = none;
  Body items;
  Span span;
};
struct Switch {
  ExprId value = none;
  Range cases;
};  // Tree::cases
struct Param {
  SymbolId name = 0;
  Span span;
  bool optional = false;
};
struct Macro {
  SymbolId name = 0;
  Range params;
  Body items;
  Span head;
  /// Shape::value: the value is one operand, so that operators next to a call cannot reach into it.
  bool atomic = false;
};  // Tree::params
struct Break {};
/// `#include "x"`, `#version 3.7;`, `#debug`, `#warning`, `#error`, `#render`, `#statistics`.
/// `value` none: the operand is read from the items that follow.
struct Include {
  ExprId value = none;
};
struct Version {
  ExprId value = none;
};
struct Message {
  enum class Kind : std::uint8_t { debug, warning, error, render, statistics };
  Kind kind = Kind::debug;
  ExprId value = none;
};
/// These read their operands from the items that follow: `#default {…}`, `#fopen H "f" write`,
/// `#fclose H`, `#read (…)`, `#write (…)`.
struct Simple {
  enum class Kind : std::uint8_t { default_, fopen, fclose, read, write };
  Kind kind = Kind::default_;
};
/// A word after `#` that is no directive, or a directive inside a body that is malformed as a
/// whole (then there is a Flaw): an error only when executed (language §4.1).
struct Unknown {
  SymbolId word = 0;
};

struct Directive {
  Span span;  // from `#` to the end of the head (not of the body)
  std::variant<Declare, Undef, If, While, For, Switch, Macro, Break, Include, Version, Message,
               Simple, Unknown, Tuple>
      node;
};

/// Text in a directive body that the grammar could not read. It became the mark, word or Unknown
/// directive that begins at `place`; whoever executes that should report `why`.
struct Flaw {
  Loc place = 0;
  Diagnostic why;
};

// ---- the tree ---------------------------------------------------------------------------------

struct Tree {
  FileId file = 0;
  Range top;  // items of the file itself

  std::vector<Item> items;
  std::vector<Expr> exprs;
  std::vector<ExprId> expr_lists;
  std::vector<Group> groups;
  std::vector<Directive> directives;
  std::vector<Branch> branches;
  std::vector<Case> cases;
  std::vector<Param> params;
  std::vector<std::string> strings;
  std::vector<grammar::LiteralRun> literals;
  std::vector<Flaw> flaws;  // sorted by place
  /// The file began with bytes above 127 (a byte-order mark): strings are UTF-8 (language §1.1).
  bool utf8 = false;
};

}  // namespace durer::ast

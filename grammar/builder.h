// From rules to nodes: what the grammar recognises becomes a Tree here. The builder keeps an
// operand stack for expressions and a stack of frames for everything that has a beginning and an
// end; items wait in the frame where they stand until it closes and they can lie in the tree as one
// run.
#pragma once

#include <string_view>
#include <unordered_set>
#include <vector>

#include "grammar/ast.h"
#include "grammar/balance.h"
#include "grammar/literals.h"

namespace durer::grammar {

/// What stopped the grammar. Private to this folder: parse() turns it into a diagnostic, or, in a
/// directive body, into a Flaw.
struct Failure {
  enum class Kind : std::uint8_t { expected, vector, directive, nesting, height };
  const char* at = nullptr;        // where something else was expected
  std::string_view expected = {};  // "`)`"
  Span opened{};                   // the innermost open bracket or directive, if there is one
  Kind kind = Kind::expected;
  bool after_operand = false;  // vector: an expression precedes the `<`

  /// Limits are final: no directive body can recover from them.
  [[nodiscard]] bool final() const { return kind == Kind::nesting || kind == Kind::height; }
};

/// True for the built-in functions whose result is text: nothing can be added to them.
[[nodiscard]] bool returns_text(SymbolId function);

/// True for `Declare`, `IF` and their kin.
[[nodiscard]] bool is_directive_in_capitals(std::string_view word);

class Builder {
 public:
  Builder(std::string_view text, Loc base, SymbolTable& symbols, const Balance& balance,
          const LiteralRuns& runs, ast::Tree& tree, bool lenient = false);

  // ---- what the rules ask --------------------------------------------------------------------

  struct Word {
    const char* begin = nullptr;
    const char* end = nullptr;
    SymbolId id = 0;
    WordClass word_class = WordClass::identifier;
  };
  /// The word that begins at `at`; null if none does. Remembers the last one asked for.
  const Word* word_at(const char* at, const char* end);

  [[nodiscard]] bool is_stray(const char* at) const {
    return balance_->has_strays() && balance_->is_stray(offset(at));
  }
  /// True inside the body of a conditional, loop or macro, where nothing is an error yet.
  [[nodiscard]] bool in_body() const { return frames_.back().bodies > 0; }
  /// True if an operator that continues nothing may stand here: next to something that may expand.
  [[nodiscard]] bool mark_allowed(const char* at) const;
  /// True if a `{` here opens the body of a function.
  [[nodiscard]] bool function_ahead() const;
  /// True if `<` here can be nothing but a relation: a full-level expression precedes it.
  [[nodiscard]] bool relation_only() const;
  /// True if `<` here, which begins no vector, may be a relation or a stray mark.
  [[nodiscard]] bool relation_possible(bool directive_seen) const;
  /// True if the operand before this place is a member that no component is called: only entries of
  /// dictionaries have elements and can be called.
  [[nodiscard]] bool after_entry() const;
  /// True if the last operand is a vector of one component that cannot become more.
  [[nodiscard]] bool made_single_component() const;
  /// True behind `rgb 1` and the like, or behind an operator there: such expressions may compare.
  [[nodiscard]] bool after_colour() const;
  /// True if the item before this place is an expression.
  [[nodiscard]] bool after_operand() const;

  // ---- recovery --------------------------------------------------------------------------------

  struct Checkpoint;
  [[nodiscard]] Checkpoint checkpoint() const;
  void rollback(const Checkpoint& to);
  /// Places where an attempt, or a whole item, failed before.
  [[nodiscard]] bool known_bad(const char* at) const {
    return !bad_attempts_.empty() && bad_attempts_.contains(at);
  }
  void remember_bad(const char* at) { bad_attempts_.insert(at); }
  [[nodiscard]] bool known_bad_item(const char* at) const {
    return !bad_items_.empty() && bad_items_.contains(at);
  }
  void remember_bad_item(const char* at) { bad_items_.insert(at); }
  void flaw(const char* item, const Failure& why);
  /// In a lenient run: errors outside of directive bodies.
  [[nodiscard]] const std::vector<Diagnostic>& flaws_of_file() const { return flaws_of_file_; }
  /// True where such a run skips an item that cannot be read.
  [[nodiscard]] bool skips_bad_items() const { return lenient_ && frames_.size() == 1; }
  /// Notes why, and tells where the next item begins; null if that cannot be told.
  const char* skip_bad_item(const char* at, const Failure& why);
  [[nodiscard]] Failure failure(const char* at, std::string_view expected,
                                Failure::Kind kind = Failure::Kind::expected) const;
  [[nodiscard]] Diagnostic diagnostic(const Failure& f) const;

  void start_item(const char* at) { item_start_ = at; }
  [[nodiscard]] bool item_starts_at(const char* at) const { return at == item_start_; }
  /// Every token says where it ended, so that spans need not include white space.
  void token(std::string_view text) { last_end_ = span(text).end(); }
  void enter(const char* at);
  void leave() { --depth_; }

  // ---- expressions
  // -------------------------------------------------------------------------------

  void number(std::string_view text);
  void string(std::string_view text);
  void name(std::string_view text);
  void unary(char op, const char* at);
  void binary(std::string_view op);
  void conditional();
  void member(std::string_view text);

  enum class FrameKind : std::uint8_t {
    file,
    body,
    braces,
    brackets,
    paren,
    call,
    index,
    subscript,
    vector,
    head,
  };
  void open(FrameKind kind, const char* at, bool in_function, bool arguments = false);
  void open(FrameKind kind, const char* at) { open(kind, at, frames_.back().in_function); }
  void open_call(const char* at) { open(FrameKind::call, at, frames_.back().in_function, true); }
  void close_paren(const char* at);
  void close_call(const char* at);
  void close_subscript(const char* at);
  void close_index();
  /// False if the components make no vector.
  bool close_vector(const char* at);
  void stopped_at(const char* at) { stopped_ = at; }
  [[nodiscard]] const char* stopped() const { return stopped_; }
  [[nodiscard]] bool directive_seen() const { return frames_.back().directive_seen; }
  [[nodiscard]] bool in_vector() const { return frames_.back().kind == FrameKind::vector; }

  // ---- items
  // -------------------------------------------------------------------------------------

  void expression_item();
  /// Takes up the expression item before this place once more, as an operand, to be continued.
  bool resume_expression();
  void resumed_item();
  /// The long list of literals that begins here becomes an item; its size, 0 if there is none.
  std::size_t literals_item(const char* at);
  void word_item(std::string_view text);
  void mark(std::string_view text);
  void close_group(ast::ItemKind kind, const char* at);
  void close_file();

  // ---- directives
  // -------------------------------------------------------------------------------- `head` is the
  // text from `#` to the last token of the head; white space may follow in it.

  void begin_declare(std::string_view head, bool local);
  void begin_tuple(std::string_view head, bool local);
  void tuple_gap() { operands_.push_back(ast::none); }
  void deprecated(bool once);
  void declared_value(bool semicolon);
  /// No `;` follows: a value only if nothing at `next` can continue it, otherwise an item.
  void open_value(const char* next);
  void undef(std::string_view head);
  void begin_if(std::string_view head, ast::Branch::Kind kind);
  void next_branch(std::string_view head, ast::Branch::Kind kind);
  void end_if();
  void begin_switch(std::string_view head);
  void next_case(std::string_view head, ast::Case::Kind kind);
  void end_switch();
  void begin_while(std::string_view head);
  void begin_for(std::string_view head);
  void begin_macro(std::string_view head);
  void macro_param(std::string_view text);
  void optional_param() { tree_->params.back().optional = true; }
  void end_loop_or_macro();
  template <typename Node>
  void simple_directive(std::string_view head, Node node) {
    push_directive({token_span(head), std::move(node)});
  }
  void unknown_word(std::string_view text);
  void unknown(std::string_view head);
  /// The operand of the directive that was pushed last.
  void directive_operand();

 private:
  struct Frame {
    FrameKind kind = FrameKind::file;
    bool in_function = false;  // `&` binds tighter than `|`
    bool arguments = false;    // call arguments: a `<` after an operand may begin the next one
    bool directive_seen = false;
    bool dictionary = false;  // the braces after `dictionary`
    std::uint32_t bodies = 0;  // directive bodies around
    Span open{};
    std::uint32_t items = 0;     // first of its items in items_
    std::uint32_t operands = 0;  // first of its operands in operands_
  };
  /// A directive with a body, until its `#end`.
  struct Pending {
    ast::Directive directive;
    std::uint32_t branches = 0;
    std::uint32_t cases = 0;
  };

  [[nodiscard]] std::uint32_t offset(const char* at) const {
    return static_cast<std::uint32_t>(at - begin_);
  }
  [[nodiscard]] Span span(std::string_view text) const {
    return {base_ + offset(text.data()), static_cast<std::uint32_t>(text.size())};
  }
  [[nodiscard]] Span char_span(const char* at) const { return {base_ + offset(at), 1}; }
  /// The span of a text that ends with the last token read.
  [[nodiscard]] Span token_span(std::string_view text) const;
  template <typename Node>
  void push(Span where, bool expands, std::uint32_t height, Node node) {
    if (height > ast::max_height) too_deep(where);
    operands_.push_back(static_cast<ast::ExprId>(tree_->exprs.size()));
    tree_->exprs.push_back({where, expands, static_cast<std::uint16_t>(height), node});
  }
  [[noreturn]] void too_deep(Span where) const;
  ast::ExprId pop();
  /// A name with its subscripts, or the expression itself as `place`.
  struct Target {
    SymbolId name = 0;
    ast::Range subscripts;
    ast::ExprId place = ast::none;
  };
  Target target_of(ast::ExprId target);
  [[nodiscard]] const ast::Expr& expr(ast::ExprId id) const { return tree_->exprs[id]; }
  [[nodiscard]] std::uint32_t height_of(ast::Range list) const;
  [[nodiscard]] bool may_expand(ast::Range list) const;

  void push_item(ast::ItemKind kind, std::uint32_t ref, Span span, char detail = 0);
  [[nodiscard]] const ast::Item* last_item() const;
  ast::Range take_items();
  /// The expressions of the top frame, if its items are a plain list of them.
  bool plain_list(ast::Range& out);
  [[nodiscard]] bool ends_in_comma() const;
  void close_open_group(Span span, ast::OpenGroup group);
  void close_element(ast::ExprId object, Span where);

  void push_directive(ast::Directive d);
  ast::Directive& last_directive();
  void open_body(Span head);
  ast::Body close_body();
  [[nodiscard]] ast::Body::Shape shape_of(ast::Range items) const;
  [[nodiscard]] bool is_statement(const ast::Item& item) const;
  void finish_branch();
  void finish_case();

  const char* begin_;
  const char* end_;
  Loc base_;
  SymbolTable* symbols_;
  const Balance* balance_;
  const LiteralRuns* runs_;
  ast::Tree* tree_;

  std::vector<ast::ExprId> operands_;
  std::vector<ast::Item> items_;
  std::vector<Frame> frames_;
  std::vector<Pending> pending_;
  std::vector<ast::Branch> branches_;
  std::vector<ast::Case> cases_;

  Word word_;
  Loc last_end_ = 0;
  std::uint32_t depth_ = 0;
  const char* item_start_ = nullptr;
  const char* stopped_ = nullptr;
  SymbolId unknown_word_ = 0;
  bool deprecated_ = false;
  bool deprecated_once_ = false;
  bool lenient_ = false;  // a run that looks for more errors only
  std::vector<Diagnostic> flaws_of_file_;
  std::unordered_set<const char*> bad_attempts_;
  std::unordered_set<const char*> bad_items_;
};

struct Builder::Checkpoint {
  std::size_t exprs, expr_lists, items, groups, directives, branches, cases, params, strings, literals;
  std::size_t operands, waiting_items, frames, pending, waiting_branches, waiting_cases;
  std::uint32_t depth;
  Loc last_end;
};

}  // namespace durer::grammar

// Frames in, tokens out. A frame is a range of items or an expression being spelled out; directives
// met on the way are executed, macro calls are replaced by frames of their bodies.
#include "interpreter/stream.h"

#include <utility>

#include "interpreter/interpreter.h"

namespace durer::interpreter {
namespace {

/// A name that begins an object since 3.8 counts as a word from here on.
void as_added_object(Token& token) {
  const auto* name = token.node<ast::Name>();
  if (name == nullptr || name->name != grammar::additions::lemon) return;
  token.kind = Token::Kind::word;
  token.word = name->name;
}

// Deeper than any scene needs, shallow enough for the machine stack: a macro call inside an
// expression recurses in C++.
constexpr std::size_t max_nesting = 4000;
constexpr std::size_t max_frames = 20000;

/// True for frames whose text is likely to be met again.
bool repeats(Frame::Kind kind) {
  return kind == Frame::Kind::macro || kind == Frame::Kind::for_ || kind == Frame::Kind::while_;
}

Token mark(Token::Kind kind, Span span) {
  Token t;
  t.kind = kind;
  t.span = span;
  return t;
}

}  // namespace

Token Interpreter::next() {
  if (unread_.size() > unread_base_) {
    const Token t = unread_.back();
    unread_.pop_back();
    return t;
  }
  Token token;
  while (!step(token)) {
  }
  return token;
}

const Token& Interpreter::peek() {
  if (unread_.size() <= unread_base_) unread_.push_back(next());
  return unread_.back();
}

void Interpreter::unread(const Token& token) { unread_.push_back(token); }

Token Interpreter::raw_next() const {
  if (unread_.size() > unread_base_) return unread_.back();
  const Frame& f = frames_.back();
  Token t;
  if (f.kind == Frame::Kind::literals) {
    if (f.at_comma) {
      t.kind = Token::Kind::punct;
      t.punct = ',';
    }
    return t;
  }
  if (f.kind == Frame::Kind::expansion) {
    if (pieces_.size() > f.pieces && pieces_.back().expr == ast::none && !pieces_.back().is_word) {
      t.kind = Token::Kind::punct;
      t.punct = pieces_.back().punct;
    }
    return t;
  }
  if (f.pos >= f.end) {
    if (f.kind == Frame::Kind::group) {
      t.kind = f.brackets ? Token::Kind::bracket_close : Token::Kind::close;
    }
    return t;
  }
  const ast::Item& item = f.tree->items[f.pos];
  t.tree = f.tree;
  t.span = item.span;
  switch (item.kind) {
    case ast::ItemKind::word:
      t.kind = Token::Kind::word;
      t.word = item.ref;
      break;
    case ast::ItemKind::punct:
      t.kind = item.detail == '{'   ? Token::Kind::open
               : item.detail == '}' ? Token::Kind::close
               : item.detail == '[' ? Token::Kind::bracket_open
               : item.detail == ']' ? Token::Kind::bracket_close
                                    : Token::Kind::punct;
      t.punct = item.detail;
      break;
    case ast::ItemKind::braces: t.kind = Token::Kind::open; break;
    case ast::ItemKind::brackets: t.kind = Token::Kind::bracket_open; break;
    case ast::ItemKind::expr:
      if (!needs_expansion(*f.tree, item.ref)) {
        t.kind = Token::Kind::expr;
        t.expr = item.ref;
      }
      break;
    case ast::ItemKind::literals:
    case ast::ItemKind::directive: break;
  }
  return t;
}

bool Interpreter::accept_raw_punct(char c) {
  if (!raw_next().is_punct(c)) return false;
  next();
  return true;
}

Frame& Interpreter::push(Frame::Kind kind, Span call) {
  if (frames_.size() >= max_frames) {
    fail(Code::limit, call, "directives and blocks are nested too deeply",
         "is a macro calling itself without end?");
  }
  if (repeats(kind)) ++repeats_;
  Frame& f = frames_.emplace_back();
  f.kind = kind;
  f.call = call;
  return f;
}

void Interpreter::push(const Frame& frame) { push(frame.kind, frame.call) = frame; }

void Interpreter::pop() {
  const Frame& f = frames_.back();
  if (repeats(f.kind)) --repeats_;
  if (f.kind == Frame::Kind::expansion) pieces_.resize(f.pieces);
  if (f.kind == Frame::Kind::macro || f.kind == Frame::Kind::file) {
    if (f.kind == Frame::Kind::macro) {
      if (options_.on_trace) trace_return(f);
      --macro_depth_;
    }
    if (env_.scope() > 0) env_.close_scope();
  }
  frames_.pop_back();
}

/// One step of the innermost frame; true if it made a token.
bool Interpreter::step(Token& token) {
  const Frame& f = frames_.back();
  if (f.kind == Frame::Kind::expansion) return step_expansion(token);
  if (f.kind == Frame::Kind::literals) return step_literals(token);
  return f.pos < f.end ? step_item(token) : step_end(token);
}

bool Interpreter::step_item(Token& token) {
  Frame& f = frames_.back();
  const ast::Tree& tree = *f.tree;
  const ast::Item& item = tree.items[f.pos++];
  token = Token{};
  token.tree = &tree;
  token.span = item.span;
  switch (item.kind) {
    case ast::ItemKind::word:
      token.kind = Token::Kind::word;
      token.word = item.ref;
      return true;
    case ast::ItemKind::punct:
      token.kind = item.detail == '{'   ? Token::Kind::open
                   : item.detail == '}' ? Token::Kind::close
                   : item.detail == '[' ? Token::Kind::bracket_open
                   : item.detail == ']' ? Token::Kind::bracket_close
                                        : Token::Kind::punct;
      token.punct = item.detail;
      return true;
    case ast::ItemKind::braces:
    case ast::ItemKind::brackets: {
      const ast::Group& g = tree.groups[item.ref];
      Frame inner;
      inner.kind = Frame::Kind::group;
      inner.brackets = item.kind == ast::ItemKind::brackets;
      inner.tree = &tree;
      inner.first = g.items.first;
      inner.pos = g.items.first;
      inner.end = g.items.first + g.items.count;
      inner.node = item.ref;
      inner.call = g.open;
      push(inner);
      token.kind = inner.brackets ? Token::Kind::bracket_open : Token::Kind::open;
      token.span = g.open;
      return true;
    }
    case ast::ItemKind::directive: execute(tree, item); return false;
    case ast::ItemKind::literals: push_literals(tree, item); return false;
    case ast::ItemKind::expr:
      if (f.flatten || needs_expansion(tree, item.ref)) {
        if (is_macro_call(tree, item.ref)) {
          call_macro(tree, item.ref, f.flatten);
        } else {
          expand(tree, item.ref, f.flatten);
        }
        return false;
      }
      token.kind = Token::Kind::expr;
      token.expr = item.ref;
      if (additions_) as_added_object(token);
      return true;
  }
  return false;
}

/// The innermost frame has nothing left.
bool Interpreter::step_end(Token& token) {
  Frame& f = frames_.back();
  switch (f.kind) {
    case Frame::Kind::barrier: token = mark(Token::Kind::end, f.call); return true;
    case Frame::Kind::file:
      if (frames_.size() == 1) {  // the scene itself: its globals stay
        token = mark(Token::Kind::end, {sources_.base(f.tree->file) +
                                            static_cast<Loc>(sources_.text(f.tree->file).size()),
                                        0});
        return true;
      }
      pop();
      return false;
    case Frame::Kind::group:
      token = mark(f.brackets ? Token::Kind::bracket_close : Token::Kind::close,
                   f.tree->groups[f.node].close);
      pop();
      return true;
    case Frame::Kind::while_:
    case Frame::Kind::for_:
      if (!loop_again(f)) pop();
      return false;
    case Frame::Kind::switch_: {
      // Cases fall through, even into #else, until #break (language §4.4).
      const auto& node = std::get<ast::Switch>(f.tree->directives[f.node].node);
      if (f.next_case >= node.cases.count) {
        pop();
        return false;
      }
      const ast::Case& c = f.tree->cases[node.cases.first + f.next_case++];
      f.first = c.items.first;
      f.pos = c.items.first;
      f.end = c.items.first + c.items.count;
      return false;
    }
    case Frame::Kind::macro:
    case Frame::Kind::branch:
    case Frame::Kind::literals:
    case Frame::Kind::expansion: pop(); return false;
  }
  return false;
}

// ---- expressions that contain macro calls ---------------------------------------------------

const MacroRef* Interpreter::macro_named(SymbolId name) const {
  const Value* v = Environment::value_of(env_.find(name));
  return v == nullptr ? nullptr : v->get<MacroRef>();
}

bool Interpreter::is_macro_call(const ast::Tree& tree, ast::ExprId id) const {
  const auto& node = tree.exprs[id].node;
  if (const auto* call = std::get_if<ast::Call>(&node)) return macro_of(tree, call->callee) != nullptr;
  const auto* open = std::get_if<ast::OpenGroup>(&node);
  return open != nullptr && open->kind == ast::OpenGroup::Kind::call &&
         macro_of(tree, open->callee) != nullptr;
}

const MacroRef* Interpreter::macro_of(const ast::Tree& tree, ast::ExprId callee) const {
  if (callee == ast::none) return nullptr;
  const auto* name = std::get_if<ast::Name>(&tree.exprs[callee].node);
  return name == nullptr ? nullptr : macro_named(name->name);
}

/// The macro whose call `id` is, if its value can be worked out on the spot: its body is statements
/// and an expression. Next to operators (`alone` false) only if they cannot reach into the value.
const MacroRef* Interpreter::value_macro(const ast::Tree& tree, ast::ExprId id, bool alone) const {
  const auto* call = std::get_if<ast::Call>(&tree.exprs[id].node);
  if (call == nullptr) return nullptr;
  const MacroRef* ref = macro_of(tree, call->callee);
  if (ref == nullptr || ref->macro->items.shape != ast::Body::Shape::value) return nullptr;
  return alone || ref->macro->atomic ? ref : nullptr;
}

/// True if a macro call stands at the operator level of the expression and the operators next to it
/// must see the tokens of its body: `2*M(1,2)` with the body `a+b` means 2*1+2. Calls inside
/// parentheses, vectors and arguments do not count: those are read by readers of their own.
/// `alone`: the caller can work out a call that is the whole expression.
bool Interpreter::needs_expansion(const ast::Tree& tree, ast::ExprId id, bool alone) const {
  const ast::Expr& e = tree.exprs[id];
  if (!e.may_expand) return false;
  if (const auto* b = std::get_if<ast::Binary>(&e.node)) {
    return operand_expands(tree, b->left) || operand_expands(tree, b->right);
  }
  if (const auto* call = std::get_if<ast::Call>(&e.node)) {
    if (macro_of(tree, call->callee) == nullptr) return false;
    return !alone || value_macro(tree, id, true) == nullptr;
  }
  if (const auto* open = std::get_if<ast::OpenGroup>(&e.node)) {
    return open->kind == ast::OpenGroup::Kind::call && macro_of(tree, open->callee) != nullptr;
  }
  if (const auto* u = std::get_if<ast::Unary>(&e.node)) return operand_expands(tree, u->operand);
  if (const auto* m = std::get_if<ast::Member>(&e.node)) return operand_expands(tree, m->object);
  if (const auto* c = std::get_if<ast::Conditional>(&e.node)) {
    return operand_expands(tree, c->condition) || operand_expands(tree, c->yes) ||
           operand_expands(tree, c->no);
  }
  return false;
}

bool Interpreter::operand_expands(const ast::Tree& tree, ast::ExprId id) const {
  return tree.exprs[id].may_expand && needs_expansion(tree, id) &&
         value_macro(tree, id, false) == nullptr;
}

void Interpreter::expand(const ast::Tree& tree, ast::ExprId id, bool flatten) {
  Frame f;
  f.kind = Frame::Kind::expansion;
  f.tree = &tree;
  f.pieces = static_cast<std::uint32_t>(pieces_.size());
  f.call = tree.exprs[id].span;
  push(f);
  push_pieces(tree, id, flatten);
}

namespace {
char op_mark(ast::Op op) {
  switch (op) {
    case ast::Op::add:
    case ast::Op::pos: return '+';
    case ast::Op::sub:
    case ast::Op::neg: return '-';
    case ast::Op::mul: return '*';
    case ast::Op::div: return '/';
    case ast::Op::lt: return '<';
    case ast::Op::le: return 'l';
    case ast::Op::eq: return '=';
    case ast::Op::ne: return 'n';
    case ast::Op::ge: return 'g';
    case ast::Op::gt: return '>';
    case ast::Op::and_: return '&';
    case ast::Op::or_: return '|';
    case ast::Op::not_: return '!';
  }
  return '?';
}
}  // namespace

/// Puts the operands and operators of one level on the piece stack, last first.
void Interpreter::push_pieces(const ast::Tree& tree, ast::ExprId id, bool flatten) {
  const ast::Expr& e = tree.exprs[id];
  const auto sub = [&](ast::ExprId child, bool flat) {
    pieces_.push_back({&tree, child, 0, 0, false, flat, tree.exprs[child].span});
  };
  const auto punct = [&](char c) {
    pieces_.push_back({&tree, ast::none, c, 0, false, false, e.span});
  };
  // A macro next to an operator must be spelled out in full, whatever stands at its other side.
  if (const auto* b = std::get_if<ast::Binary>(&e.node)) {
    sub(b->right, true);
    punct(op_mark(b->op));
    sub(b->left, true);
  } else if (const auto* u = std::get_if<ast::Unary>(&e.node)) {
    sub(u->operand, true);
    punct(op_mark(u->op));
  } else if (const auto* c = std::get_if<ast::Conditional>(&e.node)) {
    sub(c->no, true);
    punct(':');
    sub(c->yes, true);
    punct('?');
    sub(c->condition, true);
  } else if (const auto* m = std::get_if<ast::Member>(&e.node);
             m != nullptr && needs_expansion(tree, m->object)) {
    pieces_.push_back({&tree, ast::none, 0, m->member, true, false, e.span});
    punct('.');
    sub(m->object, true);
  } else {
    sub(id, flatten);
  }
}

bool Interpreter::step_expansion(Token& token) {
  if (pieces_.size() == frames_.back().pieces) {
    pop();
    return false;
  }
  const Piece p = pieces_.back();
  pieces_.pop_back();
  token = Token{};
  token.tree = p.tree;
  token.span = p.span;
  if (p.expr == ast::none) {
    token.kind = p.is_word ? Token::Kind::word : Token::Kind::punct;
    token.punct = p.punct;
    token.word = p.word;
    return true;
  }
  const ast::Expr& e = p.tree->exprs[p.expr];
  const bool compound = std::holds_alternative<ast::Binary>(e.node) ||
                        std::holds_alternative<ast::Unary>(e.node) ||
                        std::holds_alternative<ast::Conditional>(e.node);
  const bool expands = needs_expansion(*p.tree, p.expr);
  if (expands && is_macro_call(*p.tree, p.expr)) {
    call_macro(*p.tree, p.expr, p.flatten);
    return false;
  }
  if (expands || (compound && p.flatten)) {
    push_pieces(*p.tree, p.expr, p.flatten);
    return false;
  }
  token.kind = Token::Kind::expr;
  token.expr = p.expr;
  return true;
}

// ---- nested readers ---------------------------------------------------------------------------

void Interpreter::Nested::open(const ast::Tree& tree) {
  depth_ = in_.frames_.size();
  unread_base_ = in_.unread_base_;
  in_.unread_base_ = in_.unread_.size();
  declare_depth_ = std::exchange(in_.declare_depth_, 0);
  in_.check_stack(in_.frames_.empty() ? Span{} : in_.frames_.back().call);
  if (++in_.nesting_ > max_nesting) {
    in_.fail(Code::limit, in_.frames_.back().call, "expressions are nested too deeply",
             "is a macro calling itself without end?");
  }
  Frame f;
  f.kind = Frame::Kind::barrier;
  f.tree = &tree;
  in_.push(f);
}

Interpreter::Nested::Nested(Interpreter& in, const ast::Tree& tree, ast::Range items, Span whole)
    : in_(in) {
  open(tree);
  in_.frames_.back().first = items.first;
  in_.frames_.back().pos = items.first;
  in_.frames_.back().end = items.first + items.count;
  in_.frames_.back().call =
      items.count > 0 ? tree.items[items.first + items.count - 1].span : whole;
}

Interpreter::Nested::Nested(Interpreter& in, const ast::Tree& tree, ast::ExprId expr) : in_(in) {
  open(tree);
  in_.frames_.back().call = tree.exprs[expr].span;
  in_.expand(tree, expr, false);
}

void Interpreter::Nested::finish(std::string_view what) {
  const Token t = in_.next();
  if (t.kind != Token::Kind::end) in_.unexpected(t, what);
}

void Interpreter::close_barrier(std::size_t depth, std::size_t unread_base,
                                std::size_t declare_depth) {
  declare_depth_ = declare_depth;
  while (frames_.size() > depth) pop();
  unread_.resize(unread_base_);
  unread_base_ = unread_base;
  --nesting_;
}

/// #break: ends the innermost loop, switch or macro (language §4.4).
void Interpreter::break_out(Span span) {
  while (!frames_.empty()) {
    const Frame::Kind kind = frames_.back().kind;
    if (kind == Frame::Kind::file || kind == Frame::Kind::barrier) break;
    pop();
    if (kind == Frame::Kind::while_ || kind == Frame::Kind::for_ || kind == Frame::Kind::switch_ ||
        kind == Frame::Kind::macro) {
      return;
    }
  }
  fail(Code::unbalanced, span, "`#break` outside of a loop, switch or macro");
}

}  // namespace durer::interpreter

#include "grammar/builder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

namespace durer::grammar {

using ast::ExprId;

namespace {

bool word_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool word_char(char c) { return word_start(c) || (c >= '0' && c <= '9'); }

// Text and its length are kept, so the C library sees a terminated copy only in the rare cases
// (overflow, underflow) that from_chars leaves open.
double to_double(std::string_view text) {
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc()) return value;
  return std::strtod(std::string(text).c_str(), nullptr);
}

std::string unescape_quotes(std::string_view literal) {
  std::string text;
  text.reserve(literal.size());
  for (std::size_t i = 0; i < literal.size(); ++i) {
    if (literal[i] == '\\' && i + 1 < literal.size()) {
      if (literal[i + 1] != '"') text += '\\';
      ++i;
    }
    text += literal[i];
  }
  return text;
}

ast::Op op_of(std::string_view text) {
  switch (text[0]) {
    case '+': return ast::Op::add;
    case '-': return ast::Op::sub;
    case '*': return ast::Op::mul;
    case '/': return ast::Op::div;
    case '=': return ast::Op::eq;
    case '!': return ast::Op::ne;
    case '&': return ast::Op::and_;
    case '|': return ast::Op::or_;
    case '<': return text.size() > 1 && text[1] == '=' ? ast::Op::le : ast::Op::lt;
    default: return text.size() > 1 && text[1] == '=' ? ast::Op::ge : ast::Op::gt;
  }
}

}  // namespace

Builder::Builder(std::string_view text, Loc base, SymbolTable& symbols, const Balance& balance,
                 const LiteralRuns& runs, ast::Tree& tree, bool lenient)
    : begin_(text.data()),
      end_(text.data() + text.size()),
      base_(base),
      symbols_(&symbols),
      balance_(&balance),
      runs_(&runs),
      tree_(&tree),
      last_end_(base),
      lenient_(lenient) {
  // Upper bounds, not guesses: a mesh of 30 MB must not be copied while it grows.
  tree.exprs.reserve(balance.operands + balance.operators);
  tree.expr_lists.reserve(balance.operands);
  items_.reserve(balance.operands + balance.operators + balance.marks);
  frames_.push_back({});
  frames_.back().open = {base, 0};
}

const Builder::Word* Builder::word_at(const char* at, const char* end) {
  if (at == word_.begin) return &word_;
  if (at == end || !word_start(*at)) return nullptr;
  const char* last = at + 1;
  while (last != end && word_char(*last)) ++last;
  word_.begin = at;
  word_.end = last;
  word_.id = symbols_->intern({at, static_cast<std::size_t>(last - at)});
  word_.word_class = symbols_->word_class(word_.id);
  return &word_;
}

Span Builder::token_span(std::string_view text) const {
  const Loc begin = span(text).begin;
  return {begin, last_end_ - begin};
}

// ---- recovery -----------------------------------------------------------------------------------

Builder::Checkpoint Builder::checkpoint() const {
  return {tree_->exprs.size(),
          tree_->expr_lists.size(),
          tree_->items.size(),
          tree_->groups.size(),
          tree_->directives.size(),
          tree_->branches.size(),
          tree_->cases.size(),
          tree_->params.size(),
          tree_->strings.size(),
          tree_->literals.size(),
          operands_.size(),
          items_.size(),
          frames_.size(),
          pending_.size(),
          branches_.size(),
          cases_.size(),
          depth_,
          last_end_};
}

void Builder::rollback(const Checkpoint& to) {
  tree_->exprs.resize(to.exprs);
  tree_->expr_lists.resize(to.expr_lists);
  tree_->items.resize(to.items);
  tree_->groups.resize(to.groups);
  tree_->directives.resize(to.directives);
  tree_->branches.resize(to.branches);
  tree_->cases.resize(to.cases);
  tree_->params.resize(to.params);
  tree_->strings.resize(to.strings);
  tree_->literals.resize(to.literals);
  operands_.resize(to.operands);
  items_.resize(to.waiting_items);
  frames_.resize(to.frames);
  pending_.resize(to.pending);
  branches_.resize(to.waiting_branches);
  cases_.resize(to.waiting_cases);
  depth_ = to.depth;
  last_end_ = to.last_end;
}

Failure Builder::failure(const char* at, std::string_view expected, Failure::Kind kind) const {
  return {at, expected, frames_.size() > 1 ? frames_.back().open : Span{}, kind};
}

void Builder::flaw(const char* item, const Failure& why) {
  tree_->flaws.push_back({char_span(item).begin, diagnostic(why)});
}

// A statement ends where its brackets are closed and, if the trouble was outside of them, the line.
const char* Builder::skip_bad_item(const char* at, const Failure& why) {
  flaws_of_file_.push_back(diagnostic(why));
  if (*at == '#') {
    const char* word = at + 1;
    while (word != end_ && *word == ' ') ++word;
    // The body of a directive whose head is bad would be taken for statements of the file.
    const Word* w = word_at(word, end_);
    const bool has_body = w == nullptr || w->id == words::if_ || w->id == words::ifdef ||
                          w->id == words::ifndef || w->id == words::while_ ||
                          w->id == words::for_ || w->id == words::switch_ || w->id == words::macro;
    if (has_body) return nullptr;
  }
  int depth = 0;
  bool quoted = false;
  for (const char* c = at; c != end_; ++c) {
    if (*c == '"' && (c == at || c[-1] != '\\')) quoted = !quoted;
    if (quoted) continue;
    if (*c == '{' || *c == '(' || *c == '[') ++depth;
    if ((*c == '}' || *c == ')' || *c == ']') && --depth <= 0 && c >= why.at) return c + 1;
    if (*c == '\n' && depth <= 0 && c >= why.at) return c;
  }
  return nullptr;
}

void Builder::enter(const char* at) {
  if (++depth_ > ast::max_nesting) throw failure(at, {}, Failure::Kind::nesting);
}

// ---- expressions --------------------------------------------------------------------------------

void Builder::too_deep(Span where) const {
  throw failure(begin_ + (where.begin - base_), {}, Failure::Kind::height);
}

ExprId Builder::pop() {
  const ExprId id = operands_.back();
  operands_.pop_back();
  return id;
}

void Builder::number(std::string_view text) {
  token(text);
  push(span(text), false, 1, ast::Number{to_double(text)});
}

void Builder::string(std::string_view text) {
  token(text);
  const auto index = static_cast<std::uint32_t>(tree_->strings.size());
  tree_->strings.push_back(unescape_quotes(text.substr(1, text.size() - 2)));
  push(span(text), false, 1, ast::String{index});
}

void Builder::name(std::string_view text) {
  token(text);
  push(span(text), false, 1, ast::Name{word_at(text.data(), end_)->id});
}

void Builder::unary(char op, const char* at) {
  const ExprId operand = pop();
  const ast::Expr& e = expr(operand);
  const ast::Op kind = op == '-' ? ast::Op::neg : op == '+' ? ast::Op::pos : ast::Op::not_;
  push(char_span(at).to(e.span), e.may_expand, e.height + 1U, ast::Unary{kind, operand});
}

void Builder::binary(std::string_view text) {
  const ast::Op op = op_of(text);
  ExprId right = pop();
  const ExprId left = pop();
  // In functions `a | b & c` is a | (b & c): the right side of an `|` of this very chain (it would
  // be a Paren otherwise) takes the `&` in (language §6.2).
  if (op == ast::Op::and_ && frames_.back().in_function) {
    if (const auto* chain = std::get_if<ast::Binary>(&expr(left).node);
        chain != nullptr && chain->op == ast::Op::or_) {
      const ast::Binary outer = *chain;
      const Span where = expr(outer.right).span.to(expr(right).span);
      const bool expands = expr(outer.right).may_expand || expr(right).may_expand;
      const std::uint32_t height = 1U + std::max(expr(outer.right).height, expr(right).height);
      push(where, expands, height, ast::Binary{op, outer.right, right});
      right = pop();
      push(expr(outer.left).span.to(expr(right).span), expr(left).may_expand || expands,
           1U + std::max(expr(outer.left).height, expr(right).height),
           ast::Binary{ast::Op::or_, outer.left, right});
      return;
    }
  }
  const ast::Expr& a = expr(left);
  const ast::Expr& b = expr(right);
  push(a.span.to(b.span), a.may_expand || b.may_expand, 1U + std::max(a.height, b.height),
       ast::Binary{op, left, right});
}

void Builder::conditional() {
  const ExprId no = pop();
  const ExprId yes = pop();
  const ExprId condition = pop();
  const std::array parts = {&expr(condition), &expr(yes), &expr(no)};
  push(parts[0]->span.to(parts[2]->span),
       parts[0]->may_expand || parts[1]->may_expand || parts[2]->may_expand,
       1U + std::max({parts[0]->height, parts[1]->height, parts[2]->height}),
       ast::Conditional{condition, yes, no});
}

void Builder::member(std::string_view text) {
  token(text);
  const ExprId object = pop();
  const ast::Expr& e = expr(object);
  push(e.span.to(span(text)), e.may_expand, e.height + 1U,
       ast::Member{object, word_at(text.data(), end_)->id});
}

std::uint32_t Builder::height_of(ast::Range list) const {
  std::uint16_t height = 0;
  for (std::uint32_t i = 0; i < list.count; ++i) {
    height = std::max(height, expr(tree_->expr_lists[list.first + i]).height);
  }
  return height;
}

bool Builder::may_expand(ast::Range list) const {
  for (std::uint32_t i = 0; i < list.count; ++i) {
    if (expr(tree_->expr_lists[list.first + i]).may_expand) return true;
  }
  return false;
}

// ---- frames of expressions ----------------------------------------------------------------------

void Builder::open(FrameKind kind, const char* at, bool in_function, bool arguments) {
  Frame f;
  f.kind = kind;
  f.in_function = in_function;
  f.arguments = arguments;
  f.bodies = frames_.back().bodies;
  if (const ast::Item* last = last_item();
      kind == FrameKind::braces && last != nullptr && last->kind == ast::ItemKind::expr) {
    const auto* name = std::get_if<ast::Name>(&expr(last->ref).node);
    f.dictionary = name != nullptr && name->name == additions::dictionary;
  }
  f.open = char_span(at);
  f.items = static_cast<std::uint32_t>(items_.size());
  f.operands = static_cast<std::uint32_t>(operands_.size());
  frames_.push_back(f);
  last_end_ = f.open.end();
}

ast::Range Builder::take_items() {
  const auto from = items_.begin() + frames_.back().items;
  const ast::Range taken{static_cast<std::uint32_t>(tree_->items.size()),
                         static_cast<std::uint32_t>(items_.end() - from)};
  tree_->items.insert(tree_->items.end(), from, items_.end());
  items_.erase(from, items_.end());
  return taken;
}

// Expressions with a comma or nothing between them, and perhaps a comma at the end.
bool Builder::plain_list(ast::Range& out) {
  const std::uint32_t first = frames_.back().items;
  bool comma_allowed = false;
  for (std::size_t i = first; i < items_.size(); ++i) {
    const ast::Item& item = items_[i];
    const bool comma = item.kind == ast::ItemKind::punct && item.detail == ',' && comma_allowed;
    if (!comma && item.kind != ast::ItemKind::expr) return false;
    comma_allowed = !comma;
  }
  out.first = static_cast<std::uint32_t>(tree_->expr_lists.size());
  for (std::size_t i = first; i < items_.size(); ++i) {
    if (items_[i].kind == ast::ItemKind::expr) tree_->expr_lists.push_back(items_[i].ref);
  }
  out.count = static_cast<std::uint32_t>(tree_->expr_lists.size()) - out.first;
  return true;
}

/// True if a comma closes the list of the innermost frame: whoever reads it decides what that means.
bool Builder::ends_in_comma() const {
  return items_.size() > frames_.back().items && items_.back().kind == ast::ItemKind::punct &&
         items_.back().detail == ',';
}

void Builder::close_open_group(Span where, ast::OpenGroup group) {
  group.items = take_items();
  frames_.pop_back();
  push(where, true, 1, group);
}

void Builder::close_paren(const char* at) {
  const Frame frame = frames_.back();
  const Span where = frame.open.to(char_span(at));
  last_end_ = where.end();
  const bool plain = items_.size() == frame.items + 1U && items_.back().kind == ast::ItemKind::expr;
  if (!plain) return close_open_group(where, {ast::OpenGroup::Kind::paren, ast::none, 0, {}});
  const ExprId inner = items_.back().ref;
  items_.pop_back();
  frames_.pop_back();
  push(where, expr(inner).may_expand, expr(inner).height + 1U, ast::Paren{inner});
}

void Builder::close_call(const char* at) {
  const ExprId callee = pop();
  const Span where = expr(callee).span.to(char_span(at));
  last_end_ = where.end();
  ast::Range args;
  if (ends_in_comma() || !plain_list(args)) {
    return close_open_group(where, {ast::OpenGroup::Kind::call, callee, 0, {}});
  }
  items_.resize(frames_.back().items);
  frames_.pop_back();
  const auto* name = std::get_if<ast::Name>(&expr(callee).node);
  const bool user = name == nullptr || !symbols_->reserved(name->name);
  push(where, user || may_expand(args),
       1U + std::max<std::uint32_t>(height_of(args), expr(callee).height), ast::Call{callee, args});
}

// A subscript waits in the index frame around it: as its expression if it is one, else as brackets.
void Builder::close_subscript(const char* at) {
  const Frame frame = frames_.back();
  const Span where = frame.open.to(char_span(at));
  last_end_ = where.end();
  const bool plain = items_.size() == frame.items + 1U && items_.back().kind == ast::ItemKind::expr;
  if (plain) {
    frames_.pop_back();
    items_.back().span = where;
    return;
  }
  close_group(ast::ItemKind::brackets, at);
}

void Builder::close_index() {
  const Frame frame = frames_.back();
  const ExprId array = pop();
  const auto* array_name = std::get_if<ast::Name>(&expr(array).node);
  const Span where = expr(array).span.to({last_end_ - 1, 1});
  if (array_name == nullptr) return close_element(array, where);
  const SymbolId name = array_name->name;
  const auto from = items_.begin() + frame.items;
  const bool plain = std::all_of(from, items_.end(),
                                 [](const ast::Item& i) { return i.kind == ast::ItemKind::expr; });
  if (plain) {
    ast::Range subscripts;
    plain_list(subscripts);
    items_.resize(frame.items);
    frames_.pop_back();
    push(where, may_expand(subscripts), 1U + height_of(subscripts), ast::Index{name, subscripts});
    return;
  }
  for (auto item = from; item != items_.end(); ++item) {
    if (item->kind != ast::ItemKind::expr) continue;
    const ast::Range inner{static_cast<std::uint32_t>(tree_->items.size()), 1};
    tree_->items.push_back({ast::ItemKind::expr, 0, item->ref, expr(item->ref).span});
    tree_->groups.push_back({inner, {item->span.begin, 1}, {item->span.end() - 1, 1}});
    item->kind = ast::ItemKind::brackets;
    item->ref = static_cast<std::uint32_t>(tree_->groups.size() - 1);
  }
  close_open_group(where, {ast::OpenGroup::Kind::index, ast::none, name, {}});
}

// Subscripts of an entry of a dictionary: plain ones only.
void Builder::close_element(ExprId object, Span where) {
  const Frame frame = frames_.back();
  ast::Range subscripts;
  if (!plain_list(subscripts)) {
    throw failure(begin_ + (frame.open.begin - base_), "plain numbers as subscripts");
  }
  items_.resize(frame.items);
  frames_.pop_back();
  push(where, expr(object).may_expand || may_expand(subscripts),
       1U + std::max<std::uint32_t>(height_of(subscripts), expr(object).height),
       ast::Element{object, subscripts});
}

bool Builder::close_vector(const char* at) {
  const Frame frame = frames_.back();
  const Span where = frame.open.to(char_span(at));
  ast::Range components;
  if (plain_list(components)) {
    const bool trailing_comma = !items_.empty() && items_.back().kind == ast::ItemKind::punct;
    // A comma may follow any component but the fifth (language §1.8).
    if (components.count == 0 || (components.count == 5 && trailing_comma)) return false;
    last_end_ = where.end();
    items_.resize(frame.items);
    frames_.pop_back();
    push(where, may_expand(components), 1U + height_of(components), ast::Vector{components});
    return true;
  }
  if (!frame.directive_seen) return false;
  last_end_ = where.end();
  close_open_group(where, {ast::OpenGroup::Kind::vector, ast::none, 0, {}});
  return true;
}

}  // namespace durer::grammar

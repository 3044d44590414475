// The part of the builder that makes items, and answers the grammar's questions about those before.
#include <algorithm>
#include <array>

#include "grammar/builder.h"

namespace durer::grammar {

using ast::ItemKind;

void Builder::push_item(ItemKind kind, std::uint32_t ref, Span where, char detail) {
  items_.push_back({kind, detail, ref, where});
}

const ast::Item* Builder::last_item() const {
  return items_.size() > frames_.back().items ? &items_.back() : nullptr;
}

void Builder::expression_item() {
  const ast::ExprId id = pop();
  push_item(ItemKind::expr, id, expr(id).span);
}

bool Builder::resume_expression() {
  if (!after_operand()) return false;
  operands_.push_back(items_.back().ref);
  return true;
}

void Builder::resumed_item() {
  const ast::ExprId id = pop();
  items_.back().ref = id;
  items_.back().span = expr(id).span;
}

std::size_t Builder::literals_item(const char* at) {
  const LiteralRun* run = runs_->at(at);
  if (run == nullptr) return 0;
  token(run->text);
  push_item(ItemKind::literals, static_cast<std::uint32_t>(tree_->literals.size()),
            span(run->text));
  tree_->literals.push_back(*run);
  return run->text.size();
}

void Builder::word_item(std::string_view text) {
  token(text);
  push_item(ItemKind::word, word_at(text.data(), end_)->id, span(text));
}

void Builder::mark(std::string_view text) {
  token(text);
  const char detail = text.size() == 1 ? text[0]
                      : text[0] == '<' ? 'l'
                      : text[0] == '>' ? 'g'
                                       : 'n';
  push_item(ItemKind::punct, 0, span(text), detail);
}

void Builder::close_group(ItemKind kind, const char* at) {
  const Span open = frames_.back().open;
  const Span close = char_span(at);
  last_end_ = close.end();
  tree_->groups.push_back({take_items(), open, close});
  frames_.pop_back();
  push_item(kind, static_cast<std::uint32_t>(tree_->groups.size() - 1), open.to(close));
}

void Builder::close_file() { tree_->top = take_items(); }

// ---- what may stand here ------------------------------------------------------------------------

/// `detail`s of marks that only expressions of the full level have.
static bool is_full_mark(char c) {
  return std::string_view("=<>!&|?:lgn").find(c) != std::string_view::npos;
}

bool Builder::mark_allowed(const char* at) const {
  const char c = *at;
  const Frame& frame = frames_.back();
  if (frame.kind == FrameKind::vector) {
    return frame.directive_seen && (c == '+' || c == '-' || c == '*' || c == '/' || c == '.');
  }
  if (c == ',' || c == ';' || in_body() || is_stray(at)) return true;
  if (frame.dictionary && (c == ':' || c == '.')) return true;  // `["key"]: 1, .key: 2`
  const ast::Item* last = last_item();
  if (last == nullptr) return frame.kind == FrameKind::file;  // of an include inside an expression
  switch (last->kind) {
    case ItemKind::directive: return true;
    case ItemKind::expr: {
      // `declare X = 1` without `#`, as very old scenes have it.
      const bool old_declare = c == '=' && items_.size() > frame.items + 1U &&
                               items_[items_.size() - 2].kind == ItemKind::word;
      return expr(last->ref).may_expand || old_declare || (is_full_mark(c) && after_colour());
    }
    case ItemKind::literals: return !tree_->literals[last->ref].comma_after;
    case ItemKind::punct: return last->detail != ',' && last->detail != ';';
    default: return false;
  }
}

bool Builder::function_ahead() const {
  // `function {`, `function (a, b) {`, `function 9, 9 {`: a few operands at most.
  const std::uint32_t first = frames_.back().items;
  std::size_t looked = 0;
  for (std::size_t i = items_.size(); i > first && looked < 8; --i, ++looked) {
    const ast::Item& item = items_[i - 1];
    if (item.kind == ItemKind::word) return item.ref == words::function;
    const bool comma = item.kind == ItemKind::punct && item.detail == ',';
    if (item.kind != ItemKind::expr && !comma) return false;
  }
  return false;
}

bool Builder::after_entry() const {
  if (operands_.size() == frames_.back().operands || operands_.back() == ast::none) return false;
  const auto& node = expr(operands_.back()).node;
  if (std::holds_alternative<ast::Element>(node)) return true;
  const auto* member = std::get_if<ast::Member>(&node);
  return member != nullptr && !symbols_->reserved(member->member);
}

bool Builder::after_colour() const {
  constexpr std::array<SymbolId, 10> words_of_colours = {
      words::rgb,  words::rgbf,  words::rgbt,  words::rgbft,  words::color,
      words::srgb, words::srgbf, words::srgbt, words::srgbft, words::colour};
  // Back over `operand mark operand mark …` to the word.
  std::size_t at = items_.size();
  const std::size_t first = frames_.back().items;
  while (at >= first + 2 && items_[at - 1].kind == ItemKind::expr) {
    const ast::Item& before = items_[at - 2];
    if (before.kind == ItemKind::word) {
      return std::find(words_of_colours.begin(), words_of_colours.end(), before.ref) !=
             words_of_colours.end();
    }
    if (before.kind != ItemKind::punct || !is_full_mark(before.detail)) return false;
    at -= 2;
  }
  return false;
}

bool Builder::after_operand() const {
  const ast::Item* last = last_item();
  return last != nullptr && last->kind == ItemKind::expr;
}

bool Builder::made_single_component() const {
  if (operands_.empty()) return false;
  const ast::Expr& e = expr(operands_.back());
  const auto* v = std::get_if<ast::Vector>(&e.node);
  return v != nullptr && v->components.count == 1 && !e.may_expand;
}

bool Builder::relation_only() const {
  const Frame& frame = frames_.back();
  const bool full_level = (frame.kind == FrameKind::paren && !frame.arguments) ||
                          (frame.kind == FrameKind::braces && frame.in_function);
  return full_level && after_operand();
}

bool Builder::relation_possible(bool seen) const {
  const ast::Item* last = last_item();
  if (seen || after_colour() || (last != nullptr && last->kind == ItemKind::directive)) return true;
  return frames_.back().arguments && after_operand();
}

}  // namespace durer::grammar

// The part of the builder that makes directives and their bodies.
#include "grammar/builder.h"

#include <algorithm>

namespace durer::grammar {

using ast::ExprId;

void Builder::push_directive(ast::Directive d) {
  const auto id = static_cast<std::uint32_t>(tree_->directives.size());
  const Span where = d.span;
  tree_->directives.push_back(std::move(d));
  frames_.back().directive_seen = true;
  push_item(ast::ItemKind::directive, id, where);
}

bool returns_text(SymbolId function) {
  switch (function) {
    case words::chr:
    case words::concat:
    case words::datetime:
    case words::str:
    case words::strlwr:
    case words::strupr:
    case words::substr:
    case words::vstr: return true;
    default: return false;
  }
}

ast::Directive& Builder::last_directive() { return tree_->directives[items_.back().ref]; }

// ---- values -------------------------------------------------------------------------------------

void Builder::deprecated(bool once) {
  deprecated_ = true;
  deprecated_once_ = once;
}

// Subscripts to be read item by item become parentheses to be read so.
Builder::Target Builder::target_of(ExprId target) {
  if (const auto* name = std::get_if<ast::Name>(&expr(target).node)) return {name->name, {}};
  if (const auto* index = std::get_if<ast::Index>(&expr(target).node)) {
    const bool scope = index->name == words::local || index->name == additions::global;
    return {index->name, index->subscripts, scope ? target : ast::none};
  }
  if (!std::holds_alternative<ast::OpenGroup>(expr(target).node)) {
    // An entry: the name is that of the outermost dictionary.
    ExprId outer = target;
    for (;;) {
      const auto& node = expr(outer).node;
      if (const auto* member = std::get_if<ast::Member>(&node)) {
        outer = member->object;
      } else if (const auto* element = std::get_if<ast::Element>(&node)) {
        outer = element->object;
      } else {
        break;
      }
    }
    return {target_of(outer).name, {}, target};
  }
  const auto group = std::get<ast::OpenGroup>(expr(target).node);
  Target place{group.name, {static_cast<std::uint32_t>(tree_->expr_lists.size()), 0}};
  for (; place.subscripts.count < group.items.count; ++place.subscripts.count) {
    const ast::Item& item = tree_->items[group.items.first + place.subscripts.count];
    const ast::Range inside = tree_->groups[item.ref].items;
    push(item.span, true, 1, ast::OpenGroup{ast::OpenGroup::Kind::paren, ast::none, 0, inside});
    tree_->expr_lists.push_back(pop());
  }
  return place;
}

void Builder::begin_declare(std::string_view head, bool local) {
  ast::Declare d;
  d.local = local;
  d.deprecated = deprecated_;
  d.deprecated_once = deprecated_once_;
  const ExprId target = pop();
  d.target = expr(target).span;
  const Target place = target_of(target);
  d.name = place.name;
  d.subscripts = place.subscripts;
  d.place = place.place;
  if (operands_.size() > frames_.back().operands) d.deprecated_message = pop();
  deprecated_ = deprecated_once_ = false;
  push_directive({token_span(head), d});
}

void Builder::begin_tuple(std::string_view head, bool local) {
  ast::Tuple t;
  t.local = local;
  t.kind = *(begin_ + (frames_.back().open.begin - base_));
  const auto from = operands_.begin() + frames_.back().operands;
  t.targets = {static_cast<std::uint32_t>(tree_->expr_lists.size()),
               static_cast<std::uint32_t>(operands_.end() - from)};
  tree_->expr_lists.insert(tree_->expr_lists.end(), from, operands_.end());
  operands_.erase(from, operands_.end());
  frames_.pop_back();
  push_directive({token_span(head), t});
}

void Builder::declared_value(bool semicolon) {
  const ExprId value = pop();
  ast::Directive& d = last_directive();
  auto& declare = std::get<ast::Declare>(d.node);
  declare.value = value;
  declare.semicolon = semicolon;
  d.span.size = last_end_ - d.span.begin;
  items_.back().span = d.span;
}

void Builder::open_value(const char* next) {
  const ast::Expr& e = expr(operands_.back());
  bool closed = std::holds_alternative<ast::String>(e.node);
  if (const auto* call = std::get_if<ast::Call>(&e.node)) {
    const auto* callee = std::get_if<ast::Name>(&expr(call->callee).node);
    closed = callee != nullptr && returns_text(callee->name);
  } else if (std::holds_alternative<ast::Name>(e.node)) {
    closed = next == end_ || *next == '}' || (word_at(next, end_) != nullptr);
  }
  if (closed) {
    declared_value(false);
  } else {
    expression_item();
  }
}

void Builder::undef(std::string_view head) {
  const Target place = target_of(pop());
  push_directive({token_span(head), ast::Undef{place.name, place.subscripts, place.place}});
}

void Builder::directive_operand() {
  const ExprId value = pop();
  ast::Directive& d = last_directive();
  if (auto* include = std::get_if<ast::Include>(&d.node)) include->value = value;
  if (auto* version = std::get_if<ast::Version>(&d.node)) version->value = value;
  if (auto* message = std::get_if<ast::Message>(&d.node)) message->value = value;
  d.span.size = last_end_ - d.span.begin;
  items_.back().span = d.span;
}

void Builder::unknown_word(std::string_view text) {
  token(text);
  unknown_word_ = word_at(text.data(), end_)->id;
}

void Builder::unknown(std::string_view head) {
  push_directive({token_span(head), ast::Unknown{unknown_word_}});
}

// ---- bodies -------------------------------------------------------------------------------------

void Builder::open_body(Span head) {
  const bool in_function = frames_.back().in_function;
  open(FrameKind::body, begin_ + (head.begin - base_), in_function);
  frames_.back().open = head;
  ++frames_.back().bodies;
}

ast::Body Builder::close_body() {
  ast::Body body{take_items()};
  body.shape = shape_of(body);
  frames_.pop_back();
  return body;
}

ast::Body::Shape Builder::shape_of(ast::Range items) const {
  using Shape = ast::Body::Shape;
  for (std::uint32_t i = 0; i < items.count; ++i) {
    const ast::Item& item = tree_->items[items.first + i];
    if (is_statement(item)) continue;
    const bool last = i + 1 == items.count;
    return last && item.kind == ast::ItemKind::expr ? Shape::value : Shape::open;
  }
  return Shape::statements;
}

/// True for directives whose operands and bodies hold all they need: running one neither delivers
/// nor takes any token.
bool Builder::is_statement(const ast::Item& item) const {
  if (item.kind != ast::ItemKind::directive) return false;
  using Shape = ast::Body::Shape;
  const auto& node = tree_->directives[item.ref].node;
  if (const auto* d = std::get_if<ast::Declare>(&node)) return d->value != ast::none;
  if (const auto* d = std::get_if<ast::Message>(&node)) return d->value != ast::none;
  if (const auto* d = std::get_if<ast::Version>(&node)) return d->value != ast::none;
  if (const auto* d = std::get_if<ast::While>(&node)) return d->items.shape == Shape::statements;
  if (const auto* d = std::get_if<ast::For>(&node)) return d->items.shape == Shape::statements;
  if (const auto* d = std::get_if<ast::If>(&node)) {
    const auto* from = tree_->branches.data() + d->branches.first;
    return std::all_of(from, from + d->branches.count, [](const ast::Branch& b) {
      return b.items.shape == Shape::statements;
    });
  }
  if (const auto* d = std::get_if<ast::Switch>(&node)) {
    const auto* from = tree_->cases.data() + d->cases.first;
    return std::all_of(from, from + d->cases.count, [](const ast::Case& c) {
      return c.items.shape == Shape::statements;
    });
  }
  return std::holds_alternative<ast::Undef>(node) || std::holds_alternative<ast::Break>(node) ||
         std::holds_alternative<ast::Macro>(node);
}

namespace {
/// An operand into which no operator beside it can reach.
bool is_atomic(const ast::Tree& tree, ast::ExprId id) {
  const auto& node = tree.exprs[id].node;
  if (const auto* call = std::get_if<ast::Call>(&node)) {
    const auto* callee = std::get_if<ast::Name>(&tree.exprs[call->callee].node);
    return callee != nullptr && callee->name < words::count_;  // else it may be a macro in turn
  }
  return std::holds_alternative<ast::Number>(node) || std::holds_alternative<ast::Name>(node) ||
         std::holds_alternative<ast::Paren>(node) || std::holds_alternative<ast::Vector>(node) ||
         std::holds_alternative<ast::Index>(node);
}
}  // namespace

void Builder::begin_if(std::string_view head, ast::Branch::Kind kind) {
  const Span where = token_span(head);
  pending_.push_back({{where, ast::If{}}, static_cast<std::uint32_t>(branches_.size()), 0});
  branches_.push_back({kind, pop(), {}, where});
  open_body(where);
}

void Builder::finish_branch() { branches_.back().items = close_body(); }

void Builder::next_branch(std::string_view head, ast::Branch::Kind kind) {
  const Span where = token_span(head);
  const ExprId condition = kind == ast::Branch::Kind::else_ ? ast::none : pop();
  finish_branch();
  branches_.push_back({kind, condition, {}, where});
  open_body(where);
}

void Builder::end_if() {
  finish_branch();
  Pending p = std::move(pending_.back());
  pending_.pop_back();
  const auto from = branches_.begin() + p.branches;
  auto& node = std::get<ast::If>(p.directive.node);
  node.branches = {static_cast<std::uint32_t>(tree_->branches.size()),
                   static_cast<std::uint32_t>(branches_.end() - from)};
  tree_->branches.insert(tree_->branches.end(), from, branches_.end());
  branches_.erase(from, branches_.end());
  push_directive(std::move(p.directive));
}

void Builder::begin_switch(std::string_view head) {
  pending_.push_back(
      {{token_span(head), ast::Switch{pop(), {}}}, 0, static_cast<std::uint32_t>(cases_.size())});
}

void Builder::finish_case() {
  if (cases_.size() > pending_.back().cases) cases_.back().items = close_body();
}

void Builder::next_case(std::string_view head, ast::Case::Kind kind) {
  ast::Case c;
  c.kind = kind;
  c.span = token_span(head);
  if (kind == ast::Case::Kind::range) c.high = pop();
  if (kind != ast::Case::Kind::else_) c.low = pop();
  finish_case();
  cases_.push_back(c);
  open_body(c.span);
}

void Builder::end_switch() {
  finish_case();
  Pending p = std::move(pending_.back());
  pending_.pop_back();
  const auto from = cases_.begin() + p.cases;
  auto& node = std::get<ast::Switch>(p.directive.node);
  node.cases = {static_cast<std::uint32_t>(tree_->cases.size()),
                static_cast<std::uint32_t>(cases_.end() - from)};
  tree_->cases.insert(tree_->cases.end(), from, cases_.end());
  cases_.erase(from, cases_.end());
  push_directive(std::move(p.directive));
}

void Builder::begin_while(std::string_view head) {
  const Span where = token_span(head);
  pending_.push_back({{where, ast::While{pop(), {}}}, 0, 0});
  open_body(where);
}

void Builder::begin_for(std::string_view head) {
  const std::uint32_t first = frames_.back().operands;
  ast::For f;
  f.name = std::get<ast::Name>(expr(operands_[first]).node).name;
  f.start = operands_[first + 1];
  f.end = operands_[first + 2];
  if (operands_.size() > first + 3) f.step = operands_[first + 3];
  operands_.resize(first);
  frames_.pop_back();
  const Span where = token_span(head);
  pending_.push_back({{where, f}, 0, 0});
  open_body(where);
}

void Builder::macro_param(std::string_view text) {
  token(text);
  tree_->params.push_back({word_at(text.data(), end_)->id, span(text)});
}

void Builder::begin_macro(std::string_view head) {
  const ExprId name = pop();
  ast::Macro m;
  m.name = std::get<ast::Name>(expr(name).node).name;
  m.head = expr(name).span.to({last_end_ - 1, 1});
  // Parameters of a macro follow each other in the tree: no other macro can begin in a head.
  while (m.params.count < tree_->params.size() &&
         tree_->params[tree_->params.size() - m.params.count - 1].span.begin > m.head.begin) {
    ++m.params.count;
  }
  m.params.first = static_cast<std::uint32_t>(tree_->params.size()) - m.params.count;
  const Span where = token_span(head);
  pending_.push_back({{where, m}, 0, 0});
  open_body(where);
}

void Builder::end_loop_or_macro() {
  const ast::Body items = close_body();
  Pending p = std::move(pending_.back());
  pending_.pop_back();
  if (auto* loop = std::get_if<ast::While>(&p.directive.node)) loop->items = items;
  if (auto* loop = std::get_if<ast::For>(&p.directive.node)) loop->items = items;
  if (auto* macro = std::get_if<ast::Macro>(&p.directive.node)) {
    macro->items = items;
    macro->atomic = items.shape == ast::Body::Shape::value &&
                    is_atomic(*tree_, tree_->items[items.first + items.count - 1].ref);
  }
  push_directive(std::move(p.directive));
}

}  // namespace durer::grammar

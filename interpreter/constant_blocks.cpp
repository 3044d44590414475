// Blocks that mean the same whenever they are met, such as `finish { phong 0.5 }`: in loops and
// macros they are read once, and those who use them share what was read.
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

/// A number, or a vector of numbers.
bool is_literal(const ast::Tree& tree, ast::ExprId id) {
  const auto& node = tree.exprs[id].node;
  if (std::holds_alternative<ast::Number>(node)) return true;
  if (const auto* u = std::get_if<ast::Unary>(&node)) return is_literal(tree, u->operand);
  const auto* v = std::get_if<ast::Vector>(&node);
  if (v == nullptr) return false;
  for (std::uint32_t i = 0; i < v->components.count; ++i) {
    if (!is_literal(tree, tree.expr_lists[v->components.first + i])) return false;
  }
  return true;
}

/// No names, no directives, nothing that depends on settings made elsewhere.
bool is_constant(const ast::Tree& tree, ast::Range items) {
  for (std::uint32_t i = 0; i < items.count; ++i) {
    const ast::Item& item = tree.items[items.first + i];
    switch (item.kind) {
      case ast::ItemKind::word:
        if (item.ref == w::srgb || item.ref == w::srgbf || item.ref == w::srgbt ||
            item.ref == w::srgbft) {
          return false;
        }
        break;
      case ast::ItemKind::punct: break;
      case ast::ItemKind::braces:
      case ast::ItemKind::brackets:
        if (!is_constant(tree, tree.groups[item.ref].items)) return false;
        break;
      case ast::ItemKind::expr:
        if (!is_literal(tree, item.ref)) return false;
        break;
      case ast::ItemKind::directive:
      case ast::ItemKind::literals: return false;
    }
  }
  return true;
}

}  // namespace

/// The block that comes next, if it is constant and likely to come again.
const ast::Group* Interpreter::constant_block() {
  const Frame& f = frames_.back();
  if (repeats_ == 0 || !options_.shortcuts || unread_.size() > unread_base_ || !f.has_items() || f.pos >= f.end) {
    return nullptr;
  }
  const ast::Item& item = f.tree->items[f.pos];
  if (item.kind != ast::ItemKind::braces) return nullptr;
  const ast::Group& group = f.tree->groups[item.ref];
  return is_constant_block(*f.tree, group) ? &group : nullptr;
}

bool Interpreter::is_constant_block(const ast::Tree& tree, const ast::Group& group) {
  const auto [known, is_new] = constant_.try_emplace(&group, false);
  if (is_new) known->second = is_constant(tree, group.items);
  return known->second;
}

/// What the block has made of `start` before; null if that is not known.
const Boxed<scene::Finish>* Interpreter::known_finish(const ast::Group& block,
                                                      const Boxed<scene::Finish>& start) const {
  const auto known = finishes_.find(FinishKey{&block, start.identity(), declared_version_});
  return known == finishes_.end() ? nullptr : &known->second.made;
}

/// After the word `finish`: the finish that the block makes of `start`.
Boxed<scene::Finish> Interpreter::read_shared_finish(const Boxed<scene::Finish>& start) {
  const ast::Group* block = constant_block();
  if (block == nullptr) return read_finish(*start);
  if (const Boxed<scene::Finish>* known = known_finish(*block, start)) {
    ++frames_.back().pos;
    return *known;
  }
  const FinishKey key{block, start.identity(), declared_version_};
  Boxed<scene::Finish> made = read_finish(*start);
  // Holding `start` keeps its identity from becoming that of another.
  finishes_.emplace(key, KnownFinish{start, made});
  return made;
}

}  // namespace durer::interpreter

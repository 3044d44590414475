// The objects that programs write by the hundred thousand: operands that are plain expressions,
// then transformations, a colour, a finish. They are read right from the items of their block;
// whatever is unusual is left to the readers of objects.cpp, which go on from there.
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// The innermost frame, if what comes next is an item of it as it is written.
Frame* Interpreter::plain_items() {
  if (!takes_shortcuts()) return nullptr;
  Frame& f = frames_.back();
  const bool plain =
      unread_.size() == unread_base_ && f.kind == Frame::Kind::group && !f.flatten;
  return plain ? &f : nullptr;
}

/// True if the item is a whole expression, ready to be worked out.
bool Interpreter::is_operand(const Frame& f, std::uint32_t pos) const {
  if (pos >= f.end) return false;
  const ast::Item& item = f.tree->items[pos];
  return item.kind == ast::ItemKind::expr && ends_expression(f, pos + 1, false) &&
         !(f.tree->exprs[item.ref].may_expand && needs_expansion(*f.tree, item.ref));
}

/// The operands of a primitive whose block has been opened; false, with nothing read, if they are
/// not as plain as that.
bool Interpreter::quick_operands(const scene::TypeInfo& info, std::vector<double>& args,
                                 const Token& word) {
  const OperandPlan& plan = operand_plan(info);
  const Frame* f = plan.simple && plan.positional > 0 ? plain_items() : nullptr;
  if (f == nullptr) return false;
  const ast::Tree& tree = *f->tree;
  const std::uint32_t begin = f->pos;
  const auto is_comma = [&tree, end = f->end](std::uint32_t pos) {
    return pos < end && tree.items[pos].kind == ast::ItemKind::punct &&
           tree.items[pos].detail == ',';
  };
  std::uint32_t pos = begin;
  for (std::size_t i = 0; i < plan.positional; ++i) {
    if (!is_operand(*f, pos)) return false;
    ++pos;
    if (i + 1 < plan.positional && is_comma(pos)) ++pos;
  }
  if (is_comma(pos)) return false;  // none may follow the last (language §1.8)
  if (plan.has_words && pos < f->end && tree.items[pos].kind == ast::ItemKind::word) {
    const std::string_view next_word = name_of(tree.items[pos].ref);
    for (const scene::Param& p : info.params) {
      if (!p.positional && p.name == next_word) return false;
    }
  }
  // A name alone may be an object, of which this one is a copy.
  const ast::Expr& first = tree.exprs[tree.items[begin].ref];
  if (std::holds_alternative<ast::Member>(first.node) ||
      std::holds_alternative<ast::Element>(first.node) || array_of(first)) {
    return false;
  }
  if (const auto* name = std::get_if<ast::Name>(&first.node); name != nullptr) {
    const Value* v = Environment::value_of(env_.find(name->name));
    if (!symbols_.reserved(name->name) && (v == nullptr || !v->is_num())) return false;
  }
  args = plan.fallback;
  pos = begin;
  for (std::size_t i = 0; i < plan.positional; ++i, ++pos) {
    const ast::ExprId id = tree.items[pos].ref;
    double* out = &args[plan.offsets[i]];
    last_span_ = tree.items[pos].span;
    if (info.params[i].kind == scene::ArgKind::number) {
      *out = work_out_float(tree, id, info.params[i].doc);
    } else {
      const Num n = evaluate(tree, id, 3);
      fit(n, 3);
      for (std::size_t k = 0; k < 3; ++k) out[k] = n.v[k];
    }
    if (i + 1 < plan.positional && is_comma(pos + 1)) ++pos;
  }
  frames_.back().pos = pos;
  check_operands(info, args, word);
  return true;
}

/// One modifier; false, with nothing read, if it is not one of the commonest.
bool Interpreter::quick_modifier(scene::Object& o) {
  Frame* f = plain_items();
  if (f == nullptr || f->pos + 1 >= f->end) return false;
  const ast::Tree& tree = *f->tree;
  const ast::Item& item = tree.items[f->pos];
  if (item.kind != ast::ItemKind::word) return false;
  switch (item.ref) {
    case w::translate:
    case w::rotate:
    case w::scale: {
      if (!is_operand(*f, f->pos + 1)) return false;
      const ast::Item& by = tree.items[f->pos + 1];
      f->pos += 2;
      last_span_ = by.span;
      const Num n = evaluate(tree, by.ref, 3);
      transform_object(o, transformation(item.ref, fit(n, 3).vec(), item.span));
      return true;
    }
    case w::pigment:
    case w::finish: {
      Token word;
      word.kind = Token::Kind::word;
      word.tree = &tree;
      word.span = item.span;
      word.word = item.ref;
      ++f->pos;
      edit_texture(o.texture, word);
      return true;
    }
    default: return false;
  }
}

}  // namespace durer::interpreter

// What can be known of a statement when it is met for the first time in a loop or macro.
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

bool is_punct(const ast::Item& item, char c) {
  return item.kind == ast::ItemKind::punct && item.detail == c;
}

/// Expressions that stand for a number or vector wherever there is a formula for them. Names and
/// what leads through arrays may stand for anything.
bool is_computed(const ast::Expr& e) {
  return std::holds_alternative<ast::Number>(e.node) || std::holds_alternative<ast::Binary>(e.node) ||
         std::holds_alternative<ast::Unary>(e.node) || std::holds_alternative<ast::Paren>(e.node) ||
         std::holds_alternative<ast::Vector>(e.node) || std::holds_alternative<ast::Call>(e.node);
}

}  // namespace

Statement& Interpreter::new_statement(const ast::Tree& tree, std::uint32_t pos) {
  std::vector<std::unique_ptr<Statement>>& known = statements_of_[tree.file];
  if (known.empty()) known.resize(tree.items.size());
  known[pos] = std::make_unique<Statement>();
  prepare(*known[pos], tree, pos);
  return *known[pos];
}

void Interpreter::prepare(Statement& s, const ast::Tree& tree, std::uint32_t pos) {
  const ast::Item& item = tree.items[pos];
  s.kind = Statement::Kind::general;
  if (item.kind == ast::ItemKind::directive) {
    s.kind = Statement::Kind::directive;
    s.choice = plan_switch(tree, tree.directives[item.ref]);
    if (s.choice != nullptr) s.kind = Statement::Kind::choice;
    if (std::holds_alternative<ast::Break>(tree.directives[item.ref].node)) {
      s.kind = Statement::Kind::leave;
    }
    const auto* declare = std::get_if<ast::Declare>(&tree.directives[item.ref].node);
    if (declare == nullptr || !assigns_variable(*declare)) return;
    if (symbols_.reserved(declare->name)) return;
    s.formula = formula_of(tree, declare->value);
    s.declare = declare;
    if (s.formula != nullptr) s.kind = Statement::Kind::assign;
  } else if (item.kind == ast::ItemKind::expr) {
    s.call = plan_call(tree, item.ref);
    if (s.call != nullptr) s.kind = Statement::Kind::call;
  } else if (item.kind == ast::ItemKind::word) {
    s.object = plan_object(tree, pos);
    if (s.object != nullptr) s.kind = Statement::Kind::object;
  }
}

/// A plan for a `#switch` whose cases are literal numbers.
std::unique_ptr<SwitchPlan> Interpreter::plan_switch(const ast::Tree& tree,
                                                     const ast::Directive& d) {
  const auto* node = std::get_if<ast::Switch>(&d.node);
  if (node == nullptr) return nullptr;
  auto plan = std::make_unique<SwitchPlan>();
  plan->directive = static_cast<std::uint32_t>(&d - tree.directives.data());
  plan->value = formula_of(tree, node->value);
  if (plan->value == nullptr) return nullptr;
  for (std::uint32_t i = 0; i < node->cases.count; ++i) {
    const ast::Case& c = tree.cases[node->cases.first + i];
    const double* value = c.kind == ast::Case::Kind::case_ ? literal(tree, c.low) : nullptr;
    if (value == nullptr && c.kind != ast::Case::Kind::else_) return nullptr;
    plan->cases.push_back(value == nullptr ? std::nullopt : std::optional(*value));
  }
  return plan;
}

std::unique_ptr<CallPlan> Interpreter::plan_call(const ast::Tree& tree, ast::ExprId id) {
  const auto* call = std::get_if<ast::Call>(&tree.exprs[id].node);
  const auto* callee =
      call == nullptr ? nullptr : std::get_if<ast::Name>(&tree.exprs[call->callee].node);
  if (callee == nullptr || symbols_.reserved(callee->name)) return nullptr;
  auto plan = std::make_unique<CallPlan>();
  plan->call = id;
  plan->callee = callee->name;
  for (std::uint32_t i = 0; i < call->args.count; ++i) {
    CallPlan::Argument& a = plan->arguments.emplace_back();
    a.expr = tree.expr_lists[call->args.first + i];
    const ast::Expr& e = tree.exprs[a.expr];
    if (const auto* name = std::get_if<ast::Name>(&e.node);
        name != nullptr && !symbols_.reserved(name->name)) {
      a.kind = CallPlan::Argument::Kind::reference;
      a.name = name->name;
    } else if (is_computed(e)) {
      a.formula = formula_of(tree, a.expr);
      if (a.formula != nullptr) a.kind = CallPlan::Argument::Kind::formula;
    }
  }
  return plan;
}

/// A plan for the primitive whose word stands at `pos`; null if any part of it is unusual.
std::unique_ptr<ObjectPlan> Interpreter::plan_object(const ast::Tree& tree, std::uint32_t pos) {
  const SymbolId word = tree.items[pos].ref;
  const auto type = primitive_words_.find(word);
  if (type == primitive_words_.end() || reader_of(word) != &Interpreter::read_primitive) {
    return nullptr;
  }
  if (pos + 1 >= tree.items.size() || tree.items[pos + 1].kind != ast::ItemKind::braces) {
    return nullptr;
  }
  const ast::Range items = tree.groups[tree.items[pos + 1].ref].items;
  Frame block;
  block.kind = Frame::Kind::group;
  block.tree = &tree;
  block.end = items.first + items.count;
  auto plan = std::make_unique<ObjectPlan>();
  plan->type = type->second;
  plan->info = registry_.primitives[type->second];
  std::uint32_t at = items.first;
  if (!plan_operands(*plan, block, at)) return nullptr;
  std::size_t values = plan->operands.size();
  while (at < block.end) {
    if (is_punct(tree.items[at], ';')) {
      ++at;
      continue;
    }
    if (!plan_step(*plan, block, at) || ++values > ObjectPlan::most_values) return nullptr;
  }
  return plan;
}

/// The same operands as quick_operands.
bool Interpreter::plan_operands(ObjectPlan& plan, const Frame& block, std::uint32_t& pos) {
  const OperandPlan& known = operand_plan(*plan.info);
  const ast::Tree& tree = *block.tree;
  if (!known.simple || known.positional == 0) return false;
  if (known.fallback.size() > ObjectPlan::most_operands) return false;
  plan.fallback = &known.fallback;
  for (std::size_t i = 0; i < known.positional; ++i) {
    if (pos >= block.end || tree.items[pos].kind != ast::ItemKind::expr) return false;
    if (!ends_expression(block, pos + 1, false)) return false;
    const ast::ExprId id = tree.items[pos].ref;
    if (i == 0 && !is_computed(tree.exprs[id]) &&
        !std::holds_alternative<ast::Name>(tree.exprs[id].node)) {
      return false;  // it may be an object, of which this one is a copy
    }
    ObjectPlan::Operand& operand = plan.operands.emplace_back();
    operand.formula = formula_of(tree, id);
    operand.offset = known.offsets[i];
    operand.scalar = plan.info->params[i].kind == scene::ArgKind::number;
    if (operand.formula == nullptr) return false;
    ++pos;
    const bool comma = pos < block.end && is_punct(tree.items[pos], ',');
    if (comma && i + 1 == known.positional) return false;  // none may follow the last
    if (comma) ++pos;
  }
  if (plan.operands.size() > ObjectPlan::most_values) return false;
  if (!known.has_words || pos >= block.end || tree.items[pos].kind != ast::ItemKind::word) {
    return true;
  }
  const std::string_view next_word = name_of(tree.items[pos].ref);
  return std::ranges::none_of(plan.info->params, [&](const scene::Param& p) {
    return !p.positional && p.name == next_word;
  });
}

/// One transformation, colour or constant finish. If there are a colour and a finish, the finish comes
/// right behind the colour.
bool Interpreter::plan_step(ObjectPlan& plan, const Frame& block, std::uint32_t& pos) {
  const ast::Tree& tree = *block.tree;
  const ast::Item& item = tree.items[pos];
  if (item.kind != ast::ItemKind::word || pos + 1 >= block.end) return false;
  const ast::Item& operand = tree.items[pos + 1];
  ObjectPlan::Step step;
  step.word = item.ref;
  step.span = item.span;
  const auto have = [&](SymbolId word) {
    return std::ranges::any_of(plan.steps, [&](const auto& s) { return s.word == word; });
  };
  switch (item.ref) {
    case w::translate:
    case w::rotate:
    case w::scale:
      if (operand.kind != ast::ItemKind::expr || !ends_expression(block, pos + 2, false)) {
        return false;
      }
      step.formula = formula_of(tree, operand.ref);
      if (step.formula == nullptr) return false;
      break;
    case w::pigment:
      if (operand.kind != ast::ItemKind::braces || have(w::pigment) || have(w::finish)) return false;
      if (!plan_colour(step, tree, tree.groups[operand.ref].items)) return false;
      step.span = tree.items[tree.groups[operand.ref].items.first].span;
      break;
    case w::finish: {
      if (operand.kind != ast::ItemKind::braces || have(w::finish)) return false;
      step.finish = &tree.groups[operand.ref];
      if (!is_constant_block(tree, *step.finish)) return false;
      if (!have(w::pigment)) break;
      ObjectPlan::Step& last = plan.steps.back();
      if (last.word != w::pigment || last.finish != nullptr) return false;
      last.finish = step.finish;
      pos += 2;
      return true;
    }
    default: return false;
  }
  plan.steps.push_back(step);
  pos += 2;
  return true;
}

/// The same colours as quick_colour_block.
bool Interpreter::plan_colour(ObjectPlan::Step& step, const ast::Tree& tree, ast::Range items) {
  const auto word = [&](std::uint32_t i) {
    const ast::Item& item = tree.items[items.first + i];
    return i < items.count && item.kind == ast::ItemKind::word ? item.ref
                                                               : grammar::SymbolTable::none;
  };
  std::uint32_t words = word(0) == w::color || word(0) == w::colour ? 1 : 0;
  step.form = colour_form(word(words));
  if (step.form.is_srgb) return false;
  if (step.form.wanted > 0) step.keyword = &tree.items[items.first + words++];
  if (words + 1 != items.count) return false;
  const ast::Item& last = tree.items[items.first + words];
  if (last.kind != ast::ItemKind::expr) return false;
  const auto& node = tree.exprs[last.ref].node;
  step.strict = words == 0;
  if (step.strict && !std::holds_alternative<ast::Name>(node) &&
      !std::holds_alternative<ast::Index>(node)) {
    return false;
  }
  step.formula = formula_of(tree, last.ref);
  return step.formula != nullptr;
}

}  // namespace durer::interpreter

// Macro calls: arguments by reference and by value, and the body in place of the call (language
// §4.6).
#include <fmt/format.h>

#include "interpreter/interpreter.h"
#include "interpreter/statements.h"

namespace durer::interpreter {
namespace {

/// An expression that cannot yield anything but a number or vector.
bool is_number(const ast::Expr& e) {
  return std::holds_alternative<ast::Binary>(e.node) ||
         std::holds_alternative<ast::Number>(e.node) || std::holds_alternative<ast::Vector>(e.node);
}

}  // namespace

/// False for a sum or product whose first operand is a variable that holds no number.
bool Interpreter::adds_up(const ast::Tree& tree, ast::ExprId id) {
  const auto* sum = std::get_if<ast::Binary>(&tree.exprs[id].node);
  if (sum == nullptr) return true;
  while (sum != nullptr) {
    id = sum->left;
    sum = std::get_if<ast::Binary>(&tree.exprs[id].node);
  }
  const ast::Expr& first = tree.exprs[id];
  if (!std::holds_alternative<ast::Name>(first.node) && !array_of(first)) return true;
  const Peek peek(*this);
  const Value* v = lookup(tree, id, false);
  return v == nullptr || !v->defined() || v->get<Num>() != nullptr;
}

/// Evaluates one argument (or several without a comma), into slots that wait for the scope of the macro to open.
void Interpreter::add_argument(const ast::Tree& tree, ast::ExprId arg, bool optional) {
  const ast::Expr& e = tree.exprs[arg];
  // A bare name or array element goes by reference (language §4.6).
  if (const auto* name = std::get_if<ast::Name>(&e.node);
      name != nullptr && !symbols_.reserved(name->name)) {
    Slot* target = env_.find(name->name);
    const Value* v = Environment::value_of(target);
    if (v == nullptr || !v->defined()) {
      // A parameter that may be omitted stays undeclared.
      if (optional && v == nullptr) return arguments_.push_back(nullptr);
      unknown_name(name->name, e.span);
    }
    if (!v->is_num()) check_copyable(*v, name->name, e.span);
    if (target->target != nullptr && target->path.empty()) target = target->target;
    Slot& slot = env_.make();
    slot.target = target;
    arguments_.push_back(&slot);
  } else if (const auto array_name = array_of(e); array_name && !in_dictionary(*array_name)) {
    const auto list = read_subscripts(tree, arg);
    element(*array_name, list, e.span, false);  // must exist
    Slot& slot = env_.make();
    slot.target = env_.find(*array_name);
    Value* v = Environment::value_of(slot.target);
    for (std::size_t used = 0; used < list.size();) {
      Array& array = **v->get<std::shared_ptr<Array>>();
      const std::size_t at = flat_index(list, array, e.span, used);
      slot.path.emplace_back(at);
      v = &array.elements[at];
    }
    arguments_.push_back(&slot);
  } else if (additions_ && leads_to_entry(tree, arg)) {
    Slot found;
    refer(tree, arg, found);
    Slot& slot = env_.make();
    slot.value = std::move(found.value);
    slot.target = found.target;
    slot.path = std::move(found.path);
    arguments_.push_back(&slot);
  } else if (const Operand* quickly = is_number(e) ? quick(tree, arg, 1) : nullptr) {
    Slot& slot = env_.make();
    store_number(slot.value, quickly->number());
    arguments_.push_back(&slot);
  } else if (is_number(e) && ((e.may_expand && needs_expansion(tree, arg)) || !adds_up(tree, arg))) {
    // What stands before the sign may be something else than a number: `Box -y` are two arguments.
    Nested part(*this, tree, arg);
    do {
      const Span span = peek().span;
      Value value = read_value();
      Slot& slot = env_.make();
      store(slot.value, std::move(value), false, nullptr, span);
      arguments_.push_back(&slot);
    } while (peek().kind != Token::Kind::end);
  } else if (is_number(e)) {
    Num n;
    n.length = work_out(tree, arg, 1, n.v.data());
    Slot& slot = env_.make();
    store_number(slot.value, n);
    arguments_.push_back(&slot);
  } else {
    Value value = evaluate_value(tree, arg);
    Slot& slot = env_.make();
    store(slot.value, std::move(value), false, nullptr, e.span);
    arguments_.push_back(&slot);
  }
}

/// Arguments that have to be read item by item.
void Interpreter::read_open_arguments(const ast::Tree& tree, ast::Range items,
                                      const MacroRef& ref) {
  const Nested part(*this, tree, items);
  const std::size_t first = arguments_.size();
  const auto optional = [&] {
    const std::size_t i = arguments_.size() - first;
    return i < ref.macro->params.count &&
           ref.tree->params[ref.macro->params.first + i].optional;
  };
  while (peek().kind != Token::Kind::end) {
    const Token t = peek();
    if (t.is_punct(',') && optional()) {
      next();
      arguments_.push_back(nullptr);
      continue;
    }
    const auto* name = t.node<ast::Name>();
    if (name != nullptr ? !symbols_.reserved(name->name)
                        : t.kind == Token::Kind::expr && array_of(t.expression()).has_value()) {
      next();
      if (!at_operator()) {
        add_argument(*t.tree, t.expr, optional());
        optional_comma();
        continue;
      }
      unread(t);
    }
    Value value = read_value();
    Slot& slot = env_.make();
    store(slot.value, std::move(value), false, nullptr, t.span);
    arguments_.push_back(&slot);
    optional_comma();
  }
}

/// Replaces the call `id` (a Call or an OpenGroup) by the body of its macro.
void Interpreter::call_macro(const ast::Tree& tree, ast::ExprId id, bool flatten) {
  const auto* call = std::get_if<ast::Call>(&tree.exprs[id].node);
  const ast::ExprId callee =
      call != nullptr ? call->callee : std::get<ast::OpenGroup>(tree.exprs[id].node).callee;
  const MacroRef ref = *macro_of(tree, callee);
  const std::size_t depth = frames_.size();
  const bool runs = ref.macro->items.shape == ast::Body::Shape::statements;
  ast::Range items = ref.macro->items;
  if (runs) items.count = 0;
  enter_macro(tree, id, ref, items, flatten);
  if (!runs) return;
  run_statements(*ref.tree, ref.macro->items);  // a #break ends the macro
  while (frames_.size() > depth) pop();
}

/// Before a call: the limits.
void Interpreter::count_call(const ast::Macro& macro, Span call) {
  tick(call);
  check_stack(call);
  if (macro_depth_ < options_.limits.macro_depth || options_.limits.macro_depth == 0) return;
  fail(Code::limit, call, fmt::format("macro `{}` calls itself too deeply", name_of(macro.name)),
       fmt::format("give the recursion an end: {} calls inside one another are the limit "
                   "(--max-macro-depth)",
                   options_.limits.macro_depth));
}

/// Evaluates the arguments of the call and opens the macro.
void Interpreter::enter_macro(const ast::Tree& tree, ast::ExprId id, const MacroRef& ref,
                              ast::Range items, bool flatten) {
  const ast::Expr& e = tree.exprs[id];
  const ast::Macro& macro = *ref.macro;
  count_call(macro, e.span);
  const std::size_t first = arguments_.size();
  if (const auto* call = std::get_if<ast::Call>(&e.node)) {
    for (std::uint32_t i = 0; i < call->args.count; ++i) {
      const bool optional =
          i < macro.params.count && ref.tree->params[macro.params.first + i].optional;
      add_argument(tree, tree.expr_lists[call->args.first + i], optional);
    }
  } else {
    read_open_arguments(tree, std::get<ast::OpenGroup>(e.node).items, ref);
  }
  std::size_t given = arguments_.size() - first;
  for (; given < macro.params.count && ref.tree->params[macro.params.first + given].optional;
       ++given) {
    arguments_.push_back(nullptr);
  }
  if (given != macro.params.count) {
    Diagnostic d;
    d.code = Code::missing_argument;
    d.span = e.span;
    d.message = fmt::format("macro `{}` takes {} argument{}, here {} {}", name_of(macro.name),
                            macro.params.count, macro.params.count == 1 ? "" : "s",
                            given == 1 ? "is" : "are", given);
    d.labels.push_back({macro.head, "the macro is defined here"});
    fail(std::move(d));
  }

  open_macro(ref, items, e.span, first).flatten = flatten;
  if (options_.on_trace) trace_call(frames_.back(), *ref.tree, macro);
}

/// The frame of a macro, which delivers `items`, and its scope with the arguments from number
/// `first` on.
Frame& Interpreter::open_macro(const MacroRef& ref, ast::Range items, Span call,
                               std::size_t first) {
  const ast::Macro& macro = *ref.macro;
  Frame& f = push(Frame::Kind::macro, call);
  f.tree = ref.tree;
  f.first = items.first;
  f.pos = items.first;
  f.end = items.first + items.count;
  f.name = macro.name;
  ++macro_depth_;
  env_.open_scope();
  for (std::uint32_t i = 0; i < macro.params.count; ++i) {
    if (arguments_[first + i] == nullptr) continue;
    env_.link(*arguments_[first + i], ref.tree->params[macro.params.first + i].name);
  }
  arguments_.resize(first);
  return f;
}

/// Runs the call that was planned; false, with nothing done, if it is not of a macro that takes
/// these arguments.
bool Interpreter::run_call(const ast::Tree& tree, const CallPlan& plan) {
  const MacroRef* known = macro_named(plan.callee);
  if (known == nullptr || options_.on_trace) return false;
  const MacroRef ref = *known;
  const ast::Range params = ref.macro->params;
  if (params.count != plan.arguments.size()) return false;
  for (std::uint32_t i = 0; i < params.count; ++i) {
    if (ref.tree->params[params.first + i].optional) return false;
  }
  ++frames_.back().pos;
  const Span span = tree.exprs[plan.call].span;
  count_call(*ref.macro, span);
  const std::size_t first = arguments_.size();
  for (const CallPlan::Argument& argument : plan.arguments) add_argument(tree, argument);
  ast::Range items = ref.macro->items;
  const bool runs = ref.macro->items.shape == ast::Body::Shape::statements;
  if (runs) items.count = 0;
  const std::size_t depth = frames_.size();
  open_macro(ref, items, span, first);
  if (!runs) return true;
  run_statements(*ref.tree, ref.macro->items);  // a #break ends the macro
  while (frames_.size() > depth) pop();
  return true;
}

void Interpreter::add_argument(const ast::Tree& tree, const CallPlan::Argument& argument) {
  using Kind = CallPlan::Argument::Kind;
  if (argument.kind == Kind::reference) {
    Slot* target = env_.find(argument.name);
    const Value* v = Environment::value_of(target);
    if (v != nullptr && v->is_num()) {
      if (target->target != nullptr && target->path.empty()) target = target->target;
      Slot& slot = env_.make();
      slot.target = target;
      return arguments_.push_back(&slot);
    }
  } else if (argument.kind == Kind::formula) {
    if (const Operand* result = run_formula(*argument.formula, 1)) {
      Slot& slot = env_.make();
      if (result->is_text()) {
        slot.value = take_result(*result);
      } else {
        store_number(slot.value, result->number());
      }
      return arguments_.push_back(&slot);
    }
  }
  add_argument(tree, argument.expr);
}

}  // namespace durer::interpreter

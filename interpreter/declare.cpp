// #declare, #local, #undef and #macro (language §4.3, §4.6).
#include <cmath>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {
namespace {

/// Two values may live in one array if they are of the same kind, and numbers of the same length.
bool same_kind(const Value& a, const Value& b) {
  if (!same_alternative(a, b)) return false;
  const Num* x = a.get<Num>();
  const Num* y = b.get<Num>();
  return x == nullptr || x->length == y->length;
}

const Value* first_defined(const Array& array) {
  for (const Value& v : array.elements) {
    if (v.defined()) return &v;
  }
  return nullptr;
}

/// Colour variables are 32-bit (language §2).
void round_colour(Num& n) {
  for (double& x : n.v) x = static_cast<float>(x);
}

}  // namespace

void Interpreter::store_number(Value& target, Num n) {
  if (n.length == 5) round_colour(n);
  target.set(n);
}

/// Elements of an array are of the kind of `first`, one of them, unless the array is mixed.
void Interpreter::check_kind(const Value* first, const Array& array, const Value& value, Span span) {
  if (first == nullptr || array.mixed || same_kind(*first, value)) return;
  fail(Code::wrong_kind, span,
       fmt::format("this array holds {}s, the new element is {}", kind_name(*first).substr(2),
                   kind_name(value)),
       "all elements of an array are of one kind");
}

void Interpreter::store(Value& target, Value value, bool is_element, const Array* array,
                        Span span) {
  if (Num* n = value.get<Num>(); n != nullptr && n->length == 5) {
    for (double& x : n->v) x = static_cast<float>(x);
  }
  if (!is_element && value.is_num()) {
    target.set(*value.get<Num>());
    return;
  }
  if (is_element && array != nullptr) {
    check_kind(target.defined() ? &target : first_defined(*array), *array, value, span);
  }
  target = std::move(value);
}

/// In loops and macros: assigns the result of compiled code to a variable that holds a number or a
/// string, or to a new one. False, with nothing done, if it is anything else.
bool Interpreter::quick_assign(const ast::Tree& tree, const ast::Declare& node) {
  if (repeats_ == 0 || !assigns_variable(node)) return false;
  if (tree.exprs[node.value].height < 2 || !takes_shortcuts()) return false;
  Formula* const formula = formula_of(tree, node.value);
  return formula != nullptr && quick_assign(node, *formula);
}

/// `#local Name = expression;` and nothing more.
bool Interpreter::assigns_variable(const ast::Declare& node) {
  return node.value != ast::none && node.place == ast::none && node.subscripts.count == 0 &&
         !node.deprecated && node.semicolon;
}

bool Interpreter::quick_assign(const ast::Declare& node, Formula& formula) {
  if (additions_ && grammar::SymbolTable::added(node.name)) return false;
  const auto is_plain = [](const Value* v) {
    return v != nullptr && (v->is_num() || v->get<Shared<Text>>() != nullptr);
  };
  Slot* slot = node.local ? env_.find_in_scope(node.name, env_.scope()) : env_.find(node.name);
  if (slot == nullptr) {
    // The new one may hide a variable, but neither a macro nor a function.
    Slot* const hidden = env_.find(node.name);
    if (additions_ || (hidden != nullptr && !is_plain(Environment::value_of(hidden)))) return false;
  } else if (slot->deprecated || !slot->path.empty() || !is_plain(Environment::value_of(slot))) {
    return false;
  }
  const Operand* result = run_formula(formula, 1);
  if (result == nullptr) return false;
  if (slot == nullptr) {
    slot = &env_.in_scope(node.name, node.local ? env_.scope() : 0);
    slot->declared = node.target;
  }
  Value& target = *Environment::value_of(slot);
  if (!result->is_text()) {
    Num* const old = target.get<Num>();
    Num& n = old != nullptr ? *old : target.node.emplace<Num>();
    n.v = result->v;
    n.length = result->length;
    if (n.length == 5) round_colour(n);
  } else if (auto* text = target.get<Shared<Text>>(); text != nullptr && text->use_count() == 1) {
    machine_.take_text(const_cast<Text&>(**text));  // nobody else holds it: see text_value
  } else {
    target = take_result(*result);
  }
  return true;
}

/// Numbers end with a semicolon, since version 3.1 in earnest since 3.5 (language §1.7).
void Interpreter::missing_semicolon(const ast::Declare& node, const Num& n) {
  if (version() < 310) return;
  const std::string_view kind = n.length == 1 ? "float" : n.length == 5 ? "colour" : "vector";
  std::string message = fmt::format("this `#{}` of a {} must end with `;`",
                                    node.local ? "local" : "declare", kind);
  const std::string_view help = "add a `;` after the value";
  if (version() < 350) return warn(Code::syntax, node.target, std::move(message), std::string(help));
  // The value is known: nothing else suffers.
  Diagnostic d;
  d.code = Code::syntax;
  d.span = node.target;
  d.message = std::move(message);
  d.help.emplace_back(help);
  report(std::move(d));
}

void Interpreter::run(const ast::Tree& tree, const ast::Directive& d, const ast::Declare& node) try {
  (void)d;
  if (symbols_.reserved(node.name) && node.place == ast::none) {
    fail(Code::unexpected_item, node.target,
         fmt::format("`{}` is a word of the language and cannot be declared", name_of(node.name)),
         "choose another name; names that start with a capital letter are always free");
  }
  if (quick_assign(tree, node)) return;
  if (node.subscripts.count == 0 && node.place == ast::none) check_new_name(node.name, node.target);
  // Where the value goes is settled first: its last operand may stand inside a macro, whose scope
  // is still open then. The old value stays visible while the new one is worked out.
  const std::uint32_t scope = env_.scope();
  Slot* const existing = node.local ? env_.find_in_scope(node.name, scope) : env_.find(node.name);
  if (node.subscripts.count == 0) check_may_change(env_.find(node.name), node.target, node.local);
  // Subscripts are what they are before the value, which may come from a macro with names of its own.
  std::optional<Subscripts> at;
  if (node.subscripts.count > 0 && node.place == ast::none && !additions_) {
    at = read_subscripts(tree, node.subscripts);
  }
  Value value;
  bool semicolon = node.semicolon;
  if (node.value != ast::none) {
    value = evaluate_value(tree, node.value);
  } else {
    const std::size_t outer = declare_depth_;
    declare_depth_ = frames_.size();
    value = read_value();
    declare_depth_ = outer;
    semicolon = accept_raw_punct(';');
    if (semicolon) accept_raw_punct(';');  // the oracle takes one more
  }
  if (!semicolon && value.get<Num>() != nullptr) missing_semicolon(node, *value.get<Num>());

  assign(tree, node, std::move(value), scope, existing, at ? &*at : nullptr);
} catch (const Failure&) {
  poison(node.name, node.local ? env_.scope() : 0, true);
  throw;
}

/// Puts `value` where the directive says; `existing` is the slot that it overwrites, if there is one.
void Interpreter::assign(const ast::Tree& tree, const ast::Declare& node, Value value,
                         std::uint32_t scope, Slot* existing, const Subscripts* at) {
  if (node.place != ast::none) return assign_place(tree, node, std::move(value));
  if (node.subscripts.count > 0) {
    Slot* slot = env_.find(node.name);
    Value* base = Environment::value_of(slot);
    if (base == nullptr) unknown_name(node.name, node.target);
    auto* array = base->get<std::shared_ptr<Array>>();
    if (additions_ && array == nullptr) return assign_place(tree, node, std::move(value));
    if (array == nullptr) {
      fail(Code::wrong_kind, node.target,
           fmt::format("`{}` is {}, not an array", name_of(node.name), kind_name(*base)));
    }
    // `#local A[i]` on an array of an outer scope is evaluated and lost (language §4.3).
    if (const Value* first = first_defined(**array);
        node.local && slot->scope != scope && first != nullptr) {
      return check_kind(first, **array, value, node.target);
    }
    if (additions_) return assign_place(tree, node, std::move(value));
    Value* target = element(node.name, at != nullptr ? *at : read_subscripts(tree, node.subscripts),
                            node.target, true, false);
    if (target->get<Shared<UserFunction>>() != nullptr) function_stays(node.name, node.target);
    store(*target, std::move(value), true, array->get(), node.target);
    return;
  }
  Slot& slot = existing != nullptr ? *existing : env_.in_scope(node.name, node.local ? scope : 0);
  Value* target = Environment::value_of(&slot);
  const bool through_element = slot.target != nullptr && !slot.path.empty() &&
                               std::holds_alternative<std::size_t>(slot.path.back());
  if (target == nullptr)
    fail(Code::evaluation, node.target, "this parameter no longer has a value");
  if (through_element && target->defined() && !same_kind(*target, value)) {
    fail(Code::wrong_kind, node.target,
         fmt::format("`{}` stands for an array element that is {}, the new value is {}",
                     name_of(node.name), kind_name(*target), kind_name(value)));
  }
  store(*target, std::move(value), false, nullptr, node.target);
  slot.declared = node.target;
  slot.deprecated.reset();
  if (node.deprecated) {
    auto note = std::make_shared<Deprecation>();
    note->once = node.deprecated_once;
    note->message = node.deprecated_message != ast::none
                        ? evaluate_text(tree, node.deprecated_message).bytes()
                        : fmt::format("`{}` is deprecated", name_of(node.name));
    slot.deprecated = std::move(note);
  }
}

/// Warns when a deprecated name is used.
void Interpreter::note_use(const Slot* slot, Span span) {
  if (slot == nullptr || !slot->deprecated) return;
  Deprecation& d = *slot->deprecated;
  if (d.once && d.told) return;
  d.told = true;
  warn(Code::deprecated, span, d.message);
}

void Interpreter::run(const ast::Tree& tree, const ast::Directive& d, const ast::Undef& node) {
  if (node.place != ast::none) {
    if (Value* v = place(tree, node.place, Access::write).value) *v = Value{};
    return;
  }
  if (node.subscripts.count > 0 && additions_) {
    const Place from{Environment::value_of(env_.find(node.name)), nullptr};
    if (from.value == nullptr) unknown_name(node.name, d.span);
    *step_into(from, tree, node.subscripts, d.span, Access::write).value = Value{};
    return;
  }
  if (node.subscripts.count > 0) {
    *element(node.name, read_subscripts(tree, node.subscripts), d.span, true, false) = Value{};
    return;
  }
  if (symbols_.reserved(node.name)) {
    fail(Code::unexpected_item, d.span,
         fmt::format("`{}` is a word of the language", name_of(node.name)));
  }
  if (!env_.undefine(node.name)) {
    warn(Code::unknown_name, d.span, fmt::format("`{}` is not declared", name_of(node.name)));
  }
}

void Interpreter::run(const ast::Tree& tree, const ast::Directive& d, const ast::Macro& node) {
  (void)d;
  if (symbols_.reserved(node.name)) {
    fail(Code::unexpected_item, node.head,
         fmt::format("`{}` is a word of the language and cannot name a macro", name_of(node.name)));
  }
  check_new_name(node.name, node.head);
  if (version() < 310) {
    fail(Code::version, node.head, "macros need version 3.1",
         "write `#version 3.7;` above, or what the scene was written for");
  }
  Slot& slot = env_.for_global(node.name);
  if (slot.value.defined() && slot.value.get<MacroRef>() == nullptr) {
    fail(Code::wrong_kind, node.head,
         fmt::format("`{}` is {} and cannot become a macro", name_of(node.name),
                     kind_name(slot.value)),
         "`#undef` it first, or choose another name");
  }
  slot.value = Value(MacroRef{&tree, &node});
}

}  // namespace durer::interpreter

// #declare, #local, #undef, #macro and macro calls; arrays (language §4.3, §4.6, §5.1).
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

/// An expression that cannot yield anything but a number or vector.
bool is_number(const ast::Expr& e) {
  return std::holds_alternative<ast::Binary>(e.node) ||
         std::holds_alternative<ast::Number>(e.node) || std::holds_alternative<ast::Vector>(e.node);
}

}  // namespace

/// Assigns; colours lose precision on the way, as colour variables are 32-bit (language §2).
void Interpreter::store_number(Value& target, Num n) {
  if (n.length == 5) {
    for (double& x : n.v) x = static_cast<float>(x);
  }
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
  if (repeats_ == 0 || node.value == ast::none || node.place != ast::none) return false;
  if (node.subscripts.count > 0 || node.deprecated || !node.semicolon) return false;
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
  const Operand* result = quick(tree, node.value, 1);
  if (result == nullptr) return false;
  if (slot == nullptr) {
    slot = &env_.in_scope(node.name, node.local ? env_.scope() : 0);
    slot->declared = node.target;
  }
  Value& target = *Environment::value_of(slot);
  if (!result->is_text()) {
    store_number(target, result->number());
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
  if (node.subscripts.count == 0) check_may_change(env_.find(node.name), node.target);
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

  assign(tree, node, std::move(value), scope, existing);
} catch (const Failure&) {
  poison(node.name, node.local ? env_.scope() : 0, true);
  throw;
}

/// Puts `value` where the directive says; `existing` is the slot that it overwrites, if there is one.
void Interpreter::assign(const ast::Tree& tree, const ast::Declare& node, Value value,
                         std::uint32_t scope, Slot* existing) {
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
    Value* target =
        element(node.name, read_subscripts(tree, node.subscripts), node.target, true, false);
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

// ---- arrays -----------------------------------------------------------------------------------

Interpreter::Subscript Interpreter::read_subscript(const ast::Tree& tree, ast::ExprId id) {
  const Num subscript = evaluate(tree, id, 1);
  if (subscript.length != 1) {
    fail(Code::wrong_kind, tree.exprs[id].span,
         fmt::format("expected a float as subscript, found {}", kind_name(subscript)));
  }
  return {subscript.v[0], tree.exprs[id].span};
}

Interpreter::Subscripts Interpreter::read_subscripts(const ast::Tree& tree, ast::Range list) {
  Subscripts out;
  for (std::uint32_t i = 0; i < list.count; ++i) {
    const ast::ExprId id = tree.expr_lists[list.first + i];
    if (!out.add(read_subscript(tree, id))) {
      fail(Code::limit, tree.exprs[id].span, "an array access has at most 20 subscripts");
    }
  }
  return out;
}

Interpreter::Subscripts Interpreter::read_subscripts(const ast::Tree& tree, ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  if (const auto* index = std::get_if<ast::Index>(&e.node))
    return read_subscripts(tree, index->subscripts);
  // Made by directives: one bracketed part per subscript.
  Subscripts out;
  const Nested part(*this, tree, std::get<ast::OpenGroup>(e.node).items);
  while (peek().kind == Token::Kind::bracket_open) {
    const Span span = next().span;
    if (!out.add({read_scalar("subscript"), span})) {
      fail(Code::limit, span, "an array access has at most 20 subscripts");
    }
    const Token close = next();
    if (close.kind != Token::Kind::bracket_close) unexpected(close, "`]`");
  }
  return out;
}

/// Where the subscripts from number `used` on lead in `array`, row-major.
std::size_t Interpreter::flat_index(const Subscripts& list, const Array& array, Span span,
                                    std::size_t& used) {
  std::size_t flat = 0;
  for (const std::size_t size : array.sizes) {
    if (used >= list.size()) {
      fail(Code::missing_argument, span,
           fmt::format("this array has {} dimensions, here are {} subscripts", array.sizes.size(),
                       list.size()));
    }
    const Subscript& s = list[used++];
    const double v = std::floor(s.value + epsilon);
    if (!(v >= 0 && v < static_cast<double>(size))) {
      fail(Code::out_of_range, s.span,
           fmt::format("subscript {:g} is outside the array, which has {} elements here", v, size),
           fmt::format("subscripts go from 0 to {}", size - 1));
    }
    flat = flat * size + static_cast<std::size_t>(v);
  }
  return flat;
}

Value* Interpreter::element(SymbolId name, const Subscripts& list, Span span, bool for_writing,
                            bool must_exist) {
  Value* v = Environment::value_of(env_.find(name));
  if (v == nullptr) unknown_name(name, span);
  for (std::size_t used = 0; used < list.size();) {
    auto* array = v->get<std::shared_ptr<Array>>();
    if (array == nullptr) {
      fail(Code::wrong_kind, span,
           fmt::format("`{}` is {}, it takes no more subscripts", name_of(name), kind_name(*v)));
    }
    if (for_writing) own_array(*v);
    if (for_writing && (*array)->grows) grow(**array, list[used].value, list[used].span);
    v = &(*array)->elements[flat_index(list, **array, span, used)];
  }
  if (must_exist && !v->defined()) {
    fail(Code::evaluation, span, "this array element has no value yet");
  }
  return v;
}

// ---- macro calls -------------------------------------------------------------------------------

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

/// Evaluates the arguments of the call and opens the macro: a frame that delivers `items`, a scope,
/// the parameters.
void Interpreter::enter_macro(const ast::Tree& tree, ast::ExprId id, const MacroRef& ref,
                              ast::Range items, bool flatten) {
  const ast::Expr& e = tree.exprs[id];
  const ast::Macro& macro = *ref.macro;
  tick(e.span);
  check_stack(e.span);
  if (macro_depth_ >= options_.limits.macro_depth && options_.limits.macro_depth > 0) {
    fail(Code::limit, e.span,
         fmt::format("macro `{}` calls itself too deeply", name_of(macro.name)),
         fmt::format("give the recursion an end: {} calls inside one another are the limit "
                     "(--max-macro-depth)",
                     options_.limits.macro_depth));
  }
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

  Frame& f = push(Frame::Kind::macro, e.span);
  f.flatten = flatten;
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
  if (options_.on_trace) trace_call(f, *ref.tree, macro);
}

}  // namespace durer::interpreter

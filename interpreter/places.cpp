// Where values are kept: variables, elements of arrays, entries of dictionaries, and the scopes as
// dictionaries, in any nesting (language §5.1, additions of 3.8).
#include <fmt/format.h>

#include "base/suggest.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;
namespace a = grammar::additions;

namespace {

bool is_dictionary(const Value& v) { return v.get<std::shared_ptr<Dictionary>>() != nullptr; }

/// True if subscripts or members of the value may lead to an entry of a dictionary.
bool may_hold_entries(const Value& v) {
  if (is_dictionary(v)) return true;
  const auto* array = v.get<std::shared_ptr<Array>>();
  if (array == nullptr) return false;
  for (const Value& element : (*array)->elements) {
    if (!element.defined()) continue;
    if (may_hold_entries(element)) return true;
    if (!(*array)->mixed) return false;  // the others are of the same kind
  }
  return false;
}

/// The variable that a chain of members and subscripts begins with; none if it begins otherwise.
std::optional<SymbolId> root_of(const ast::Tree& tree, ast::ExprId id) {
  for (;;) {
    const auto& node = tree.exprs[id].node;
    if (const auto* name = std::get_if<ast::Name>(&node)) return name->name;
    if (const auto* index = std::get_if<ast::Index>(&node)) return index->name;
    if (const auto* member = std::get_if<ast::Member>(&node)) {
      id = member->object;
    } else if (const auto* element = std::get_if<ast::Element>(&node)) {
      id = element->object;
    } else {
      return std::nullopt;
    }
  }
}

}  // namespace

/// `local` and `global` stand for the scopes, unless an older scene has declared the name.
bool Interpreter::is_scope(SymbolId name) const {
  return name == w::local || (name == a::global && env_.find(name) == nullptr);
}

/// True if subscripts of `name` may lead into a dictionary, so that no flat index tells the place.
bool Interpreter::in_dictionary(SymbolId name) const {
  if (!additions_) return false;
  if (is_scope(name)) return true;
  const Value* v = Environment::value_of(env_.find(name));
  return v != nullptr && may_hold_entries(*v);
}

Interpreter::Place Interpreter::scope_entry(SymbolId scope, SymbolId name, Span span,
                                            Access access) {
  if (access == Access::write) {
    check_new_name(name, span);
    const std::uint32_t wanted = scope == w::local ? env_.scope() : 0;
    return {Environment::value_of(&env_.in_scope(name, wanted)), nullptr};
  }
  Value* v = Environment::value_of(scope_slot(scope, name));
  if (v == nullptr && access == Access::read) unknown_name(name, span);
  return {v, nullptr};
}

void Interpreter::no_entry(const Dictionary& dictionary, const Text& key, Span span) {
  const std::string wanted = key.bytes();
  std::vector<std::string> keys;
  for (const auto& [name, value] : dictionary.entries) keys.push_back(name.bytes());
  const std::vector<std::string_view> views(keys.begin(), keys.end());
  const auto near = closest(wanted, views);
  fail(Code::unknown_name, span, fmt::format("the dictionary has no entry `{}`", wanted),
       near ? fmt::format("did you mean `{}`?", *near) : std::string());
}

/// The entry `key` of the dictionary that `holder` is; a new one if it is to be written.
Interpreter::Place Interpreter::dictionary_entry(Value& holder, const Text& key, Span span,
                                                 Access access) {
  if (access == Access::write) return {&own_dictionary(holder)->entries[key], nullptr};
  const auto& shared = *holder.get<std::shared_ptr<Dictionary>>();
  const auto it = shared->entries.find(key);
  if (it != shared->entries.end() && it->second.defined()) return {&it->second, nullptr};
  if (access == Access::read) no_entry(*shared, key, span);
  return {};
}

/// Follows subscripts: numbers into arrays, strings into dictionaries.
Interpreter::Place Interpreter::step_into(Place from, const ast::Tree& tree, ast::Range list,
                                          Span span, Access access) {
  for (std::uint32_t used = 0; used < list.count;) {
    if (from.value == nullptr) return {};
    const auto at = [&](std::uint32_t i) { return tree.expr_lists[list.first + i]; };
    if (is_dictionary(*from.value)) {
      const Text key = evaluate_text(tree, at(used));
      from = dictionary_entry(*from.value, key, tree.exprs[at(used)].span, access);
      ++used;
      continue;
    }
    auto* array = from.value->get<std::shared_ptr<Array>>();
    if (array == nullptr) {
      fail(Code::wrong_kind, span,
           fmt::format("expected an array or dictionary, found {}", kind_name(*from.value)));
    }
    Subscripts numbers;
    for (std::size_t d = 0; d < (*array)->sizes.size() && used < list.count; ++d, ++used) {
      numbers.add(read_subscript(tree, at(used)));
    }
    if (access == Access::write) {
      own_array(*from.value);
      if ((*array)->grows) grow(**array, numbers[0].value, numbers[0].span);
    }
    std::size_t taken = 0;
    from = {&(*array)->elements[flat_index(numbers, **array, span, taken)], array->get()};
    if (access == Access::read && !from.value->defined()) {
      fail(Code::evaluation, span, "this array element has no value yet");
    }
  }
  return from;
}

/// Where the value of a Name, Index, Member or Element is. `probe`: null if there is none.
Interpreter::Place Interpreter::place(const ast::Tree& tree, ast::ExprId id, Access access) {
  const ast::Expr& e = tree.exprs[id];
  const auto variable = [&](SymbolId name) -> Place {
    Slot* slot = env_.find(name);
    Value* v = Environment::value_of(slot);
    if (v == nullptr) unknown_name(name, e.span);
    note_use(slot, e.span);
    return {v, nullptr};
  };
  // What is on the way to an entry must be there, unless somebody only asks.
  const Access on_the_way = access == Access::probe ? Access::probe : access;
  if (const auto* name = std::get_if<ast::Name>(&e.node)) return variable(name->name);
  if (const auto* index = std::get_if<ast::Index>(&e.node)) {
    if (!is_scope(index->name)) {
      return step_into(variable(index->name), tree, index->subscripts, e.span, access);
    }
    const ast::Range rest{index->subscripts.first + 1, index->subscripts.count - 1};
    const Text key = evaluate_text(tree, tree.expr_lists[index->subscripts.first]);
    const SymbolId name = symbols_.intern(key.bytes());
    return step_into(scope_entry(index->name, name, e.span, access), tree, rest, e.span, access);
  }
  if (const auto* element_of = std::get_if<ast::Element>(&e.node)) {
    return step_into(place(tree, element_of->object, on_the_way), tree, element_of->subscripts,
                     e.span, access);
  }
  if (const auto* m = std::get_if<ast::Member>(&e.node)) {
    if (const auto* object = std::get_if<ast::Name>(&tree.exprs[m->object].node);
        object != nullptr && is_scope(object->name)) {
      return scope_entry(object->name, m->member, e.span, access);
    }
    const Place holder = place(tree, m->object, on_the_way);
    if (holder.value == nullptr) return {};
    if (const Num* number = holder.value->get<Num>();
        number != nullptr && access != Access::write && (component_slot(m->member) >= 0 || m->member == grammar::words::gray)) {
      Num n = *number;  // a component of a vector that an entry holds
      n.length = take_member(n.v.data(), n.length, m->member, e.span, 1);
      component_.set(Num(n.v[0]));
      return {&component_, nullptr};
    }
    if (!is_dictionary(*holder.value)) {
      fail(Code::wrong_kind, tree.exprs[m->object].span,
           fmt::format("expected a dictionary, found {}", kind_name(*holder.value)));
    }
    return dictionary_entry(*holder.value, Text(name_of(m->member)), e.span, access);
  }
  if (const auto array = array_of(e)) {
    return {element(*array, read_subscripts(tree, id), e.span, access == Access::write,
                    access == Access::read),
            nullptr};
  }
  fail(Code::unexpected_item, e.span, "expected a name");
}

/// The value that an Index, Member or Element stands for; null if the expression is no such place
/// (`V.x` of a vector), or holds nothing and need not exist.
Value* Interpreter::entry(const ast::Tree& tree, ast::ExprId id, bool must_exist) {
  const ast::Expr& e = tree.exprs[id];
  const Access access = must_exist ? Access::read : Access::probe;
  if (const auto* m = std::get_if<ast::Member>(&e.node)) {
    // Found out without evaluating subscripts: they may draw random numbers.
    const auto root = root_of(tree, m->object);
    if (!root) return nullptr;
    if (!is_scope(*root)) {
      const Value* v = Environment::value_of(env_.find(*root));
      if (v == nullptr || v->is_num() || !may_hold_entries(*v)) return nullptr;
    }
    return place(tree, id, access).value;
  }
  if (array_of(e) || std::holds_alternative<ast::Element>(e.node)) {
    return place(tree, id, access).value;
  }
  return nullptr;
}

/// True if the expression is made of names, subscripts and keys, and may lead into a dictionary.
/// Nothing is evaluated: subscripts may draw random numbers.
bool Interpreter::leads_to_entry(const ast::Tree& tree, ast::ExprId id) const {
  const auto& node = tree.exprs[id].node;
  if (std::holds_alternative<ast::Name>(node)) return false;
  const auto root = root_of(tree, id);
  return root && in_dictionary(*root);
}

/// Makes `slot` stand for the entry or element that such an expression leads to. A component of a
/// vector on the way has no place of its own: then the slot holds its value.
void Interpreter::refer(const ast::Tree& tree, ast::ExprId id, Slot& slot) {
  const ast::Expr& e = tree.exprs[id];
  const auto start_at = [&](Slot* variable, SymbolId name, Span span) {
    if (Environment::value_of(variable) == nullptr) unknown_name(name, span);
    slot.target = variable;
  };
  const auto key_text = [&](SymbolId key) { return Text(name_of(key)); };
  if (const auto* name = std::get_if<ast::Name>(&e.node)) {
    return start_at(env_.find(name->name), name->name, e.span);
  }
  if (const auto* index = std::get_if<ast::Index>(&e.node)) {
    ast::Range subscripts = index->subscripts;
    if (is_scope(index->name)) {
      const Text key = evaluate_text(tree, tree.expr_lists[subscripts.first]);
      const SymbolId name = symbols_.intern(key.bytes());
      start_at(scope_slot(index->name, name), name, e.span);
      subscripts = {subscripts.first + 1, subscripts.count - 1};
    } else {
      start_at(env_.find(index->name), index->name, e.span);
    }
    return refer_into(tree, subscripts, slot, e.span);
  }
  if (const auto* element_of = std::get_if<ast::Element>(&e.node)) {
    refer(tree, element_of->object, slot);
    return refer_into(tree, element_of->subscripts, slot, e.span);
  }
  const auto& member = std::get<ast::Member>(e.node);
  if (const auto* object = std::get_if<ast::Name>(&tree.exprs[member.object].node);
      object != nullptr && is_scope(object->name)) {
    return start_at(scope_slot(object->name, member.member), member.member, e.span);
  }
  refer(tree, member.object, slot);
  Value& holder = *Environment::value_of(&slot);
  if (const Num* number = holder.get<Num>()) {
    Num n = *number;
    n.length = take_member(n.v.data(), n.length, member.member, e.span, 1);
    slot.target = nullptr;
    slot.path.clear();
    return store_number(slot.value, Num(n.v[0]));
  }
  if (!is_dictionary(holder)) {
    fail(Code::wrong_kind, tree.exprs[member.object].span,
         fmt::format("expected a dictionary, found {}", kind_name(holder)));
  }
  dictionary_entry(holder, key_text(member.member), e.span, Access::read);
  slot.path.emplace_back(key_text(member.member));
}

/// Appends the steps of a list of subscripts to the path of `slot`.
void Interpreter::refer_into(const ast::Tree& tree, ast::Range list, Slot& slot, Span span) {
  for (std::uint32_t used = 0; used < list.count;) {
    Value& holder = *Environment::value_of(&slot);
    const auto at = [&](std::uint32_t i) { return tree.expr_lists[list.first + i]; };
    if (is_dictionary(holder)) {
      Text key = evaluate_text(tree, at(used));
      dictionary_entry(holder, key, tree.exprs[at(used)].span, Access::read);
      slot.path.emplace_back(std::move(key));
      ++used;
      continue;
    }
    const Array* array = own_array(holder);
    if (array == nullptr) {
      fail(Code::wrong_kind, span,
           fmt::format("expected an array or dictionary, found {}", kind_name(holder)));
    }
    Subscripts numbers;
    for (std::size_t d = 0; d < array->sizes.size() && used < list.count; ++d, ++used) {
      numbers.add(read_subscript(tree, at(used)));
    }
    std::size_t taken = 0;
    const std::size_t index = flat_index(numbers, *array, span, taken);
    if (!array->elements[index].defined()) {
      fail(Code::evaluation, span, "this array element has no value yet");
    }
    slot.path.emplace_back(index);
  }
}

/// The slot of `name` in the scope that `local` or `global` stands for; null if there is none.
Slot* Interpreter::scope_slot(SymbolId scope, SymbolId name) {
  return env_.find_in_scope(name, scope == w::local ? env_.scope() : 0);
}

}  // namespace durer::interpreter

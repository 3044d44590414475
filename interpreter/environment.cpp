#include "interpreter/environment.h"

#include <algorithm>

namespace durer::interpreter {

namespace {

Value* element_of(Value& v, std::size_t index) {
  Array* array = own_array(v);
  return array == nullptr || index >= array->elements.size() ? nullptr : &array->elements[index];
}

Value* entry_of(Value& v, const Text& key) {
  Dictionary* dictionary = own_dictionary(v);
  if (dictionary == nullptr) return nullptr;
  const auto it = dictionary->entries.find(key);
  return it == dictionary->entries.end() ? nullptr : &it->second;
}

}  // namespace

Slot* Environment::find_in_scope(SymbolId name, std::uint32_t scope) const {
  for (Slot* s = find(name); s != nullptr && s->scope >= scope; s = s->below) {
    if (s->scope == scope) return s;
  }
  return nullptr;
}

Value* Environment::referred(Slot* slot) {
  Value* v = value_of(slot->target);
  // What they lead to may be assigned through the reference: it must not be shared with a copy.
  for (const Step& step : slot->path) {
    if (v == nullptr) return nullptr;
    v = std::holds_alternative<Text>(step) ? entry_of(*v, std::get<Text>(step))
                                           : element_of(*v, std::get<std::size_t>(step));
  }
  return v;
}

void Environment::link(Slot& slot, SymbolId name) {
  const std::uint32_t innermost = scope();
  if (innermost == 0 || name >= visible_.size()) return link(slot, name, innermost);
  // Nothing can be in a newer scope.
  slot.name = name;
  slot.scope = innermost;
  slot.below = visible_[name];
  visible_[name] = &slot;
  owned_.push_back(&slot);
}

void Environment::link(Slot& slot, SymbolId name, std::uint32_t scope) {
  if (name >= visible_.size()) visible_.resize(name + 64, nullptr);
  slot.name = name;
  slot.scope = scope;
  // Newer scopes hide older ones: keep the chain in that order.
  Slot** link = &visible_[name];
  while (*link != nullptr && (*link)->scope > scope) link = &(*link)->below;
  slot.below = *link;
  *link = &slot;
  if (scope == 0) return;
  if (scope == scope_begin_.size()) {
    owned_.push_back(&slot);
  } else {
    // An outer scope: the value of a #local may end inside a macro that it calls.
    owned_.insert(owned_.begin() + static_cast<std::ptrdiff_t>(scope_begin_[scope]), &slot);
    for (std::size_t i = scope; i < scope_begin_.size(); ++i) ++scope_begin_[i];
  }
}

Slot& Environment::insert(SymbolId name, std::uint32_t scope) {
  Slot& slot = make();
  link(slot, name, scope);
  return slot;
}

Slot& Environment::in_scope(SymbolId name, std::uint32_t scope) {
  Slot* s = find_in_scope(name, scope);
  return s != nullptr ? *s : insert(name, scope);
}

void Environment::unlink(Slot& slot) {
  for (Slot** link = &visible_[slot.name]; *link != nullptr; link = &(*link)->below) {
    if (*link == &slot) {
      *link = slot.below;
      return;
    }
  }
}

bool Environment::undefine(SymbolId name) {
  Slot* s = find(name);
  if (s == nullptr) return false;
  unlink(*s);
  s->deprecated.reset();
  // The slot is not reused before its scope ends: a reference parameter may still point at it.
  s->value = Value{};
  return true;
}

void Environment::close_scope() {
  const std::size_t begin = scope_begin_.back();
  while (owned_.size() > begin) {
    Slot* s = owned_.back();
    owned_.pop_back();
    if (visible_[s->name] == s) {
      visible_[s->name] = s->below;
    } else {
      unlink(*s);
    }
    s->value.clear();
    s->target = nullptr;
    s->declared = {};
    if (!s->path.empty()) s->path.clear();
    if (s->deprecated) s->deprecated.reset();
    free_.push_back(s);
  }
  scope_begin_.pop_back();
}

std::vector<SymbolId> Environment::visible_names() const {
  std::vector<SymbolId> names;
  for (SymbolId id = 0; id < visible_.size(); ++id) {
    if (visible_[id] != nullptr) names.push_back(id);
  }
  return names;
}

}  // namespace durer::interpreter

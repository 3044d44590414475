// Names and what they stand for, in dynamic scopes (language §4.2).
//
// Binding is shallow: every symbol knows its innermost visible slot, so a look-up is one array
// access, and opening or closing a scope costs only what it declares.
#pragma once

#include <cstdint>
#include <deque>
#include <variant>
#include <vector>

#include "grammar/vocabulary.h"
#include "interpreter/value.h"

namespace durer::interpreter {

using grammar::SymbolId;

/// A name that its author wants nobody to use any more (`#declare deprecated`).
struct Deprecation {
  std::string message;
  bool once = false;
  bool told = false;
};

/// A step from a value into what it holds: the flat index of an element, or the key of an entry.
using Step = std::variant<std::size_t, Text>;

struct Slot {
  Value value;
  std::shared_ptr<Deprecation> deprecated;
  Slot* below = nullptr;  // the slot of the same name that this one hides
  SymbolId name = 0;
  std::uint32_t scope = 0;
  Span declared;  // where it was last declared, as far as known
  /// By-reference parameters: the caller's slot; with `path`, what these steps lead to in its value
  /// (language §4.6).
  Slot* target = nullptr;
  std::vector<Step> path;
};

class Environment {
 public:
  /// Innermost visible slot of `name`, null if undeclared. Parameters passed by reference are
  /// slots of their own; `value_of` follows them.
  [[nodiscard]] Slot* find(SymbolId name) const {
    return name < visible_.size() ? visible_[name] : nullptr;
  }
  [[nodiscard]] Slot* find_in_scope(SymbolId name, std::uint32_t scope) const;

  /// What the slot stands for; follows references. Null if it has no value.
  [[nodiscard]] static Value* value_of(Slot* slot) {
    if (slot == nullptr || slot->target == nullptr) return slot == nullptr ? nullptr : &slot->value;
    return slot->path.empty() && slot->target->target == nullptr ? &slot->target->value
                                                                 : referred(slot);
  }

  /// The slot that `#local name` writes: the one of the current scope, else a new one in it.
  Slot& for_local(SymbolId name) { return in_scope(name, scope()); }
  /// The slot of `name` in an open scope, made if it is not there.
  Slot& in_scope(SymbolId name, std::uint32_t scope);
  /// A slot in the outermost scope, for macros and file handles.
  Slot& for_global(SymbolId name) { return in_scope(name, 0); }
  /// A slot that has no name yet: it may be filled before the scope opens where it belongs.
  Slot& make() {
    if (free_.empty()) return slots_.emplace_back();
    Slot* slot = free_.back();
    free_.pop_back();
    return *slot;  // close_scope has emptied it
  }
  /// Puts it into the current scope, hiding any other of the name (macro parameters).
  void link(Slot& slot, SymbolId name);

  /// Removes the innermost visible `name`; false if there is none.
  bool undefine(SymbolId name);

  void open_scope() { scope_begin_.push_back(owned_.size()); }
  void close_scope();
  [[nodiscard]] std::uint32_t scope() const {
    return static_cast<std::uint32_t>(scope_begin_.size());
  }

  /// All visible names, for "did you mean".
  [[nodiscard]] std::vector<SymbolId> visible_names() const;

 private:
  [[nodiscard]] static Value* referred(Slot* slot);
  Slot& insert(SymbolId name, std::uint32_t scope);
  void link(Slot& slot, SymbolId name, std::uint32_t scope);
  void unlink(Slot& slot);

  std::deque<Slot> slots_;  // a deque: slots never move
  std::vector<Slot*> free_;
  std::vector<Slot*> visible_;  // by symbol
  std::vector<Slot*> owned_;    // slots of local scopes, innermost last
  std::vector<std::size_t> scope_begin_;
};

}  // namespace durer::interpreter

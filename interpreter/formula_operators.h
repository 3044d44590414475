// What the operators of formulas do to floats, and how formulas see variables.
#pragma once

#include <cmath>

#include "interpreter/environment.h"
#include "interpreter/formula.h"

namespace durer::interpreter {

[[nodiscard]] inline double truth(bool b) { return b ? 1.0 : 0.0; }

/// False where the division must be told.
[[nodiscard]] inline bool apply_floats(FormulaOp::Kind kind, double a, double b, double& out) {
  using Kind = FormulaOp::Kind;
  switch (kind) {
    case Kind::add: out = a + b; return true;
    case Kind::sub: out = a - b; return true;
    case Kind::mul: out = a * b; return true;
    case Kind::div: out = a / b; return b != 0;
    case Kind::lt: out = truth(a < b); return true;
    case Kind::le: out = truth(a < b || nearly_equal(a, b)); return true;
    case Kind::eq: out = truth(nearly_equal(a, b)); return true;
    case Kind::ne: out = truth(!nearly_equal(a, b)); return true;
    case Kind::ge: out = truth(a > b || nearly_equal(a, b)); return true;
    case Kind::gt: out = truth(a > b); return true;
    case Kind::and_: out = truth(std::abs(a) > epsilon && std::abs(b) > epsilon); return true;
    case Kind::or_: out = truth(std::abs(a) > epsilon || std::abs(b) > epsilon); return true;
    default: return false;
  }
}

/// What the name stands for; null if it has no value, or if whoever uses it is to be told.
[[nodiscard]] inline const Value* value_of(const Environment& env, SymbolId name) {
  Slot* slot = env.find(name);
  return slot == nullptr || slot->deprecated ? nullptr : Environment::value_of(slot);
}

/// The guards of macros in line, before the code may go on.
[[nodiscard]] inline bool is_still_macro(const Environment& env, SymbolId name,
                                         const ast::Macro* macro) {
  const Value* v = value_of(env, name);
  const MacroRef* ref = v == nullptr ? nullptr : v->get<MacroRef>();
  return ref != nullptr && ref->macro == macro;
}
/// A #local may hide what the name stands for.
[[nodiscard]] inline bool may_be_hidden(const Environment& env, SymbolId name) {
  if (env.find(name) == nullptr) return true;
  const Value* v = value_of(env, name);
  return v != nullptr && (v->is_num() || v->get<Shared<Text>>() != nullptr);
}
[[nodiscard]] inline bool has_value(const Environment& env, SymbolId name) {
  const Value* v = value_of(env, name);
  return v != nullptr && v->defined();
}

}  // namespace durer::interpreter

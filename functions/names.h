// How operations and members are called in the bodies of functions (language §6.2).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "functions/builder.h"

namespace durer::functions {

/// A built-in that becomes one operation per call, or a chain of them: min(a, b, c).
struct BuiltIn {
  std::string_view name;
  Op op;
  int arity;           // of the operation
  bool chain = false;  // takes `arity` or more arguments
};

/// All of them, sorted by name. `degrees`, `radians`, `select`, `sum`, `prod` are not among them.
[[nodiscard]] std::span<const BuiltIn> built_ins();
/// The one of that name, or null.
[[nodiscard]] const BuiltIn* built_in(std::string_view name);

/// The member of that name: x y z t, u v, red green blue filter transmit, gray or grey, hf.
[[nodiscard]] std::optional<Member> member_named(std::string_view name);

}  // namespace durer::functions

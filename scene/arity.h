// How many members an aggregate has, so that the tables of fields.h cannot fall behind.
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>

namespace durer::scene {

/// Converts to the type of any member. Not to `optional`, which would rather convert it itself.
struct AnyMember {
  template <typename T>
  static constexpr bool is_optional = false;
  template <typename T>
  requires(!is_optional<T>) operator T() const noexcept;  // NOLINT: meant to convert
};
template <typename T>
inline constexpr bool AnyMember::is_optional<std::optional<T>> = true;

template <typename T, typename... Members>
concept TakesMembers = requires {
  T{Members{}...};
};

/// Adds initialisers as long as the aggregate takes them.
template <typename T, typename... Members>
constexpr std::size_t arity() {
  if constexpr (TakesMembers<T, Members..., AnyMember>) {
    return arity<T, Members..., AnyMember>();
  } else {
    return sizeof...(Members);
  }
}

}  // namespace durer::scene

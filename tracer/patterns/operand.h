// Operands of patterns and warps: members of a struct that the language can name.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <string_view>
#include <type_traits>

#include "base/vec.h"
#include "scene/type_info.h"

namespace durer::tracer {

/// Room for the own struct of a pattern or warp inside a texture program.
struct PatternState {
  alignas(double) std::array<std::byte, 96> bytes;

  template <typename P>
  [[nodiscard]] const P& as() const {
    return *std::launder(reinterpret_cast<const P*>(bytes.data()));
  }
};

namespace patterns {

/// An operand as a member of P.
template <typename P>
struct Operand {
  scene::Param param;
  void (*load)(P& pattern, const double* args) = nullptr;
  void (*store)(const P& pattern, double* args) = nullptr;
};

/// Two numbers that are written one after the other, the second one optional.
struct Pair {
  double first = 0;
  double second = 0;
};

namespace detail {

template <typename>
struct MemberOf;
template <typename P, typename T>
struct MemberOf<T P::*> {
  using Owner = P;
  using Type = T;
};

// The language keeps some numbers in single precision; `float` members get them rounded.
constexpr void load(double& to, const double* from) { to = from[0]; }
constexpr void load(float& to, const double* from) { to = static_cast<float>(from[0]); }
constexpr void load(bool& to, const double* from) { to = from[0] != 0; }
constexpr void load(Pair& to, const double* from) { to = {from[0], from[1]}; }
constexpr void load(dvec2& to, const double* from) { to = {from[0], from[1]}; }
constexpr void load(dvec3& to, const double* from) { to = {from[0], from[1], from[2]}; }
constexpr void store(double from, double* to) { to[0] = from; }
constexpr void store(bool from, double* to) { to[0] = from ? 1 : 0; }
constexpr void store(Pair from, double* to) { to[0] = from.first, to[1] = from.second; }
constexpr void store(dvec2 from, double* to) { to[0] = from.x, to[1] = from.y; }
constexpr void store(dvec3 from, double* to) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }

template <typename T>
inline constexpr scene::ArgKind kind_of = scene::ArgKind::number;
template <>
inline constexpr scene::ArgKind kind_of<bool> = scene::ArgKind::flag;
template <>
inline constexpr scene::ArgKind kind_of<Pair> = scene::ArgKind::pair;
template <>
inline constexpr scene::ArgKind kind_of<dvec2> = scene::ArgKind::vector2;
template <>
inline constexpr scene::ArgKind kind_of<dvec3> = scene::ArgKind::vector;

template <auto member>
constexpr auto operand(std::string_view name, std::string_view doc, bool positional,
                       bool optional) {
  using P = typename MemberOf<decltype(member)>::Owner;
  Operand<P> o;
  o.param.name = name;
  o.param.kind = kind_of<typename MemberOf<decltype(member)>::Type>;
  o.param.doc = doc;
  o.param.positional = positional;
  o.param.optional = optional;
  o.load = [](P& p, const double* args) { detail::load(p.*member, args); };
  o.store = [](const P& p, double* args) { detail::store(p.*member, args); };
  return o;
}

template <typename P>
concept HasOperands = requires { P::operands.size(); };

// The operands of P as the language sees them; a default value is that of the member.
template <typename P>
constexpr auto params_of() {
  if constexpr (HasOperands<P>) {
    std::array<scene::Param, P::operands.size()> params{};
    for (std::size_t i = 0; i < params.size(); ++i) {
      params[i] = P::operands[i].param;
      P::operands[i].store(P{}, params[i].fallback.data());
    }
    return params;
  } else {
    return std::array<scene::Param, 0>{};
  }
}

template <typename P>
inline constexpr auto params = params_of<P>();

/// Makes a P of operands in `state`.
template <typename P>
P& load_all(std::span<const double> args, PatternState& state) {
  static_assert(std::is_trivially_copyable_v<P> && sizeof(P) <= sizeof(PatternState));
  P* pattern = ::new (state.bytes.data()) P{};
  if constexpr (HasOperands<P>) {
    const double* next = args.data();
    for (const auto& o : P::operands) {
      o.load(*pattern, next);
      next += scene::width(o.param.kind);
    }
  }
  return *pattern;
}

}  // namespace detail

/// An operand that stands right after the name.
template <auto member>
constexpr auto positional(std::string_view name, std::string_view doc) {
  return detail::operand<member>(name, doc, true, false);
}

/// An operand right after the name, which may be missing.
template <auto member>
constexpr auto optional_positional(std::string_view name, std::string_view doc) {
  return detail::operand<member>(name, doc, true, true);
}

/// An operand behind a word of its own, which may be missing.
template <auto member>
constexpr auto keyword(std::string_view name, std::string_view doc) {
  return detail::operand<member>(name, doc, false, true);
}

}  // namespace patterns
}  // namespace durer::tracer

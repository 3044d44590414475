// How a pattern is described: one struct with defaulted members, evidence and a call operator
// becomes the language's description and the tracer's evaluator.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <type_traits>

#include "base/vec.h"
#include "scene/type_info.h"

namespace durer::tracer {

/// Evidence: the value of a pattern with default operands at one point.
struct PatternSample {
  dvec3 p;
  double value;
};

/// Room for the pattern's own struct inside a texture program.
struct PatternState {
  alignas(double) std::array<std::byte, 64> bytes;
};

/// A pattern as the tracer runs it. `evaluate` is the raw value before frequency, phase and wave
/// (textures §3, step 2).
struct PatternType : scene::PatternInfo {
  void (*prepare)(std::span<const double> args, PatternState& state) = nullptr;
  double (*evaluate)(const PatternState& state, dvec3 p) = nullptr;
  std::span<const PatternSample> samples;
};

namespace patterns {

using Sample = PatternSample;

/// An operand as a member of P.
template <typename P>
struct Operand {
  scene::Param param;
  void (*load)(P& pattern, const double* args) = nullptr;
  void (*store)(const P& pattern, double* args) = nullptr;
};

namespace detail {

template <typename>
struct MemberOf;
template <typename P, typename T>
struct MemberOf<T P::*> {
  using Owner = P;
  using Type = T;
};

constexpr void load(double& to, const double* from) { to = from[0]; }
constexpr void load(dvec3& to, const double* from) { to = {from[0], from[1], from[2]}; }
constexpr void store(double from, double* to) { to[0] = from; }
constexpr void store(dvec3 from, double* to) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }

template <auto member>
constexpr auto operand(std::string_view name, std::string_view doc, bool positional) {
  using P = typename MemberOf<decltype(member)>::Owner;
  using T = typename MemberOf<decltype(member)>::Type;
  constexpr bool vector = std::is_same_v<T, dvec3>;
  Operand<P> o;
  o.param.name = name;
  o.param.kind = vector ? scene::ArgKind::vector : scene::ArgKind::number;
  o.param.doc = doc;
  o.param.positional = positional;
  o.param.optional = !positional;
  o.load = [](P& p, const double* args) { detail::load(p.*member, args); };
  o.store = [](const P& p, double* args) { detail::store(p.*member, args); };
  return o;
}

template <typename P>
concept HasOperands = requires {
  P::operands.size();
};

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

template <typename P>
void prepare(std::span<const double> args, PatternState& state) {
  P* pattern = ::new (state.bytes.data()) P{};
  if constexpr (HasOperands<P>) {
    const double* next = args.data();
    for (const Operand<P>& o : P::operands) {
      o.load(*pattern, next);
      next += scene::width(o.param.kind);
    }
  }
  if constexpr (requires { pattern->prepare(); }) pattern->prepare();
}

template <typename P>
double evaluate(const PatternState& state, dvec3 p) {
  return (*std::launder(reinterpret_cast<const P*>(state.bytes.data())))(p);
}

}  // namespace detail

/// An operand that stands right after the pattern's name.
template <auto member>
constexpr auto positional(std::string_view name, std::string_view doc) {
  return detail::operand<member>(name, doc, true);
}

/// An operand behind a word of its own, which may be missing.
template <auto member>
constexpr auto keyword(std::string_view name, std::string_view doc) {
  return detail::operand<member>(name, doc, false);
}

/// Options of a description beyond name and words.
struct PatternTraits {
  scene::Wave wave = scene::Wave::ramp;
  int list_size = 0;
  std::span<const scene::MapEntry> default_map;
  bool takes_function = false;
};

/// Describes the pattern P: default members, `operands` (optional), `samples`, an optional
/// `prepare()` for what depends on operands alone, and `double operator()(dvec3) const`.
template <typename P>
constexpr PatternType describe_pattern(std::string_view name, std::string_view doc,
                                       PatternTraits traits) {
  static_assert(std::is_trivially_copyable_v<P> && sizeof(P) <= sizeof(PatternState));
  static_assert(P::samples.size() > 0, "a pattern brings its own evidence");
  PatternType type;
  type.name = name;
  type.doc = doc;
  type.params = detail::params<P>;
  type.wave = traits.wave;
  type.list_size = traits.list_size;
  type.default_map = traits.default_map;
  type.takes_function = traits.takes_function;
  type.prepare = &detail::prepare<P>;
  type.evaluate = &detail::evaluate<P>;
  type.samples = P::samples;
  return type;
}

/// Colours of the default maps and lists (textures §11.4, §11.5).
[[nodiscard]] constexpr scene::MapEntry entry(float key, float r, float g, float b) {
  return {key, Colour{{r, g, b}, 0, 0}};
}
inline constexpr std::array black_to_white{entry(0, 0, 0, 0), entry(1, 1, 1, 1)};

}  // namespace patterns
}  // namespace durer::tracer

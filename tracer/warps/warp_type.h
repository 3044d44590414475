// How a warp is described: a struct with operands and a call operator that moves a point.
#pragma once

#include "tracer/patterns/operand.h"

namespace durer::tracer {

/// A warp as the tracer runs it.
struct WarpType : scene::TypeInfo {
  void (*prepare)(std::span<const double> args, PatternState& state) = nullptr;
  dvec3 (*apply)(const PatternState& state, const dvec3& p) = nullptr;
  /// The same for several points, in place.
  void (*apply_all)(const PatternState& state, std::span<dvec3> points) = nullptr;
};

namespace warps {

using patterns::keyword;
using patterns::optional_positional;
using patterns::positional;

namespace detail {

template <typename W>
void prepare(std::span<const double> args, PatternState& state) {
  W& warp = patterns::detail::load_all<W>(args, state);
  if constexpr (requires { warp.prepare(); }) warp.prepare();
}

template <typename W>
dvec3 apply(const PatternState& state, const dvec3& p) {
  return state.as<W>()(p);
}

template <typename W>
void apply_all(const PatternState& state, std::span<dvec3> points) {
  const W& warp = state.as<W>();
  if constexpr (requires { warp.move(points); }) {
    warp.move(points);
  } else {
    for (dvec3& p : points) p = warp(p);
  }
}

template <typename W>
concept Validates = requires(std::span<const double> args) { W::validate(args); };

}  // namespace detail

/// Describes the warp W: default members, `operands`, an optional `prepare()`, an optional
/// `validate` (TypeInfo), and `dvec3 operator()(dvec3) const`; `void move(std::span<dvec3>) const`
/// if several points at a time are faster.
template <typename W>
constexpr WarpType describe_warp(std::string_view name, std::string_view doc) {
  WarpType type;
  type.name = name;
  type.doc = doc;
  type.params = patterns::detail::params<W>;
  if constexpr (detail::Validates<W>) type.validate = &W::validate;
  type.prepare = &detail::prepare<W>;
  type.apply = &detail::apply<W>;
  type.apply_all = &detail::apply_all<W>;
  return type;
}

}  // namespace warps
}  // namespace durer::tracer

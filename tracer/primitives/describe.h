// From a struct to a primitive type: operands are members, listed once with their names and
// documentation. Everything else (binding, defaults, checks, stores, tests) follows from that list.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec.h"
#include "functions/noise.h"
#include "scene/object.h"
#include "scene/type_info.h"
#include "tracer/primitives/typed_store.h"

namespace durer::tracer {

/// What of the scene a primitive may depend on beside its operands.
struct Surroundings {
  functions::NoiseGenerator noise_generator = 2;  // resolved: 1, 2 or 3
};

/// A primitive of the language: its operands (TypeInfo), how to place one, and samples for tests.
struct PrimitiveType : scene::TypeInfo {
  TypeStores (*make_stores)() = nullptr;
  /// Places one primitive with these operands; see TypeStores. None: it has no surface and no
  /// inside (radius 0 and the like).
  std::optional<ShapeRef> (*place)(TypeStores& stores, std::span<const double> args,
                                   const Transform& to_world, bool inverted) = nullptr;
  /// The same, with surface coordinates that turn with it; null if `place` does that.
  decltype(place) place_for_uv = nullptr;
  /// The same as `place` for an object that is more than its operands (a mesh, functions), and examples of
  /// such; null for all others.
  std::optional<ShapeRef> (*place_whole)(TypeStores& stores, const scene::Object& object,
                                         const Surroundings& around, const Transform& to_world,
                                         bool inverted) = nullptr;
  std::vector<scene::Object> (*sample_objects)() = nullptr;
  /// Operands of typical and odd examples, for the conformance suite.
  std::vector<std::vector<double>> (*samples)() = nullptr;
  /// Normals point to whichever side the order of the operands gives, as the oracle's do.
  bool sides_by_order = false;
  /// By how much a hit may depend on where the search for it began, relative.
  double hit_tolerance = 1e-12;
};

/// Places an object that is a primitive, whatever its operands are. `by_uv`: its surface coordinates
/// count.
inline std::optional<ShapeRef> place_object(const PrimitiveType& type, TypeStores& stores,
                                            const scene::Object& object,
                                            const Surroundings& around, const Transform& to_world,
                                            bool inverted, bool by_uv = false) {
  if (type.place_whole != nullptr) {
    return type.place_whole(stores, object, around, to_world, inverted);
  }
  const auto place = by_uv && type.place_for_uv != nullptr ? type.place_for_uv : type.place;
  return place(stores, {object.args.data(), object.args.size()}, to_world, inverted);
}

/// One operand as a member of P.
template <typename P>
struct Field {
  scene::Param param;
  void (*set)(P&, const double*) = nullptr;
  void (*get)(const P&, double*) = nullptr;
};

namespace detail {

template <typename M>
struct MemberOf;
template <typename P, typename T>
struct MemberOf<T P::*> {
  using Owner = P;
  using Type = T;
};

template <typename T>
inline constexpr scene::ArgKind kind_of = scene::ArgKind::number;
template <>
inline constexpr scene::ArgKind kind_of<dvec2> = scene::ArgKind::vector2;
template <>
inline constexpr scene::ArgKind kind_of<dvec3> = scene::ArgKind::vector;
template <>
inline constexpr scene::ArgKind kind_of<bool> = scene::ArgKind::flag;

constexpr void load(double& to, const double* from) { to = from[0]; }
constexpr void load(bool& to, const double* from) { to = from[0] != 0; }
constexpr void load(dvec2& to, const double* from) { to = {from[0], from[1]}; }
constexpr void load(dvec3& to, const double* from) { to = {from[0], from[1], from[2]}; }
constexpr void store(double from, double* to) { to[0] = from; }
constexpr void store(bool from, double* to) { to[0] = from ? 1 : 0; }
constexpr void store(dvec2 from, double* to) { to[0] = from.x, to[1] = from.y; }
constexpr void store(dvec3 from, double* to) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }

template <auto member>
constexpr auto field(std::string_view name, std::string_view doc, bool positional, bool optional) {
  using P = typename MemberOf<decltype(member)>::Owner;
  using T = typename MemberOf<decltype(member)>::Type;
  return Field<P>{{name, kind_of<T>, doc, positional, optional, {}},
                  [](P& p, const double* args) { load(p.*member, args); },
                  [](const P& p, double* args) { store(p.*member, args); }};
}

/// The operands of P as the language sees them; a default value is that of the member.
template <typename P>
inline constexpr auto param_table = [] {
  std::array<scene::Param, P::params.size()> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = P::params[i].param;
    P::params[i].get(P{}, table[i].fallback.data());
  }
  return table;
}();

template <typename P>
P from_args(std::span<const double> args) {
  P p;
  std::size_t at = 0;
  for (const Field<P>& f : P::params) {
    f.set(p, args.data() + at);
    at += scene::width(f.param.kind);
  }
  return p;
}

template <typename P>
std::vector<double> to_args(const P& p) {
  std::vector<double> args;
  for (const Field<P>& f : P::params) {
    std::array<double, 3> values{};
    f.get(p, values.data());
    args.insert(args.end(), values.begin(), values.begin() + scene::width(f.param.kind));
  }
  return args;
}

}  // namespace detail

/// A required operand in its place.
template <auto member>
constexpr auto positional(std::string_view name, std::string_view doc) {
  return detail::field<member>(name, doc, true, false);
}
/// A positional operand that may be missing.
template <auto member>
constexpr auto trailing(std::string_view name, std::string_view doc) {
  return detail::field<member>(name, doc, true, true);
}
/// A word that may follow the operands.
template <auto member>
constexpr auto flag(std::string_view name, std::string_view doc) {
  return detail::field<member>(name, doc, false, true);
}

/// The descriptor of P, which has
///   static constexpr std::array params{positional<&P::x>("x", "what it is"), …};
///   static std::vector<P> samples();
///   std::optional<std::string> problem() const;         optional: what is wrong with the operands
///   std::optional<std::string> doubt() const;           optional: what deserves a warning
/// and either is a Shape itself or has
///   std::optional<Framed<Shape>> shape() const;         none: nothing to see
template <typename P>
constexpr PrimitiveType describe(std::string_view name, std::string_view doc) {
  PrimitiveType type;
  type.name = name;
  type.doc = doc;
  type.params = detail::param_table<P>;
  if constexpr (requires(const P& p) { p.problem(); }) {
    type.validate = [](std::span<const double> args) {
      return detail::from_args<P>(args).problem();
    };
  }
  if constexpr (requires(const P& p) { p.doubt(); }) {
    type.doubt = [](std::span<const double> args) { return detail::from_args<P>(args).doubt(); };
  }
  if constexpr (requires(const P& p) { p.shape(); }) {
    using Shape = decltype(P{}.shape()->shape);
    type.make_stores = [] { return make_type_stores<Shape>(); };
    type.place = [](TypeStores& stores, std::span<const double> args, const Transform& to_world,
                    bool inverted) -> std::optional<ShapeRef> {
      const auto framed = detail::from_args<P>(args).shape();
      if (!framed) return std::nullopt;
      return place_shape(stores, framed->shape, framed->frame.then(to_world), inverted);
    };
  } else {
    type.make_stores = [] { return make_type_stores<P>(); };
    type.place = [](TypeStores& stores, std::span<const double> args, const Transform& to_world,
                    bool inverted) -> std::optional<ShapeRef> {
      return place_shape(stores, detail::from_args<P>(args), to_world, inverted);
    };
    if constexpr (requires { P::uv_turns; }) {
      type.place_for_uv = [](TypeStores& stores, std::span<const double> args,
                             const Transform& to_world,
                             bool inverted) -> std::optional<ShapeRef> {
        return place_shape(stores, detail::from_args<P>(args), to_world, inverted, true);
      };
    }
  }
  type.samples = [] {
    std::vector<std::vector<double>> all;
    for (const P& p : P::samples()) all.push_back(detail::to_args(p));
    return all;
  };
  return type;
}

/// The same type, marked as one that has no inside.
constexpr PrimitiveType patch(PrimitiveType type) {
  type.is_patch = true;
  return type;
}

}  // namespace durer::tracer

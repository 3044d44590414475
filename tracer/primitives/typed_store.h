// The store of one shape type. A shape is a struct with
//   Bounds3 bounds() const;                               of its surface
//   bool contains(dvec3 p) const;
//   dvec3 normal(dvec3 p, std::uint32_t part) const;      outward, any length
//   void crossings(const Ray&, Crossings&) const;         whole line, any order, any |d|
//   std::optional<Nearest> nearest(const Ray&, double t_from, double t_to) const;
// and optionally
//   bool begins_inside(const Ray&) const;                 unbounded inside: state at t = -infinity
//   Bounds3 inside_bounds() const;                        if it is not bounds()
//   Bounds3 inside_within(const Bounds3&) const;          unbounded inside: its part in a box
//   std::optional<Shape> moved(const Transform&) const;   the shape in another space, if it has one
//   Shape flipped() const;                                the inverse, if it is such a shape too
//   … nearest_of_unit(same as nearest) const;             faster where |d| = 1
//   … any(same as nearest) const;                         some hit in the range, if that is faster
//   void nearest(const PacketRays& rays, bool any, PacketHits& hits) const;
//                                                         the same for several rays, if that is
//                                                         faster: see Targets::nearest_together;
//                                                         `any`: some hit in the range will do
//   void normals(const PacketPoints& points, PacketVectors& out) const;
//                                                         as normal(), for as many points
//   dvec2 uv(dvec3 p, std::uint32_t part) const;          surface coordinates (objects §14)
//   static constexpr bool uv_turns = true;                they need a space that turns with it
//   TextureBlend textures(dvec3 p, std::uint32_t part) const;   looks of single parts
//   std::pair<std::string, std::string> doubt() const;    see Store::doubt
//   bool misses(const ShaftHull&) const;                  certainly outside of it, see
//   Targets::misses static constexpr bool convex = true; static constexpr double far = …; greatest
//   depth at which it is seen dvec3 unit_normal;                                    if it is the
//   same everywhere
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <utility>

#include "base/transform.h"
#include "functions/simd/inline.h"
#include "tracer/primitives/store.h"
#include "tracer/query.h"

namespace durer::tracer {

/// A shape and the map from its canonical frame to object space.
template <typename S>
struct Framed {
  S shape;
  Transform frame;
};

/// Where a primitive went.
struct ShapeRef {
  Store* store = nullptr;
  std::uint32_t shape = 0;
  bool inverted = false;  // still to be applied: the shape could not flip itself
};

/// The stores of one type: shapes that could be moved into world space, and shapes that are asked
/// in a space of their own.
struct TypeStores {
  std::unique_ptr<Store> baked;
  std::unique_ptr<Store> placed;
};

template <typename S>
concept Shape = requires(const S& s, dvec3 p, const Ray& ray, Crossings& out) {
  { s.bounds() } -> std::same_as<Bounds3>;
  { s.contains(p) } -> std::same_as<bool>;
  { s.normal(p, 0U) } -> std::same_as<dvec3>;
  { s.crossings(ray, out) } -> std::same_as<void>;
  { s.nearest(ray, 0.0, 0.0) } -> std::same_as<std::optional<Nearest>>;
};

/// A shape that answers several rays together.
template <typename S>
concept PacketShape = Shape<S> && requires(const S& s, const PacketRays& rays, PacketHits& hits) {
  s.nearest(rays, false, hits);
};

/// A shape whose space is the world.
template <Shape S>
struct Baked {
  S shape;

  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    if constexpr (requires { shape.nearest_of_unit(ray, t_from, t_to); }) {
      return shape.nearest_of_unit(ray, t_from, t_to);
    } else {
      return shape.nearest(ray, t_from, t_to);
    }
  }
  [[nodiscard]] bool is_in_world() const { return true; }
  [[nodiscard]] const Ray& to_object(const Ray& ray) const { return ray; }
  [[nodiscard]] dvec3 to_object(dvec3 p) const { return p; }
  [[nodiscard]] dvec3 normal_to_world(dvec3 n) const { return n; }
  [[nodiscard]] dvec3 unit_normal() const requires requires { shape.unit_normal; }
  { return shape.unit_normal; }
  [[nodiscard]] Bounds3 to_world(const Bounds3& b) const { return b; }
  [[nodiscard]] std::pair<Affine, Affine> maps() const { return {}; }
  [[nodiscard]] bool misses(const ShaftHull& hull) const {
    if constexpr (requires { shape.misses(hull); }) return shape.misses(hull);
    return false;
  }
};

/// A shape in a space of its own. The ray's direction is not renormalised there, so that t stays
/// a world distance.
template <Shape S>
struct Placed {
  S shape;
  Affine to_shape;

  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    return shape.nearest(to_object(ray), t_from, t_to);
  }
  [[nodiscard]] std::optional<Nearest> any(const Ray& ray, double t_from,
                                           double t_to) const requires requires {
    shape.any(ray, t_from, t_to);
  }
  { return shape.any(to_object(ray), t_from, t_to); }
  [[nodiscard]] bool is_in_world() const { return to_shape == Affine(); }
  [[nodiscard]] Ray to_object(const Ray& ray) const {
    return {to_shape.point(ray.o), to_shape.vector(ray.d)};
  }
  [[nodiscard]] dvec3 to_object(dvec3 p) const { return to_shape.point(p); }
  [[nodiscard]] dvec3 normal_to_world(dvec3 n) const { return to_shape.covector(n); }
  [[nodiscard]] Bounds3 to_world(const Bounds3& b) const {
    const auto forward = to_shape.inverse();
    return forward ? b.transformed(*forward) : Bounds3{};
  }
  /// To the shape's space, and back.
  [[nodiscard]] std::pair<Affine, Affine> maps() const {
    return {to_shape, to_shape.inverse().value_or(Affine())};
  }
  [[nodiscard]] bool misses(const ShaftHull& hull) const {
    const ShaftHull local = hull.moved(to_shape);
    const Bounds3 apart = shape.bounds().intersection(local.bounds());
    const dvec3 gap = apart.lo - apart.hi;
    const dvec3 size = glm::max(glm::abs(apart.lo), glm::abs(apart.hi));
    if (std::max({gap.x, gap.y, gap.z}) > 1e-9 * std::max({1.0, size.x, size.y, size.z}))
      return true;
    if constexpr (requires { shape.misses(local); }) return shape.misses(local);
    return false;
  }
};

/// A box that may be unbounded on some sides only, around what it becomes in another space.
[[nodiscard]] Bounds3 through(const Bounds3& box, const Affine& map);

template <template <Shape> typename Placement, Shape S>
class TypedStore final : public Store {
 public:
  using Item = Placement<S>;

  TypedStore() {
    nearest = &nearest_of;
    if constexpr (PacketShape<S>) {
      nearest_together = &nearest_together_of;
      packet = &packet_of;
    }
  }

  std::uint32_t add(Item item) {
    items_.push_back(std::move(item));
    tags.emplace_back();
    return size() - 1;
  }

  [[nodiscard]] Bounds3 surface_bounds(std::uint32_t index) const override {
    return items_[index].to_world(items_[index].shape.bounds());
  }
  [[nodiscard]] Bounds3 inside_bounds(std::uint32_t index) const override {
    if constexpr (requires(const S& s) { s.inside_bounds(); }) {
      return items_[index].to_world(items_[index].shape.inside_bounds());
    } else {
      return surface_bounds(index);
    }
  }
  [[nodiscard]] Bounds3 inside_within(std::uint32_t index, const Bounds3& box) const override {
    if constexpr (requires(const S& s) { s.inside_within(box); }) {
      const auto [to_object, to_world] = items_[index].maps();
      return through(items_[index].shape.inside_within(through(box, to_object)), to_world);
    } else {
      return box;
    }
  }
  [[nodiscard]] bool contains(std::uint32_t index, dvec3 p) const override {
    return items_[index].shape.contains(items_[index].to_object(p));
  }
  [[nodiscard]] dvec3 normal(std::uint32_t index, dvec3 p, std::uint32_t part) const override {
    const Item& item = items_[index];
    if constexpr (requires { item.unit_normal(); }) return item.unit_normal();
    return glm::normalize(item.normal_to_world(item.shape.normal(item.to_object(p), part)));
  }
  void normals(std::uint32_t index, const PacketPoints& points, PacketVectors& out) const override {
    const Item& item = items_[index];
    if constexpr (requires { item.shape.normals(points, out); }) {
      if (item.is_in_world()) {
        item.shape.normals(points, out);
      } else {
        PacketPoints local;
        for (std::size_t i = 0; i < points.count; ++i) {
          local.add(item.to_object(points.p[i]), points.part[i]);
        }
        local.fill_up();
        item.shape.normals(local, out);
        for (std::size_t i = 0; i < points.count; ++i) out.set(i, item.normal_to_world(out[i]));
      }
      normalize(out, points.count);
    } else {
      for (std::size_t i = 0; i < points.count; ++i) {
        out.set(i, normal(index, points.p[i], points.part[i]));
      }
    }
  }
  [[nodiscard]] dvec2 uv(std::uint32_t index, dvec3 p, std::uint32_t part) const override {
    if constexpr (requires(const S& s) { s.uv(p, part); }) {
      return items_[index].shape.uv(items_[index].to_object(p), part);
    } else {
      return {p.x, p.y};
    }
  }
  [[nodiscard]] bool has_uv() const override {
    return requires(const S& s, dvec3 p) { s.uv(p, 0U); };
  }
  [[nodiscard]] TextureBlend textures(std::uint32_t index, dvec3 p,
                                      std::uint32_t part) const override {
    if constexpr (requires(const S& s) { s.textures(p, part); }) {
      return items_[index].shape.textures(items_[index].to_object(p), part);
    } else {
      return {};
    }
  }
  [[nodiscard]] std::pair<std::string, std::string> doubt(std::uint32_t index) const override {
    if constexpr (requires(const S& s) { s.doubt(); }) return items_[index].shape.doubt();
    return {};
  }
  [[nodiscard]] bool misses(std::uint32_t index, const ShaftHull& hull) const override {
    return items_[index].misses(hull);
  }
  [[nodiscard]] bool convex() const override {
    if constexpr (requires { S::convex; }) return S::convex;
    return false;
  }

  void crossings(std::span<const LeafShape> leaves, const Ray& ray, Crossings& out,
                 std::vector<std::uint32_t>& begun) const override {
    for (const LeafShape& leaf : leaves) {
      const Item& item = items_[leaf.shape];
      const std::size_t first = out.size();
      const Ray& local = item.to_object(ray);
      item.shape.crossings(local, out);
      for (std::size_t i = first; i < out.size(); ++i) out[i].leaf = leaf.leaf;
      if constexpr (requires(const S& s) { s.begins_inside(ray); }) {
        if (item.shape.begins_inside(local)) begun.push_back(leaf.leaf);
      }
    }
  }

 private:
  static void nearest_of(const Targets& targets, std::uint32_t index, RayQuery& query) {
    const auto& self = static_cast<const TypedStore&>(targets);
    if constexpr (PacketShape<S>) {
      if (query.later != nullptr && put_off(self, index, query)) return;
    }
    const std::optional<Nearest> hit = ask(self.items_[index], query, seen_to(query));
    if (hit) take(self, index, *hit, query);
  }

  static void nearest_together_of(const Targets& targets, std::uint32_t index,
                                  std::span<RayQuery* const> queries) {
    const auto& self = static_cast<const TypedStore&>(targets);
    PacketRays rays;
    for (const RayQuery* query : queries) rays.add(query->ray, query->t_from, query->t_to);
    rays.fill_up();
    PacketHits hits;
    packet_of(targets, index, rays, queries.front()->any, hits);
    for (std::uint32_t left = hits.met; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      take(self, index, {hits.t[i], hits.part[i]}, *queries[i]);
    }
  }

  static void packet_of(const Targets& targets, std::uint32_t index, const PacketRays& rays,
                        bool any, PacketHits& hits) {
    static_assert(!requires { S::far; });  // what is far away would have to be left out
    const Item& item = static_cast<const TypedStore&>(targets).items_[index];
    if (item.is_in_world()) return item.shape.nearest(rays, any, hits);
    PacketRays local;
    for (std::size_t i = 0; i < rays.count; ++i) {
      local.add(item.to_object(rays.ray(i)), rays.t_from[i], rays.t_to[i]);
    }
    local.fill_up();
    item.shape.nearest(local, any, hits);
  }

  /// True if the query need not be answered now.
  static bool put_off(const TypedStore& self, std::uint32_t index, RayQuery& query) {
    if ((self.tags[index].mask & query.mask) == 0) return true;
    if (query.later->add(self, index)) return true;
    ask_now(query);
    return query.any && query.found.store != nullptr;
  }

  static double seen_to(const RayQuery& query) {
    if constexpr (requires { S::far; }) return query.t_to < S::far ? query.t_to : S::far;
    return query.t_to;
  }

  DURER_INLINE static void take(const TypedStore& self, std::uint32_t index, const Nearest& hit,
                                RayQuery& query) {
    const Tag& tag = self.tags[index];
    if ((tag.mask & query.mask) == 0) return;
    if (tag.gated) return take_if_open(self, index, hit, query);
    query.t_to = hit.t;
    query.found = {&self, index, tag.leaf, hit.part};
  }
  /// A function of its own, for what it keeps over the call would be saved by every object.
  [[gnu::noinline]] static void take_if_open(const TypedStore& self, std::uint32_t index,
                                             Nearest hit, RayQuery& query) {
    const std::uint32_t leaf = self.tags[index].leaf;
    if (!gates_open(leaf, query)) return;
    query.t_to = hit.t;
    query.found = {&self, index, leaf, hit.part};
  }

  static std::optional<Nearest> ask(const Item& item, const RayQuery& query, double t_to) {
    if constexpr (requires { item.any(query.ray, query.t_from, t_to); }) {
      if (query.any) return item.any(query.ray, query.t_from, t_to);
    }
    return item.nearest(query.ray, query.t_from, t_to);
  }

  std::vector<Item> items_;
};

template <Shape S>
TypeStores make_type_stores() {
  return {std::make_unique<TypedStore<Baked, S>>(), std::make_unique<TypedStore<Placed, S>>()};
}

/// Puts a shape where it is fastest: into world space if it can move there, and need not keep a
/// space of its own.
template <Shape S>
ShapeRef place_shape(TypeStores& stores, S shape, const Transform& to_world, bool inverted,
                     bool keeps_space = false) {
  if constexpr (requires { shape.flipped(); }) {
    if (inverted) shape = shape.flipped();
    inverted = false;
  }
  if constexpr (requires { shape.moved(to_world); }) {
    if (const auto moved = keeps_space ? std::nullopt : shape.moved(to_world)) {
      auto& store = static_cast<TypedStore<Baked, S>&>(*stores.baked);
      return {&store, store.add({*moved}), inverted};
    }
  }
  auto& store = static_cast<TypedStore<Placed, S>&>(*stores.placed);
  return {&store, store.add({shape, to_world.backward}), inverted};
}

/// The first visible crossing in t_from <= t < t_to, for shapes without a shorter way.
inline std::optional<Nearest> first_visible(const Crossings& crossings, double t_from,
                                            double t_to) {
  std::optional<Nearest> best;
  for (const Crossing& c : crossings) {
    if (!c.visible || !(c.t >= t_from) || !(c.t < t_to)) continue;
    best = Nearest{c.t, c.part};
    t_to = c.t;
  }
  return best;
}

}  // namespace durer::tracer

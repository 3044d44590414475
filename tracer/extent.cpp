#include "tracer/extent.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer {
namespace {

using scene::NodeKind;
using scene::Object;
using scene::ObjectId;

/// Edges longer than this make the box of a solid endless (objects §3).
constexpr double critical_edge = 1e6;

Bounds3 stored(const Bounds3& b) {
  Bounds3 r;
  for (int i = 0; i < 3; ++i) {
    r.lo[i] = static_cast<float>(std::max(b.lo[i], -unbounded));
    r.hi[i] =
        r.lo[i] + static_cast<double>(static_cast<float>(std::min(b.hi[i], unbounded) - r.lo[i]));
  }
  return r;
}

double volume(const Bounds3& b) {
  const dvec3 edges = b.hi - b.lo;
  return edges.x * edges.y * edges.z;
}

/// The box of an object whose operands are not numbers.
std::optional<Bounds3> own_box(const scene::ObjectExtras& extras) {
  if (extras.mesh != nullptr) return extras.mesh->bounds();
  if (extras.isosurface != nullptr) return extras.isosurface->container.bounds();
  if (extras.parametric != nullptr) return extras.parametric->container.bounds();
  return std::nullopt;
}

class Measure {
 public:
  explicit Measure(const scene::Scene& scene) : scene_(scene) {}

  /// In the space around the object, once it is moved by `around`. The same for its inverse.
  Bounds3 box(ObjectId id, const Transform& around) {
    const Object& o = scene_.objects[id];
    const Transform inner = o.transform.then(around);
    Bounds3 b;
    switch (o.kind) {
      case NodeKind::primitive: b = primitive(o, inner); break;
      case NodeKind::light:
        if (!o.children.empty()) return box(o.children[0], inner);
        b = Bounds3::everything();
        break;
      case NodeKind::unsupported: b = Bounds3::everything(); break;
      case NodeKind::light_group:
      case NodeKind::union_:
      case NodeKind::merge:
        b = sum(o);
        b = stored(b.transformed(inner.forward));
        break;
      case NodeKind::intersection:
      case NodeKind::difference:
        b = intersection(o);
        b = stored(b.transformed(inner.forward));
        break;
    }
    if (const auto smaller = cut(b, o.extras->bounds, o.extras->bound_transform.then(around)))
      b = *smaller;
    return cut(b, o.extras->clips, o.extras->clip_transform.then(around)).value_or(b);
  }

  std::optional<Bounds3> bounding_box(ObjectId id, const Transform& around) {
    const Object& o = scene_.objects[id];
    return cut(primitive(o, o.transform.then(around)), o.extras->bounds,
               o.extras->bound_transform.then(around));
  }

 private:
  static std::optional<Bounds3> placed(const Object& o, const Transform& to_world) {
    if (const auto b = own_box(*o.extras)) return b->transformed(to_world.forward);
    const PrimitiveType& type = *primitive_types()[o.type];
    TypeStores stores = type.make_stores();
    const auto ref = place_object(type, stores, o, {}, to_world, false);
    if (!ref) return std::nullopt;
    return ref->store->surface_bounds(ref->shape);
  }

  static Bounds3 primitive(const Object& o, const Transform& to_world) {
    const auto b = placed(o, to_world);
    if (!b) return {dvec3(0.0), dvec3(0.0)};
    return b->infinite() ? Bounds3::everything() : stored(*b);
  }

  Bounds3 sum(const Object& o) {
    Bounds3 b;
    for (const ObjectId child : o.children) b.add(box(child, {}));
    return b.empty() ? Bounds3::everything() : stored(b);
  }

  // Inverted operands bound nothing, except that planes along an axis bound one side either way.
  Bounds3 intersection(const Object& o) {
    Bounds3 b{dvec3(-no_hit_depth), dvec3(no_hit_depth)};
    for (std::size_t i = 0; i < o.children.size(); ++i) {
      const Object& child = scene_.objects[o.children[i]];
      const bool subtracted = o.kind == NodeKind::difference && i > 0;
      const bool inverted = subtracted != child.inverse;
      if (child.kind == NodeKind::primitive) {
        b = b.intersection(half_space_or_box(child, o.children[i], inverted));
      } else if (!inverted) {
        b = b.intersection(box(o.children[i], {}));
      }
    }
    const dvec3 edges = b.hi - b.lo;
    if (b.empty() || std::max({edges.x, edges.y, edges.z}) > critical_edge) {
      return Bounds3::everything();
    }
    return stored(b);
  }

  Bounds3 half_space_or_box(const Object& child, ObjectId id, bool inverted) {
    if (own_box(*child.extras)) return inverted ? Bounds3::everything() : box(id, {});
    const PrimitiveType& type = *primitive_types()[child.type];
    TypeStores stores = type.make_stores();
    const auto ref = place_object(type, stores, child, {}, child.transform, inverted);
    if (!ref || ref->inverted) return Bounds3::everything();
    const Bounds3 own = ref->store->surface_bounds(ref->shape);
    return own.infinite() ? own : box(id, {});
  }

  /// The common box of bounds or clips, if it is smaller than the object's own and replaces it.
  std::optional<Bounds3> cut(const Bounds3& own, const std::vector<ObjectId>& cutters,
                             const Transform& space) {
    Bounds3 common{dvec3(-no_hit_depth), dvec3(no_hit_depth)};
    for (const ObjectId id : cutters) {
      if (!scene_.objects[id].inverse) common = common.intersection(box(id, space));
    }
    if (cutters.empty() || common.empty() || !(volume(common) < volume(own))) return std::nullopt;
    return stored(common);
  }

  const scene::Scene& scene_;
};

}  // namespace

Bounds3 extent_of(const scene::Scene& scene, scene::ObjectId object, const Transform& around) {
  return Measure(scene).box(object, around);
}

std::optional<Bounds3> bounding_box_of(const scene::Scene& scene, scene::ObjectId object,
                                       const Transform& around) {
  return Measure(scene).bounding_box(object, around);
}

}  // namespace durer::tracer

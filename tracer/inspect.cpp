#include "tracer/inspect.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer {
namespace {

using scene::NodeKind;
using scene::Object;
using scene::ObjectId;
using scene::Scene;

/// A scene that holds one object and what hangs below it.
class Excerpt {
 public:
  explicit Excerpt(const Scene& from) : from_(from) {
    out.origins = {scene::Origin{}};
    out.textures.emplace_back();  // geometry wants every surface to have some texture
    out.lights = from.lights;
  }

  ObjectId add(ObjectId id) {
    if (const auto known = ids_.find(id); known != ids_.end()) return known->second;
    Object copy = from_.objects[id];
    for (ObjectId& child : copy.children) child = add(child);
    for (ObjectId& clip : copy.clips) clip = add(clip);
    for (ObjectId& bound : copy.bounds) bound = add(bound);
    copy.texture = {};
    copy.interior_texture = {};
    copy.interior = scene::none;
    copy.origin = 0;
    out.objects.push_back(std::move(copy));
    return ids_[id] = static_cast<ObjectId>(out.objects.size() - 1);
  }

  Scene out;

 private:
  const Scene& from_;
  std::unordered_map<ObjectId, ObjectId> ids_;
};

bool any_patch(const Scene& scene, ObjectId id) {
  const Object& o = scene.objects[id];
  if (o.kind == NodeKind::primitive) return primitive_types()[o.type]->is_patch;
  if (o.kind == NodeKind::light) return true;
  for (const ObjectId child : o.children) {
    if (any_patch(scene, child)) return true;
  }
  return false;
}

/// The language's boxes (objects §7): those of CSG are transformed as boxes, so they loosen.
Bounds3 box_of(const Scene& scene, ObjectId id, const Transform& outer) {
  const Object& o = scene.objects[id];
  Bounds3 box;
  if (o.kind == NodeKind::primitive) {
    const PrimitiveType& type = *primitive_types()[o.type];
    TypeStores stores = type.make_stores();
    const auto ref = type.place(stores, o.args, o.transform.then(outer), false);
    if (ref) box = ref->store->surface_bounds(ref->shape);
  } else if (o.kind == NodeKind::union_ || o.kind == NodeKind::merge) {
    for (const ObjectId child : o.children) box.add(box_of(scene, child, {}));
    box = box.transformed(o.transform.then(outer).forward);
  } else if (o.kind == NodeKind::intersection || o.kind == NodeKind::difference) {
    box = Bounds3::everything();
    for (std::size_t i = 0; i < o.children.size(); ++i) {
      const Object& child = scene.objects[o.children[i]];
      const bool inverted = child.inverse != (o.kind == NodeKind::difference && i > 0);
      if (!inverted) box = box.intersection(box_of(scene, o.children[i], {}));
    }
    box = box.transformed(o.transform.then(outer).forward);
  } else {
    return Bounds3::everything();
  }
  const auto cut = [&](const std::vector<ObjectId>& list, const Transform& moved) {
    Bounds3 limit = Bounds3::everything();
    for (const ObjectId c : list) {
      if (!scene.objects[c].inverse) limit = limit.intersection(box_of(scene, c, moved.then(outer)));
    }
    const auto volume = [](const Bounds3& b) {
      const dvec3 e = b.hi - b.lo;
      return e.x * e.y * e.z;
    };
    if (!list.empty() && volume(limit) < volume(box)) box = limit;
  };
  cut(o.bounds, o.bound_transform);
  cut(o.clips, o.clip_transform);
  return box;
}

double single(double v) { return static_cast<double>(static_cast<float>(v)); }

}  // namespace

Inspector::Probe& Inspector::probe(const Scene& scene, ObjectId id) {
  const auto [it, fresh] = probes_.try_emplace(id);
  Probe& p = it->second;
  if (!fresh) return p;
  Excerpt excerpt(scene);
  const ObjectId root = excerpt.add(id);
  excerpt.out.roots.push_back({root, 0});
  const SourceMap sources;
  Diagnostics silent(sources);
  if (auto geometry = Geometry::build(excerpt.out, silent)) {
    p.geometry = std::make_unique<Geometry>(std::move(*geometry));
    p.scratch = p.geometry->make_scratch();
  }
  p.patch = any_patch(scene, id);
  return p;
}

std::optional<std::string> Inspector::unsupported(const Scene& scene, ObjectId id) {
  const Object& o = scene.objects[id];
  if (!o.unsupported.empty()) return o.unsupported;
  for (const auto* list : {&o.children, &o.clips, &o.bounds}) {
    for (const ObjectId child : *list) {
      if (auto feature = unsupported(scene, child)) return feature;
    }
  }
  return std::nullopt;
}

std::optional<scene::ObjectQueries::Trace> Inspector::trace(const Scene& scene, ObjectId id,
                                                            dvec3 origin, dvec3 direction) {
  Probe& p = probe(scene, id);
  const double length = glm::length(direction);
  if (!p.geometry || !(length > 0)) return std::nullopt;
  Hit hit;
  const Ray ray{origin, direction / length};
  if (!p.geometry->closest(ray, t_min, no_hit_depth, RayKind::image, hit, *p.scratch)) {
    return std::nullopt;
  }
  return Trace{hit.p, hit.n};
}

std::optional<bool> Inspector::inside(const Scene& scene, ObjectId id, dvec3 point) {
  Probe& p = probe(scene, id);
  if (p.patch) return std::nullopt;
  if (!p.geometry) return false;
  p.bodies.clear();
  p.geometry->containing(point, p.bodies, *p.scratch);
  return !p.bodies.empty();
}

Bounds3 Inspector::extent(const Scene& scene, ObjectId id) {
  Bounds3 box = box_of(scene, id, {});
  if (box.empty()) return {dvec3(0.0), dvec3(0.0)};
  for (int i = 0; i < 3; ++i) {
    // Stored as a corner and an edge, both in single precision.
    const double lo = single(std::max(box.lo[i], -unbounded));
    const double edge = single(std::min(box.hi[i], unbounded) - lo);
    box.lo[i] = lo;
    box.hi[i] = lo + edge;
  }
  return box;
}

}  // namespace durer::tracer

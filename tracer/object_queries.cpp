#include "tracer/object_queries.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "tracer/extent.h"
#include "tracer/geometry.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer {
namespace {

using scene::NodeKind;
using scene::Object;
using scene::ObjectId;

/// True if `found` holds for the object or for any object in it; clips and bounds take part if
/// `cutters` is set.
template <typename Found>
bool any_below(const scene::Scene& scene, ObjectId id, bool cutters, const Found& found) {
  const Object& o = scene.objects[id];
  const auto below = [&](ObjectId child) { return any_below(scene, child, cutters, found); };
  return found(o) || std::any_of(o.children.begin(), o.children.end(), below) ||
         (cutters && (std::any_of(o.extras->clips.begin(), o.extras->clips.end(), below) ||
                      std::any_of(o.extras->bounds.begin(), o.extras->bounds.end(), below)));
}

bool is_patch(const Object& o) {
  if (o.extras->mesh != nullptr) return !o.extras->mesh->has_inside();
  return (o.kind == NodeKind::light && o.children.empty()) ||
         (o.kind == NodeKind::primitive && primitive_types()[o.type]->is_patch);
}

class Queries final : public scene::ObjectQueries {
 public:
  std::optional<Trace> trace(const scene::Scene& scene, ObjectId id, dvec3 origin,
                             dvec3 direction) override {
    Subject* subject = find(scene, id);
    const double length = glm::length(direction);
    if (subject == nullptr || !(length > 0)) return std::nullopt;
    Hit hit;
    if (!subject->geometry.closest({origin, direction / length}, t_min, no_hit_depth,
                                   RayKind::image, hit, *subject->scratch)) {
      return std::nullopt;
    }
    return Trace{hit.p, hit.n};
  }

  std::optional<bool> inside(const scene::Scene& scene, ObjectId id, dvec3 point) override {
    if (any_below(scene, id, false, is_patch)) return std::nullopt;
    Subject* subject = find(scene, id);
    if (subject == nullptr) return std::nullopt;
    interiors_.clear();
    subject->geometry.containing(point, interiors_, *subject->scratch);
    return !interiors_.empty();
  }

  Bounds3 extent(const scene::Scene& scene, ObjectId id) override { return extent_of(scene, id); }

  std::optional<std::string> unsupported(const scene::Scene& scene, ObjectId id) override {
    std::optional<std::string> name;
    any_below(scene, id, true, [&](const Object& o) {
      if (o.kind != NodeKind::unsupported && o.extras->unsupported.empty()) return false;
      name = o.extras->unsupported.empty() ? "this object" : o.extras->unsupported;
      return true;
    });
    return name;
  }

 private:
  struct Subject {
    Geometry geometry;
    GeometryScratchPtr scratch;
  };

  /// Null if the object cannot be asked; `unsupported` has said why.
  Subject* find(const scene::Scene& scene, ObjectId id) {
    if (const auto known = subjects_.find(id); known != subjects_.end()) return &known->second;
    const SourceMap nowhere;
    Diagnostics ignored(nowhere);
    auto geometry = Geometry::build_object(scene, id, ignored);
    if (!geometry) return nullptr;
    auto scratch = geometry->make_scratch();
    return &subjects_.try_emplace(id, Subject{std::move(*geometry), std::move(scratch)})
                .first->second;
  }

  std::unordered_map<ObjectId, Subject> subjects_;
  std::vector<std::uint32_t> interiors_;
};

}  // namespace

std::unique_ptr<scene::ObjectQueries> make_object_queries() { return std::make_unique<Queries>(); }

}  // namespace durer::tracer

// Small scenes built by hand, as the interpreter would build them.
#pragma once

#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/source.h"
#include "scene/scene.h"
#include "tests/support/catch.h"
#include "tracer/geometry.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer::test {

inline std::uint32_t type_named(std::string_view name) {
  const auto infos = primitive_infos();
  for (std::uint32_t i = 0; i < infos.size(); ++i) {
    if (infos[i]->name == name) return i;
  }
  throw std::runtime_error("no primitive of this name");
}

inline scene::Object primitive(std::string_view name, std::vector<double> args,
                               const Transform& transform = {}) {
  scene::Object o;
  o.type = type_named(name);
  o.args = std::move(args);
  o.transform = transform;
  return o;
}

/// Primitives whose operands are numbers; meshes and functions have tests of their own.
inline std::vector<const PrimitiveType*> types_with_samples() {
  std::vector<const PrimitiveType*> types;
  for (const PrimitiveType* type : primitive_types()) {
    if (type->place_mesh == nullptr && type->place_extras == nullptr) types.push_back(type);
  }
  return types;
}

/// A scene under construction. Objects get the texture 0 unless they have one.
struct SceneBuilder {
  scene::Scene scene;

  SceneBuilder() { scene.textures.resize(1); }
  scene::ObjectId add(scene::Object o) {
    scene.objects.push_back(std::move(o));
    return static_cast<scene::ObjectId>(scene.objects.size() - 1);
  }
  scene::ObjectId csg(scene::NodeKind kind, std::vector<scene::ObjectId> children) {
    scene::Object o;
    o.kind = kind;
    o.children = std::move(children);
    return add(std::move(o));
  }
  void show(scene::ObjectId id) { scene.roots.push_back({id, 0}); }
  void show(scene::Object o) { show(add(std::move(o))); }
  [[nodiscard]] Geometry build(Hierarchy hierarchy = Hierarchy::embree) const {
    const SourceMap sources;
    Diagnostics diagnostics(sources);
    auto geometry = Geometry::build(scene, diagnostics, hierarchy);
    REQUIRE(geometry.has_value());
    return std::move(*geometry);
  }
};

inline Geometry only(scene::Object o) {
  SceneBuilder b;
  b.show(std::move(o));
  return b.build();
}

using Random = std::mt19937_64;
inline double uniform(Random& random, double lo, double hi) {
  return std::uniform_real_distribution<double>(lo, hi)(random);
}
inline dvec3 point_in_cube(Random& random, double half) {
  const double x = uniform(random, -half, half);
  const double y = uniform(random, -half, half);
  return {x, y, uniform(random, -half, half)};
}
inline dvec3 direction(Random& random) {
  for (;;) {
    const dvec3 v = point_in_cube(random, 1);
    const double l2 = v.x * v.x + v.y * v.y + v.z * v.z;
    if (l2 > 0.01 && l2 < 1) return v / std::sqrt(l2);
  }
}

}  // namespace durer::tracer::test

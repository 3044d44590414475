#include "tracer/sharing.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer {
namespace {

using scene::NodeKind;
using scene::Object;
using scene::ObjectId;

bool is_mirror(const Affine& m) { return glm::dot(m.x, glm::cross(m.y, m.z)) < 0; }

bool keeps_bumps(const scene::Normal& n) {
  return n.no_bump_scale ||
         std::any_of(n.children.begin(), n.children.end(),
                     [](const scene::Normal& child) { return keeps_bumps(child); });
}

}  // namespace

Sharing::Sharing(const scene::Scene& scene, const SharingLimits& limits) {
  collect(scene);
  choose(scene, limits);
}

bool Sharing::shares(const Object& object, const Transform& to_outer) const {
  const Contents* contents = contents_of(object);
  return contents != nullptr && contents->shared &&
         (contents->mirrors || !is_mirror(to_outer.forward));
}

const Sharing::Contents* Sharing::contents_of(const Object& object) const {
  if (object.children.empty()) return nullptr;
  const auto at = contents_.find(object.children.identity());
  return at == contents_.end() ? nullptr : &at->second;
}

// Bumps whose depth does not follow their size tell how much they were scaled.
bool Sharing::keeps_bumps(const scene::Scene& scene, scene::TextureId id) const {
  if (id == scene::none) return false;
  const scene::Texture& t = scene.textures[id];
  return t.no_bump_scale ||
         std::any_of(t.layers.begin(), t.layers.end(),
                     [](const scene::Layer& l) { return tracer::keeps_bumps(*l.normal); }) ||
         std::any_of(t.entries.begin(), t.entries.end(),
                     [&](const scene::TextureEntry& e) { return keeps_bumps(scene, e.texture); });
}

Sharing::Weight Sharing::weigh(const scene::Scene& scene, const Object& object) {
  Weight w;
  const scene::ObjectExtras& extras = *object.extras;
  // Lamps are few, and who lights what depends on the groups around them.
  const bool lamps = object.kind == NodeKind::light || object.kind == NodeKind::light_group;
  // Cut surfaces ask what is around them, which has its own place in the scene.
  if (lamps || object.cutaway_textures || object.kind == NodeKind::unsupported ||
      !extras.unsupported.empty() ||
      keeps_bumps(scene, object.texture.texture) ||
      keeps_bumps(scene, extras.interior_texture.texture)) {
    w.movable = false;
  }
  if (object.kind == NodeKind::primitive) {
    const PrimitiveType& type = *primitive_types()[object.type];
    w.leaves = 1;
    // The sides of these depend on the order of their points, as seen in the world.
    w.mirrors = !type.is_patch && !type.sides_by_order && extras.mesh == nullptr;
    // The box that dropped bounds leave behind lies along the world's axes (flatten.cpp), and
    // the direction in which faces are counted is one of the world.
    if (!extras.bounds.empty() && !type.keeps_bounds) w.movable = false;
    if (extras.mesh != nullptr && extras.mesh->has_inside()) w.movable = false;
  } else if (const Contents* below = contents_of(object)) {
    w.leaves = below->leaves;
    w.movable = w.movable && below->movable;
    w.mirrors = below->mirrors;
  }
  for (const auto* cutters : {&extras.clips, &extras.bounds}) {
    for (const ObjectId id : *cutters) {
      const Weight cutter = weigh(scene, scene.objects[id]);
      w.leaves += cutter.leaves;
      w.movable = w.movable && cutter.movable;
      w.mirrors = w.mirrors && cutter.mirrors;
    }
  }
  return w;
}

// Children come before those who have them, so that one pass sees everything below known.
void Sharing::collect(const scene::Scene& scene) {
  for (ObjectId id = 0; id < scene.objects.size(); ++id) {
    const Object& object = scene.objects[id];
    if (object.children.empty() || contents_of(object) != nullptr) continue;
    Contents all;
    all.first_owner = id;
    for (const ObjectId child : object.children) {
      const Weight w = weigh(scene, scene.objects[child]);
      all.leaves += w.leaves;
      all.movable = all.movable && w.movable;
      all.mirrors = all.mirrors && w.mirrors;
    }
    contents_.emplace(object.children.identity(), all);
  }
}

// From the top down: how often something is placed depends on whether what it is part of is kept
// once. All owners of a list come after its children, and its first owner is the last one met.
void Sharing::choose(const scene::Scene& scene, const SharingLimits& limits) {
  if (contents_.empty()) return;
  std::vector<float> placed(scene.objects.size(), 0.0F);
  for (const scene::Root& root : scene.roots) placed[root.object] += 1;
  for (auto id = static_cast<ObjectId>(scene.objects.size()); id-- > 0;) {
    const Object& object = scene.objects[id];
    if (object.children.empty()) continue;
    Contents& contents = contents_.find(object.children.identity())->second;
    contents.placed += placed[id];
    if (contents.first_owner != id) continue;
    contents.shared = contents.movable && contents.leaves >= limits.leaves &&
                      (contents.placed - 1) * contents.leaves >= limits.saved;
    const auto times = static_cast<float>(contents.shared ? 1 : contents.placed);
    for (const ObjectId child : object.children) placed[child] += times;
  }
}

}  // namespace durer::tracer

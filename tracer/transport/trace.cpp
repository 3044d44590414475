#include "tracer/transport/trace.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace durer::tracer {

Scratch::Scratch(const CompiledScene& scene)
    : geometry(scene.geometry.make_scratch()), lamps(scene.lights.size()) {
  reflections.reserve(64);
}

Tracer::Tracer(const CompiledScene& scene, Scratch& scratch, bool alpha)
    : scene_(&scene),
      scratch_(&scratch),
      max_level_(std::clamp(scene.scene->settings.max_trace_level, 1, 256)),
      adc_(scene.scene->settings.adc_bailout),
      alpha_(alpha),
      legacy_opacity_(scene.scene->settings.effective_version < 370),
      translucent_shadows_(scene.geometry.has_translucent_shadows()) {}

// Transmitted rays are followed in the loop rather than by recursion: straight ones do not count as
// a level, so that a ray may pass any number of them.
Radiance Tracer::trace(Path path) {
  vec3 sum(0.0F);
  vec3 through(1.0F);
  float transmittance = 1;
  bool straight = false;
  for (;;) {
    if (path.level >= max_level_ || path.weight < adc_) return {sum, 0};
    const RayKind kind = path.reflected ? RayKind::reflection : RayKind::image;
    Hit hit;
    ++scratch_->rays;
    if (!scene_->geometry.closest(path.ray, t_min, no_hit_depth, kind, hit, *scratch_->geometry)) {
      const Sky::Seen s = scene_->sky.at(path.ray.d, path.reflected || !alpha_);
      return {sum + through * s.colour, transmittance * s.transmittance};
    }
    if (!straight) ++path.level;
    const Step step = surface(look(hit, path.ray.d), path);
    sum += through * step.colour;
    transmittance *= step.transmittance;
    if (!step.continues) return {sum, transmittance};
    through *= step.through;
    straight = step.straight;
  }
}

Tracer::View Tracer::look(const Hit& hit, dvec3 d) const {
  const Leaf& leaf = scene_->geometry.leaves()[hit.leaf];
  const SurfaceProgram& s = scene_->surfaces[leaf.surface];
  const bool from_inside = glm::dot(hit.n, d) > 0;
  View view;
  view.p = hit.p;
  view.d = d;
  view.g = from_inside ? -hit.n : hit.n;
  view.texture = &scene_->textures.program(from_inside ? s.inside : s.outside);
  view.interior = leaf.interior;
  view.double_illuminate = s.double_illuminate;
  view.depth = hit.t;
  return view;
}

}  // namespace durer::tracer

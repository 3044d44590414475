#include "tracer/transport/look.h"
#include "tracer/transport/plain_lanes.h"
#include "tracer/transport/texture_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace durer::tracer {

Scratch::Scratch(const CompiledScene& scene)
    : geometry(scene.geometry.make_scratch()), lamps(scene.lights.size()) {
  reflections.reserve(64);
  for (const Geometry& g : scene.projectors) projectors.push_back(g.make_scratch());
  found.resize(Tracer::most_together);
  found_layers.resize(FoundSurface::most_layers);
  meeting.resize(Tracer::most_together);
}
Scratch::~Scratch() = default;

Tracer::Tracer(const CompiledScene& scene, Scratch& scratch, bool alpha)
    : scene_(&scene),
      scratch_(&scratch),
      leaves_(scene.geometry.leaves()),
      lamp_sets_(scene.geometry.lamp_sets()),
      alpha_(alpha),
      legacy_opacity_(scene.scene->settings.effective_version < 370),
      translucent_shadows_(scene.geometry.has_translucent_shadows()),
      air_(scene.quality.atmosphere && !scene.atmosphere.empty()),
      in_air_(air_ || !scene.media.empty()),
      together_(!scene.radiosity),
      plain_(scene.quality.lights && !scene.radiosity && scene.scene->settings.adc_bailout >= 0),
      opaque_shadows_(scene.quality.shadows && !translucent_shadows_ && !dims()),
      quality_(scene.quality),
      plain_lanes_(&plain_lanes().back()) {
  const scene::Settings& settings = scene.scene->settings;
  if (const Sky::Seen* s = scene.sky.plain(!alpha)) {
    plain_sky_ = {vec3(0.0F) + s->colour, s->transmittance};
  }
  limits_.fill({std::clamp(settings.max_trace_level, 1, 256), settings.adc_bailout});
  if (!scene.radiosity) return;
  const RadiosityProgram& r = *scene.radiosity;
  gathers_air_ = r.settings.media;
  for (std::size_t i = 0; i < r.bounces.size(); ++i) {
    limits_[i + 1] = {r.bounces[i].max_level, static_cast<float>(r.settings.adc_bailout)};
  }
}

// Transmitted rays are followed in the loop rather than by recursion: straight ones do not count as
// a level, so that a ray may pass any number of them. Afterwards `path` is where the light came
// from.
Radiance Tracer::follow(Path& path, bool straight, Along& along) {
  for (;;) {
    if (!is_worth_following(path)) return {along.sum, 0};
    Hit hit;
    ++scratch_->rays;
    const bool met = scene_->geometry.closest(path.ray, t_min, path.reach, path.kind(), hit,
                                              *scratch_->geometry);
    if (in_air_) pass_air(path, met ? &hit : nullptr, along);
    if (!met) {
      const Sky::Seen s = scene_->sky.at(path.ray.d, path.reflected || path.bounce > 0 || !alpha_);
      return along.ends_with({s.colour, s.transmittance});
    }
    if (FirstHit* first = std::exchange(path.first, nullptr); first != nullptr) {
      first->distance = hit.t;
      first->importance = scene_->geometry.leaves()[hit.leaf].importance;
      if (first->importance < first->least_importance) return {};
    }
    if (!straight) ++path.level;
    Look seen = look(hit, path.ray.d);
    seen.view.gathering = path.bounce > 0;
    if (is_mixed(seen)) return along.ends_with(mixed(seen, hit, path));
    const Step step = surface(seen.view, path);
    along.add(step);
    if (!step.continues) return {along.sum, along.transmittance};
    along.through *= step.through;
    straight = step.straight;
  }
}

// What lies between the path's origin and a `hit`, or everything ahead.
void Tracer::pass_air(const Path& path, const Hit* hit, Along& along) {
  if ((path.bounce > 0 && !gathers_air_) || !in_the_open(path.inside)) return;
  const Veil air = veil(path, hit != nullptr ? hit->t : no_hit_depth, hit);
  along.sum += along.through * air.glow;
  along.through *= air.through;
  along.transmittance *= air.transmittance;
}

bool Tracer::is_patterned(View& view) const {
  narrow(view);
  return view.texture->patterned();
}
Radiance Tracer::mixed(const Look& look, const Hit& hit, const Path& path) {
  return look.blend.count > 1 ? blend(look, hit, path) : shown(look.view, path);
}

// Every texture is followed on its own, with its reflections and what lies behind (objects §4).
Radiance Tracer::blend(const Look& look, const Hit& hit, const Path& path) {
  Radiance sum;
  for (std::uint32_t i = 0; i < look.blend.count; ++i) {
    const TextureBlend::Part& part = look.blend.parts[i];
    if (part.weight < limits(path).adc) continue;
    View view = look.view;
    dress(view, look, hit, part.texture);
    const Radiance r = shown(view, path);
    sum.colour += part.weight * r.colour;
    sum.transmittance += part.weight * r.transmittance;
  }
  return sum;
}

Tracer::Look Tracer::look(const Hit& hit, const dvec3& d) const {
  Look found;
  look(hit, d, found);
  return found;
}

/// Of surfaces that are not bare, or stand in shared contents: their texture, and where it lies.
void Tracer::look_closer(const Hit& hit, bool from_inside, Look& found) const {
  const SurfaceProgram& s = *found.surface;
  View& view = found.view;
  view.texture = &scene_->textures.program(texture_at(hit, s, from_inside, view.places));
  // An interior texture hides those of single parts.
  if (s.has_parts && !(from_inside && s.inside != s.outside)) {
    found.blend = Geometry::part_textures(hit);
  }
  if (s.cutaway) found.blend = scene_->geometry.cutaway_textures(hit, from_inside);
  dress(view, found, hit, found.blend.count == 1 ? found.blend.parts[0].texture : scene::none);
}

/// Which texture of a surface is seen, and the space it lies in: that of the outermost `places`
/// placements of the hit.
ProgramId Tracer::texture_at(const Hit& hit, const SurfaceProgram& surface, bool from_inside,
                             std::uint32_t& places) const {
  places = hit.depth;
  ProgramId id = from_inside ? surface.inside : surface.outside;
  while (id == program_of_placement) {
    const Placement& placement = scene_->geometry.placements()[hit.path[--places]];
    const SurfaceProgram& outer = scene_->surfaces[placement.surface];
    id = from_inside ? outer.inside : outer.outside;
  }
  return id;
}

/// Puts a texture of a part on, if there is one, and finds the point where to look it up.
void Tracer::dress(View& view, const Look& look, const Hit& hit, std::uint32_t texture) const {
  const SurfaceProgram& s = *look.surface;
  if (texture != scene::none) {
    view.texture =
        &scene_->textures.program(s.cutaway ? scene_->surfaces[texture].outside
                                            : scene_->part_textures[s.first_part + texture]);
    view.places = hit.depth;
  }
  view.q = hit.at(view.places);
  for (std::uint32_t i = 0; i < view.places; ++i) {
    view.spaces[i] = &scene_->geometry.placements()[hit.path[i]].to_outer;
  }
  if (!s.uv_mapping && !view.texture->uses_uv) return;
  const dvec2 uv = Geometry::uv(hit);
  view.uv = {uv.x, uv.y, 0};
  if (s.uv_mapping) view.q = view.uv;
}

}  // namespace durer::tracer

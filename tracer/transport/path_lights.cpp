// Light that paths look for: that of lamps, and of surfaces that glow.
#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/transport/path_tracer.h"

namespace durer::tracer {

// One lamp, drawn by what it would add if nothing were in between.
vec3 PathTracer::lamp_light(const View& view, const Containment& inside) {
  tracer_.find_lamps(view);
  if (scratch_->lit.empty()) return vec3(0.0F);
  Draw draw{random_->next()};
  const dvec2 place = random_->next2();
  std::uint32_t chosen = 0;
  LampView seen;
  for (const std::uint32_t i : scratch_->lit) {
    const Light& light = scene_->lights[i];
    const LampView lamp =
        view_lamp(light, scratch_->lamps[i].in, view.p, place, Tracer::spreads(light, view));
    const vec3 most = lit(view, light, {lamp.shading, lamp.shading.colour, true}, false);
    if (!draw.take(std::abs(double{grey(most)}))) continue;
    chosen = i;
    seen = lamp;
  }
  if (draw.own == 0) return vec3(0.0F);
  const Light& light = scene_->lights[chosen];
  const vec3 arriving = tracer_.shadowed(light, seen.shadow, view.p, inside, {.as_point = true});
  if (dark(arriving)) return vec3(0.0F);
  return draw.factor() * lit(view, light, {seen.shading, arriving, true}, true);
}

// What all layers throw back of a lamp.
vec3 PathTracer::lit(const View& view, const Light& light, const LampAtPoint& lamp,
                     bool grain) const {
  const Tracer::Beam beam{lamp.in.l, lamp.shadowed, !light.shadowless};
  vec3 sum(0.0F);
  for (const Coat& coat : coats_) {
    const bool hidden = tracer_.is_behind(view, coat.layer, lamp.in.l);
    if (hidden && coat.layer.finish->diffuse_back == 0) continue;
    sum += coat.through * tracer_.shade(view, coat.layer, beam, hidden, grain);
  }
  return sum;
}

// A lamp of some extent is seen at a random place of all of it, not of its grid. Unless it is to
// light by its whole area, only shadows know.
PathTracer::LampView PathTracer::view_lamp(const Light& light, const Incidence& in, dvec3 p,
                                           dvec2 place, bool spread) {
  if (!light.has_area) return {in, in};
  const dvec3 offset = area_offset(light.area, place.x * (light.area.n1 - 1),
                                   place.y * (light.area.n2 - 1), in.l);
  Incidence part = direction_to(light, offset, p);
  part.colour = in.colour;
  if (!spread) return {in, part};
  part.colour = light.colour * static_cast<float>(attenuation(light, part, p));
  return {part, part};
}

Aim PathTracer::aim_for_light(dvec3 p) {
  if (!rules_.next_event || scene_->emitters.empty()) return {};
  const double pick = random_->next();
  return scene_->emitters.aim(p, pick, random_->next2());
}

// Of light that comes straight from what glows; the rest is met by chance.
vec3 PathTracer::emitter_light(const View& view, const Containment& inside) {
  const Aim aim = aim_for_light(view.p);
  if (!(aim.density > 0)) return vec3(0.0F);
  const vec3 share = scattered(view, aim.d);
  if (share == vec3(0.0F)) return vec3(0.0F);
  const auto all = static_cast<float>(aim.density + density(view, aim.d));
  return share * light_along({view.p, aim.d}, behind(view, inside, aim.d)) / all;
}

// What the first surface along a ray sends out by itself, or the sky.
vec3 PathTracer::light_along(const Ray& ray, const Containment& inside) {
  Hit hit;
  ++scratch_->rays;
  const bool met = scene_->geometry.closest(ray, t_min, no_hit_depth, RayKind::gathering, hit,
                                            *scratch_->geometry);
  const vec3 light = met ? glow(see(hit, ray.d), inside) : scene_->sky.at(ray.d, true).colour;
  if (light == vec3(0.0F)) return light;
  return light * kept(ray, met ? hit.t : no_hit_depth, inside, met);
}

}  // namespace durer::tracer

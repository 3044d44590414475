// What stands between a point and a lamp (shading §6.4-6.6).
#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/transport/lamps.h"
#include "tracer/transport/texture_parts.h"

namespace durer::tracer {

vec3 Tracer::shadowed(const Light& light, const Incidence& in, dvec3 p, const Containment& inside,
                      Receiver receiver) {
  if (!quality_.shadows || (light.shadowless && light.projector == scene::none)) return in.colour;
  const bool collects = receiver.collects && has_caustics();
  if (!light.has_area || receiver.as_point) return point_shadow(light, in, p, inside, collects);
  return area_shadow(light, in, p, inside, collects);
}

// Where nothing is translucent any blocker will do; otherwise the nearest ones are asked in turn,
// which costs a lit point no more.
vec3 Tracer::point_shadow(const Light& light, const Incidence& in, dvec3 p,
                          const Containment& inside, bool collects) {
  double way = in.distance;
  if (light.projector != scene::none) {
    way = projected(light, in, p);
    if (way < 0) return vec3(0.0F);
    if (light.shadowless) return in.colour;
  }
  if (way <= 2 * t_shadow) return in.colour;
  const bool dimmed = light.dimmed_by_air && dims();
  if (translucent_shadows_ || dimmed) {
    return walk_shadow(light, in, p, way, inside, collects);
  }
  return opaque_shadow(in, p, way);
}

// How far away the object is through which the lamp shines; negative if not in between.
double Tracer::projected(const Light& light, const Incidence& in, dvec3 p) {
  Hit hit;
  const bool met = scene_->projectors[light.projector].closest(
      {p, in.l}, t_min, in.distance, RayKind::image, hit, *scratch_->projectors[light.projector]);
  return met ? hit.t : -1;
}

// From one surface to the next, up to `way`; surfaces nearer than t_shadow behind each other count
// as one.
vec3 Tracer::walk_shadow(const Light& light, const Incidence& in, dvec3 p, double way,
                         Containment inside, bool collects) {
  static const double beyond = std::nextafter(t_shadow, 1.0);
  const bool dimmed = light.dimmed_by_air && dims();
  const double unobstructed = in.distance - way;  // behind the object that the lamp shines through
  vec3 left = in.colour;
  Ray ray{p, in.l};
  Hit hit;
  for (;;) {
    ++scratch_->rays;
    const bool met = way > 2 * t_shadow &&
                     scene_->geometry.closest(ray, beyond, way - t_shadow, RayKind::shadow, hit,
                                              *scratch_->geometry);
    if (met && collects && leaves_to_photons(light, hit)) return vec3(0.0F);
    if (met) left *= shadow_factor(hit, in.l, inside);
    const double depth = met ? hit.t : way + unobstructed;
    if (met && !scene_->media.empty()) left *= light_through_bodies(ray, hit.t, inside);
    if (dimmed && depth > t_shadow && in_the_open(inside)) {
      if (air_) left *= scene_->atmosphere.fog_shadow(ray, depth);
      if (!scene_->air_media.empty()) left *= light_through_air(ray, depth, inside);
    }
    if (!met) return left;
    if (dark(left)) return vec3(0.0F);
    inside.toggle(hit.interior);
    ray.o = hit.p;
    way -= hit.t;
  }
}

// What a surface leaves of light that shines straight through it.
vec3 Tracer::shadow_factor(const Hit& hit, dvec3 l, const Containment& inside) const {
  const Look seen = look(hit, l);
  if (seen.blend.count <= 1) return shadow_factor(seen.view, inside);
  vec3 sum(0.0F);
  for (std::uint32_t i = 0; i < seen.blend.count; ++i) {
    const TextureBlend::Part& part = seen.blend.parts[i];
    if (part.weight < limits_[0].adc) continue;
    View view = seen.view;
    dress(view, seen, hit, part.texture);
    sum += part.weight * shadow_factor(view, inside);
  }
  return sum;
}

vec3 Tracer::shadow_factor(const View& view, const Containment& inside) const {
  if (view.texture->opaque) return vec3(0.0F);
  if (view.texture->patterned()) {
    vec3 sum(0.0F);
    for_parts(view, [&](const View& part, float weight) {
      sum += weight * shadow_factor(part, inside);
    });
    return sum;
  }
  const TextureStore& textures = scene_->textures;
  const Interior& body = scene_->interiors[view.interior];
  vec3 k(1.0F);
  SurfaceView seen{view.p, view.d, view.g, view.uv};
  for (std::uint32_t i = view.texture->first_layer; i < view.texture->end_layer; ++i) {
    const LayerProgram& layer = textures.layer(i);
    // Only caustics ask for bumps; without them, patterns too see the bare surface.
    const bool bumpy = layer.normal != scene::none && body.caustics != 0;
    const dvec3 n = bumpy ? bend(view, layer, seen) : view.g;
    k *= textures.pigments().at(layer.pigment, view.q, &seen).transmission();
    if (body.caustics != 0) {
      k *= static_cast<float>(1 + std::pow(std::abs(glm::dot(n, view.d)), body.caustics));
    }
  }
  if (body.fade_power > 0 && fades(body) && inside.contains(view.interior)) {
    k *= fade(body, view.depth);
  }
  return k;
}

}  // namespace durer::tracer

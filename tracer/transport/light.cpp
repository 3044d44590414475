// Light that lamps throw onto a layer, and what stands in its way (shading §4.4-4.7, §6.4-6.5).
#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/transport/texture_parts.h"

namespace durer::tracer {

float next_noise(std::uint32_t& state) {
  state = state * 1812433253U + 12345U;
  return static_cast<float>(state / 4294967295.0);
}

vec3 Tracer::illuminate(const View& view, const Path& path, const LayerPoint& layer,
                        bool first_lit) {
  vec3 sum(0.0F);
  for (std::size_t i = 0; i < scene_->lights.size(); ++i) {
    const Light& light = scene_->lights[i];
    LampAtPoint& lamp = scratch_->lamps[i];
    if (first_lit) lamp = {incidence(light, view.p), vec3(0.0F), false};
    if (dark(lamp.in.colour)) continue;
    const bool behind = glm::dot(layer.n, lamp.in.l) < epsilon && !view.double_illuminate;
    if (behind && layer.finish->diffuse_back == 0) continue;
    if (!lamp.shadow_known) {
      lamp.shadowed = shadowed(light, lamp.in, view.p, path.inside);
      lamp.shadow_known = true;
    }
    if (!dark(lamp.shadowed)) sum += shade(view, layer, light, lamp, behind);
  }
  return sum;
}

vec3 Tracer::shade(const View& view, const LayerPoint& layer, const Light& light,
                   const LampAtPoint& lamp, bool backside) {
  const Finish& f = *layer.finish;
  const dvec3 l = lamp.in.l;
  const double cosine = glm::dot(layer.n, l);
  vec3 sum(0.0F);
  const float k = backside ? f.diffuse_back : f.diffuse;
  if (k > 0) {
    const double c = std::abs(cosine);
    const double bright = f.brilliance == 1 ? c : std::pow(c, f.brilliance);
    float intensity = static_cast<float>(bright) * k * layer.opacity;
    if (f.crand > 0) intensity -= next_noise(scratch_->noise) * f.crand;
    sum = intensity * layer.pigment * lamp.shadowed;
  }
  if (f.highlights && !backside && !light.shadowless) {
    sum += highlight(f, view.d, layer.n, l, layer.pigment) * lamp.shadowed;
  }
  if (f.irid > 0) sum *= iridescence(f, cosine, glm::dot(layer.n, view.d));
  return sum;
}

// Where nothing is translucent any blocker will do; otherwise the nearest ones are asked in turn,
// which costs a lit point no more.
vec3 Tracer::shadowed(const Light& light, const Incidence& in, dvec3 p, const Containment& inside) {
  if (!quality_.shadows || light.shadowless || in.distance <= 2 * t_shadow) return in.colour;
  if (translucent_shadows_) return walk_shadow(in, p, inside);
  ++scratch_->rays;
  const bool blocked =
      scene_->geometry.occluded({p, in.l}, t_shadow, in.distance - t_shadow, *scratch_->geometry);
  return blocked ? vec3(0.0F) : in.colour;
}

// From one surface to the next; surfaces nearer than t_shadow behind each other count as one.
vec3 Tracer::walk_shadow(const Incidence& in, dvec3 p, Containment inside) {
  static const double beyond = std::nextafter(t_shadow, 1.0);
  vec3 light = in.colour;
  Ray ray{p, in.l};
  double left = in.distance;
  Hit hit;
  for (;;) {
    ++scratch_->rays;
    if (left <= 2 * t_shadow ||
        !scene_->geometry.closest(ray, beyond, left - t_shadow, RayKind::shadow, hit,
                                  *scratch_->geometry)) {
      return light;
    }
    light *= shadow_factor(hit, in.l, inside);
    if (dark(light)) return vec3(0.0F);
    inside.toggle(hit.interior);
    ray.o = hit.p;
    left -= hit.t;
  }
}

// What a surface leaves of light that shines straight through it.
vec3 Tracer::shadow_factor(const Hit& hit, dvec3 l, const Containment& inside) const {
  const Look seen = look(hit, l);
  if (seen.blend.count <= 1) return shadow_factor(seen.view, inside);
  vec3 sum(0.0F);
  for (std::uint32_t i = 0; i < seen.blend.count; ++i) {
    const TextureBlend::Part& part = seen.blend.parts[i];
    if (part.weight < adc_) continue;
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
  SurfaceView seen{view.p, view.d, view.g};
  for (std::uint32_t i = view.texture->first_layer; i < view.texture->end_layer; ++i) {
    const LayerProgram& layer = textures.layer(i);
    // Only caustics ask for bumps; without them, patterns too see the bare surface.
    const bool bumpy = layer.normal != scene::none && body.caustics != 0;
    const dvec3 n = bumpy ? bend(view, layer, seen) : view.g;
    k *= textures.pigments().at(layer.pigment, layer.by_uv ? view.uv : view.q, &seen).transmission();
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

// What one lamp does to a layer at a point (shading §4.4-4.7).
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "functions/simd/inline.h"
#include "tracer/random.h"
#include "tracer/transport/trace.h"

namespace durer::tracer {

// Inline, and by reference: nearly all lamps are asked from illuminate(), once for every layer.
DURER_INLINE vec3 Tracer::shade_from(const View& view, const LayerPoint& layer, const dvec3& l,
                                     const vec3& light, Facing facing) const {
  const Finish& f = *layer.finish;
  const double cosine = glm::dot(layer.n, l);
  vec3 sum(0.0F);
  const float k = facing.backside ? f.diffuse_back : f.diffuse;
  if (k > 0) {
    const double bright = f.brilliance.of(std::abs(cosine));
    float intensity = static_cast<float>(bright) * k * layer.opacity;
    if (facing.grain && f.crand > 0) intensity -= random_unit(scratch_->noise) * f.crand;
    sum = intensity * layer.pigment * light;
  }
  if (f.highlights && !view.gathering && !facing.backside && facing.highlights) {
    const dvec3 kept = l;  // `l` itself may stay in registers
    sum += highlight(f, view.d, layer.n, kept, layer.pigment) * light;
  }
  if (f.irid > 0) sum *= iridescence(f, view.p, cosine, glm::dot(layer.n, view.d));
  return sum;
}

/// What is left of a lamp's light in `way` world units where any caster of shadows stops all of it.
inline vec3 Tracer::opaque_shadow(const Incidence& in, const dvec3& p, double way) {
  if (way <= 2 * t_shadow) return in.colour;
  ++scratch_->rays;
  const bool blocked =
      scene_->geometry.occluded({p, in.l}, t_shadow, way - t_shadow, *scratch_->geometry);
  return blocked ? vec3(0.0F) : in.colour;
}

/// What arrives of a lamp's light at a point of a surface.
DURER_INLINE vec3 Tracer::arriving(const View& view, const Containment& inside, const Light& light,
                                   const Incidence& in) {
  if (opaque_shadows_ && light.plain) return opaque_shadow(in, view.p, in.distance);
  const Incidence kept = in;
  return shadowed(light, kept, view.p, inside, {view.gathering, view.collects});
}

}  // namespace durer::tracer

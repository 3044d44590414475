// Steps of the short way (plain.cpp), for one point and for several together.
#pragma once

#include "tracer/transport/lamps.h"

namespace durer::tracer {

inline const Finish& Tracer::finish_of_plain(const TextureProgram& texture) const {
  const TextureStore& textures = scene_->textures;
  return textures.finish(textures.layer(texture.first_layer));
}

/// Calls visit(lamp, incidence, hidden) if a lamp may light the layer, as far as nothing is in its
/// way; `hidden`: from behind.
template <typename Visit>
DURER_INLINE void Tracer::if_lit(std::uint32_t number, const View& view, const LayerPoint& layer,
                                 const Visit& visit) {
  if (!scene_->reaches[number].contains(view.p)) return;
  const Light& lamp = scene_->lights[number];
  const Incidence in = incidence(lamp, view.p);
  const bool spread = spreads(lamp, view);
  if (dark(spread ? lamp.colour : in.colour)) return;
  const bool hidden = is_behind(view, layer, in.l);
  if (hidden && !spread && layer.finish->diffuse_back == 0) return;
  visit(lamp, in, hidden);
}

/// Adds what arrives of that lamp's light.
DURER_INLINE void Tracer::add_light(const View& view, const Containment& inside,
                                    const LayerPoint& layer, const Light& lamp, const Incidence& in,
                                    bool hidden, vec3& lit) {
  if (spreads(lamp, view)) {
    lit += light_of_area(view, inside, layer, lamp, in);
    return;
  }
  const vec3 arrived = arriving(view, inside, lamp, in);
  if (dark(arrived)) return;
  lit += shade_from(view, layer, in.l, arrived, {hidden, !lamp.shadowless, true});
}

/// What the layer sends out, with the light that lamps throw on it.
inline void Tracer::add_glow(const Finish& finish, const vec3& pigment, const vec3& lit,
                             vec3& light) {
  const vec3 glow = pigment * finish.glow_pigment;
  light.x = glow.x + lit.x;
  light.y = glow.y + lit.y;
  light.z = glow.z + lit.z;
}

}  // namespace durer::tracer

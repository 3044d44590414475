// The short way for most surfaces: one opaque layer that glows and is lit by lamps, and neither
// mirrors nor spreads light below (TextureProgram::plain). Same terms in the same order as
// sum_layers(), with all that is 0 or 1 there left out.
#include "tracer/transport/lamps.h"
#include "tracer/transport/layers.h"

namespace durer::tracer {

vec3 Tracer::plain_light(const View& view, const Containment& inside) {
  const TextureStore& textures = scene_->textures;
  const LayerProgram& program = textures.layer(view.texture->first_layer);
  LayerPoint layer{&textures.finish(program), 1, view.g};
  if (view.known.empty()) {
    SurfaceView seen{view.p, view.d, view.g, view.uv};
    const LayerLook own = look_at(view, program, seen);
    layer.n = own.n;
    layer.pigment = own.colour.rgb;
  } else {
    layer.n = view.known.front().n;
    layer.pigment = view.known.front().colour.rgb;
  }
  vec3 light = layer.pigment * layer.finish->glow_pigment;
  if (!layer.finish->lit) return light;
  // Nobody else asks the lamps at this point: they are lit one by one, and forgotten.
  vec3 lit(0.0F);
  for (const std::uint32_t i : scene_->geometry.lamp_sets()[view.lamps]) {
    if (!scene_->reaches[i].contains(view.p)) continue;
    const Light& lamp = scene_->lights[i];
    LampAtPoint at_point{incidence(lamp, view.p)};
    if (spreads(lamp, view)) at_point.in.colour = lamp.colour;
    if (!dark(at_point.in.colour)) lit += light_from(view, inside, layer, lamp, at_point);
  }
  return light + lit;
}

}  // namespace durer::tracer

// The short way for most surfaces: one opaque layer that glows and is lit by lamps, and neither
// mirrors nor spreads light below (TextureProgram::plain). Same terms in the same order as
// sum_layers(), with all that is 0 or 1 there left out.
#include "tracer/transport/plain.h"
#include "tracer/transport/layers.h"

namespace durer::tracer {

void Tracer::plain_light(const View& view, const Containment& inside, vec3& light) {
  const Finish& finish = finish_of_plain(*view.texture);
  dvec3 n;
  Colour colour;
  const LayerLook own = view.known.empty() ? look_alone(view, n, colour) : view.known.front();
  const LayerPoint layer{&finish, 1, *own.n, own.colour->rgb};
  // Nobody else asks the lamps at this point: they are lit one by one, and forgotten.
  vec3 lit(0.0F);
  if (finish.lit) {
    for (const std::uint32_t i : lamp_sets_[view.lamps]) {
      if_lit(i, view, layer,
             [&](const Light& lamp, const Incidence& in, bool hidden)
                 DURER_LAMBDA_INLINE { add_light(view, inside, layer, lamp, in, hidden, lit); });
    }
  }
  add_glow(finish, layer.pigment, lit, light);
}

Tracer::LayerLook Tracer::look_alone(const View& view, dvec3& n, Colour& colour) const {
  SurfaceView seen{view.p, view.d, view.seen, view.uv};
  const LayerLook look = look_at(view, 0, seen, n, colour);
  if (view.frame_count > 0) scratch_->left_normal = seen.n;
  return look;
}

// A lamp whose whole area shines; its samples are weakened one by one.
vec3 Tracer::light_of_area(const View& view, const Containment& inside, const LayerPoint& layer,
                           const Light& light, const Incidence& centre) {
  LampAtPoint lamp{centre};
  lamp.in.colour = light.colour;
  lamp.shadowed = arriving(view, inside, light, lamp.in);
  return dark(lamp.shadowed) ? vec3(0.0F) : shade_by_area(view, layer, light, lamp);
}

}  // namespace durer::tracer

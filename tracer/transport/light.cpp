// Light that lamps throw onto a layer (shading §4.4-4.7).
#include <glm/geometric.hpp>
#include <new>

#include "tracer/transport/lamps.h"

namespace durer::tracer {

vec3 Tracer::illuminate(const View& view, const Path& path, const LayerPoint& layer,
                        bool first_lit) {
  if (first_lit) find_lamps(view);
  vec3 sum(0.0F);
  for (const std::uint32_t i : scratch_->lit) {
    const Light& light = scene_->lights[i];
    LampAtPoint& lamp = scratch_->lamps[i];
    const bool spread = spreads(light, view);
    const bool hidden = is_behind(view, layer, lamp.in.l);
    if (hidden && !spread && layer.finish->diffuse_back == 0) continue;
    if (!lamp.shadow_known) {
      lamp.shadowed = arriving(view, path.inside, light, lamp.in);
      lamp.shadow_known = true;
    }
    if (dark(lamp.shadowed)) continue;
    sum += spread ? shade_by_area(view, layer, light, lamp)
                  : shade_from(view, layer, lamp.in.l, lamp.shadowed,
                               {hidden, !light.shadowless, true});
  }
  return sum;
}

// The lamps whose light gets to the point, as far as nothing is in its way.
void Tracer::find_lamps(const View& view) {
  scratch_->lit.clear();
  for (const std::uint32_t i : lamp_sets_[view.lamps]) {
    if (!scene_->reaches[i].contains(view.p)) continue;
    const Light& light = scene_->lights[i];
    // Made in place: copying what was written just now in smaller pieces keeps a processor waiting.
    LampAtPoint& lamp = *::new (&scratch_->lamps[i]) LampAtPoint{incidence(light, view.p)};
    if (spreads(light, view)) lamp.in.colour = light.colour;  // its samples are weakened one by one
    if (dark(lamp.in.colour)) continue;
    scratch_->lit.push_back(i);
  }
}

// Every sample of the area shines with its share of the light that the shadows leave (shading §6.6).
vec3 Tracer::shade_by_area(const View& view, const LayerPoint& layer, const Light& light,
                           const LampAtPoint& lamp) {
  const scene::LightArea& area = light.area;
  const AreaGrid grid(area, lamp.in.l);
  const auto share = 1 / static_cast<float>(area.n1 * area.n2);
  vec3 sum(0.0F);
  for (int v = 0; v < area.n2; ++v) {
    for (int u = 0; u < area.n1; ++u) {
      LampAtPoint sample = lamp;
      sample.in = direction_to(light, grid.offset(area_place(grid, u, v)), view.p);
      if (sample.in.l == dvec3(0.0)) continue;
      const bool hidden = is_behind(view, layer, sample.in.l);
      if (hidden && layer.finish->diffuse_back == 0) continue;
      sample.shadowed *= share * static_cast<float>(tracer::attenuation(light, sample.in, view.p));
      sum += shade(view, layer, {sample.in.l, sample.shadowed, !light.shadowless}, hidden);
    }
  }
  return sum;
}

vec3 Tracer::shade(const View& view, const LayerPoint& layer, const Beam& beam, bool backside,
                   bool grain) const {
  return shade_from(view, layer, beam.l, beam.light, {backside, beam.highlights, grain});
}

}  // namespace durer::tracer

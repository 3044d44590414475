// The layers of a surface, from the outside in.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <new>

#include "functions/simd/inline.h"
#include "tracer/transport/trace.h"

namespace durer::tracer {

[[nodiscard]] inline bool is_one(double x) { return std::abs(x - 1) < epsilon; }

[[nodiscard]] inline bool nearly_equal(dvec3 a, dvec3 b) {
  const dvec3 e = glm::abs(a - b);
  return e.x < epsilon && e.y < epsilon && e.z < epsilon;
}

/// Layer `number` of a texture, which may be kept in `n` and `colour`. Afterwards `seen` has the
/// normal as patterns of the layer see it.
DURER_INLINE Tracer::LayerLook Tracer::look_at(const View& view, std::uint32_t number,
                                               SurfaceView& seen, dvec3& n, Colour& colour) const {
  if (number < view.known.size()) return view.known[number];
  const LayerProgram& layer = scene_->textures.layer(view.texture->first_layer + number);
  n = layer.normal == scene::none ? view.g : bend(view, layer, seen);
  ::new (&colour) Colour(scene_->textures.pigments().at(layer.pigment, view.q, &seen));
  return {&n, &colour};
}

/// Calls `visit(layer, sum)` for each layer while those before it let more than `least` through;
/// `sum` is what they have come to. The visitor may add to its colour, and returns what the layer
/// reflects, by colour.
template <typename Visit>
Tracer::LayerSum Tracer::walk_layers(const View& view, float least, const Visit& visit) const {
  const TextureStore& textures = scene_->textures;
  LayerSum sum;
  SurfaceView seen{view.p, view.d, view.seen, view.uv};
  const std::uint32_t first = view.texture->first_layer;
  for (std::uint32_t i = first; i < view.texture->end_layer && sum.sigma > least; ++i) {
    const LayerProgram& program = textures.layer(i);
    dvec3 kept_n;
    Colour kept;
    const LayerLook own = look_at(view, i - first, seen, kept_n, kept);
    const Colour& c = *own.colour;
    if (i == first) sum.top = *own.n;
    const LayerPoint layer{&textures.finish(program), opacity(c), *own.n, c.rgb};
    const vec3 rho = visit(layer, sum);
    sum.through *= c.transmission();
    if (layer.finish->conserve_energy) sum.through *= glm::min(vec3(1.0F), 1.0F - rho);
    sum.sigma = std::min(1.0F, std::abs(grey(sum.through)));
  }
  if (view.frame_count > 0) scratch_->left_normal = seen.n;
  return sum;
}

}  // namespace durer::tracer

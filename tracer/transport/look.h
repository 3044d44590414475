// From a hit to the surface that is seen there.
#pragma once

#include <glm/geometric.hpp>

#include "functions/simd/inline.h"
#include "tracer/transport/trace.h"

namespace durer::tracer {

/// Fills in `found`, which is new. `d`: direction of the ray.
DURER_INLINE void Tracer::look(const Hit& hit, const dvec3& d, Look& found) const {
  const SurfaceProgram& s = scene_->surfaces[leaves_[hit.leaf].surface];
  const bool from_inside = glm::dot(hit.n, d) > 0;
  found.surface = &s;
  View& view = found.view;
  view.p = hit.p;
  view.d = d;
  view.g = from_inside ? -hit.n : hit.n;
  view.seen = view.g;
  view.interior = hit.interior;
  view.lamps = s.lamps;
  view.double_illuminate = s.double_illuminate;
  view.collects = s.photons.collects();
  view.depth = hit.t;
  if (!s.bare || hit.depth > 0) return look_closer(hit, from_inside, found);
  view.texture = &scene_->textures.program(from_inside ? s.inside : s.outside);
  view.q = hit.p;
}

}  // namespace durer::tracer

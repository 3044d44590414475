#include "tracer/transport/texture_parts.h"

namespace durer::tracer {

/// Moves the point of `view` to where the textures of the choice see it; returns the value that
/// chooses among them.
double Tracer::choose(View& view, const TextureChoice& choice) const {
  if (choice.by_uv) {
    view.q = view.uv;
    return 0;
  }
  // A pattern that chooses textures sees the surface without bumps of its own.
  const SurfaceView seen{view.p, view.d, view.seen, view.uv};
  view.q = scene_->textures.warp(choice, view.q);
  view.frames[view.frame_count++] = &choice.frame;
  return PatternStore::value(choice.pattern, view.q, &seen);
}

/// Replaces patterned textures by what they show, as long as that is one texture alone.
void Tracer::narrow(View& view) const {
  const TextureStore& textures = scene_->textures;
  while (view.texture->patterned()) {
    const TextureChoice& choice = textures.choice(*view.texture);
    if (!choice.by_uv && choice.pattern.type->averages) return;
    View part = view;
    const auto found = find_neighbours(textures.entries(choice), choose(part, choice));
    if (!found.single()) return;
    part.texture = &textures.program(found.lower->texture);
    view = part;
  }
}

/// What a surface sends along a path, and all that lies behind it.
Radiance Tracer::shown(const View& view, const Path& path) {
  if (view.texture->patterned()) {
    // Each texture is lit, reflects and lets light through on its own (textures §11.3).
    Radiance sum;
    for_parts(view, [&](View& part, float weight) {
      const Radiance r = shown(part, path);
      part.seen = scratch_->left_normal;
      sum.colour += weight * r.colour;
      sum.transmittance += weight * r.transmittance;
    });
    return sum;
  }
  Path own = path;
  const Step step = surface(view, own);
  Radiance r{step.colour, step.transmittance};
  if (step.continues) {
    const Radiance behind = follow(own, step.straight);
    r.colour += step.through * behind.colour;
    r.transmittance *= behind.transmittance;
  }
  scratch_->left_normal = step.left;
  return r;
}

}  // namespace durer::tracer

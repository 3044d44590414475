// Which of the textures that a pattern chooses among are seen at a point.
#pragma once

#include "tracer/transport/trace.h"

namespace durer::tracer {

/// Calls `visit(view, weight)` with every texture that a patterned one shows at a point; weights
/// add up to 1. `view.texture` of these may be patterned again. What a visitor makes of `view.seen`
/// the next one gets, as with the oracle, where the upper of two comes first.
template <typename Visit>
void Tracer::for_parts(const View& view, Visit visit) const {
  const TextureStore& textures = scene_->textures;
  const TextureChoice& choice = textures.choice(*view.texture);
  const auto entries = textures.entries(choice);
  View part = view;
  const double value = choose(part, choice);
  const auto show = [&](const TextureChoiceEntry& e, float weight) {
    part.texture = &textures.program(e.texture);
    visit(part, weight);
  };
  if (!choice.by_uv && choice.pattern.type->averages) {
    float total = 0;
    for (const TextureChoiceEntry& e : entries) total += e.key;
    for (const TextureChoiceEntry& e : entries) show(e, e.key / total);
    return;
  }
  const auto found = find_neighbours(entries, value);
  if (found.single()) return show(*found.lower, 1);
  const auto t = static_cast<float>(found.t);
  show(*found.upper, t);
  show(*found.lower, 1 - t);
}

}  // namespace durer::tracer

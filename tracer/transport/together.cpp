// Rays of neighbouring pixels side by side: first what each of them meets, then what that looks like,
// for all points on one texture together, then the light on each.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <new>

#include "tracer/transport/layers.h"

namespace durer::tracer {

// Where the order of rays matters, or there is more between surfaces than nothing, they are followed
// one by one.
void Tracer::trace(std::span<Sample> samples) {
  if (!together_) {
    for (Sample& s : samples) {
      scratch_->noise = s.noise;
      s.seen = follow(s.path, false);
    }
    return;
  }
  std::array<FoundSurface*, most_together> waiting;
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    FoundSurface& found = scratch_->found[i];
    found.waits = find(samples[i], found);
    if (found.waits) waiting[count++] = &found;
  }
  for (std::size_t first = 0; first < count;) {
    const TextureProgram* texture = waiting[first]->look.view.texture;
    std::size_t end = first + 1;
    while (end < count && waiting[end]->look.view.texture == texture) ++end;
    if (end - first > 1) look_up({&waiting[first], end - first});
    first = end;
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!scratch_->found[i].waits) continue;
    scratch_->noise = samples[i].noise;
    samples[i].seen = lit_and_behind(scratch_->found[i].look.view, samples[i].path);
  }
}

/// The surface that a ray meets, if it waits to be lit; else what the ray sees is known.
bool Tracer::find(Sample& sample, FoundSurface& found) {
  Path& path = sample.path;
  const Limits& limit = limits(path);
  if (path.level >= limit.max_level || path.weight < limit.adc) {
    sample.seen = {};
    return false;
  }
  Hit hit;
  ++scratch_->rays;
  if (!scene_->geometry.closest(path.ray, t_min, path.reach, path.kind(), hit,
                                *scratch_->geometry)) {
    const Sky::Seen s = scene_->sky.at(path.ray.d, !alpha_);
    sample.seen = {s.colour, s.transmittance};
    return false;
  }
  ++path.level;
  Look& look = *::new (&found.look) Look(this->look(hit, path.ray.d));  // made in place
  if (!is_mixed(look)) return true;
  scratch_->noise = sample.noise;
  sample.seen = mixed(look, hit, path);
  return false;
}

/// The layers of a texture at several points, as far as they show.
void Tracer::look_up(std::span<FoundSurface* const> found) const {
  const TextureProgram& texture = *found.front()->look.view.texture;
  if (texture.uses_uv || texture.asks_view) return;
  std::array<FoundSurface*, most_together> seen;
  std::size_t count = 0;
  for (FoundSurface* f : found) {
    f->through = vec3(1.0F);
    seen[count++] = f;
  }
  const std::uint32_t layers =
      std::min(texture.end_layer - texture.first_layer, FoundSurface::most_layers);
  const float least = limits_[0].adc;
  for (std::uint32_t i = 0; i < layers && count > 0; ++i) {
    const LayerProgram& layer = scene_->textures.layer(texture.first_layer + i);
    look_up_layer(layer, i, {seen.data(), count});
    std::size_t left = 0;
    for (std::size_t k = 0; k < count; ++k) {
      FoundSurface& f = *seen[k];
      f.look.view.known = {f.layers.data(), i + 1};
      f.through *= f.layers[i].colour.transmission();
      if (std::min(1.0F, std::abs(grey(f.through))) > least) seen[left++] = &f;
    }
    count = left;
  }
}

void Tracer::look_up_layer(const LayerProgram& layer, std::size_t number,
                           std::span<FoundSurface* const> found) const {
  std::array<dvec3, most_together> points;
  std::array<dvec3, most_together> normals;
  std::array<Colour, most_together> colours;
  const std::size_t count = found.size();
  const auto place = [&] {
    for (std::size_t i = 0; i < count; ++i) points[i] = found[i]->look.view.q;
    return std::span(points).first(count);
  };
  const auto in_the_world = [](const FoundSurface* f) {
    return f->look.view.places == 0 && f->look.view.frame_count == 0;
  };
  for (std::size_t i = 0; i < count; ++i) normals[i] = found[i]->look.view.g;
  if (layer.normal != scene::none) {
    if (std::all_of(found.begin(), found.end(), in_the_world)) {
      scene_->textures.normals().at(layer.normal, place(), normals.data());
      for (std::size_t i = 0; i < count; ++i) normals[i] = glm::normalize(normals[i]);
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        const View& view = found[i]->look.view;
        SurfaceView seen{view.p, view.d, view.g, view.uv};
        normals[i] = bend(view, layer, seen);
      }
    }
  }
  scene_->textures.pigments().at(layer.pigment, place(), colours.data());
  for (std::size_t i = 0; i < count; ++i) found[i]->layers[number] = {normals[i], colours[i]};
}

}  // namespace durer::tracer

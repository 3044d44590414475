// Rays of neighbouring pixels side by side: first what each of them meets, then what that looks
// like, for all points on one texture together, then the light on each.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <new>

#include "tracer/accel/lanes.h"
#include "tracer/transport/layers.h"
#include "tracer/transport/look.h"

namespace durer::tracer {

namespace {

/// A bit for each.
std::uint32_t all_of(std::span<const Sample> samples) { return (2U << (samples.size() - 1)) - 1; }

}  // namespace

// Where the order of rays matters, they are followed one by one.
void Tracer::trace(std::span<Sample> samples) {
  if (samples.empty()) return;  // where cameras see nothing
  if (!together_) {
    for (Sample& s : samples) {
      scratch_->noise = s.noise;
      s.seen = follow(s.path, false);
    }
    return;
  }
  const bool met = meet(samples);
  const bool plainly = met && sees_plainly();
  const std::uint32_t lit = plainly ? light_met(samples, nullptr) : 0;
  std::array<FoundSurface*, most_together> waiting;
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    FoundSurface& found = scratch_->found[i];
    found.waits = false;
    if ((lit >> i & 1) != 0) continue;
    found.waits = met ? find_met(samples[i], scratch_->meeting[i], found) : find(samples[i], found);
    if (found.waits) waiting[count++] = &found;
  }
  if (count > 0) light_found(samples, std::span(waiting).first(count), plainly);
}

// Most packets see the sky or what is lit the short way, and need no paths.
void Tracer::trace(const Path& start, const PacketRays& rays, std::span<Sample> samples) {
  const auto make_path = [&](std::size_t i) {
    Path& path = samples[i].path;
    path = start;
    path.ray = rays.ray(i);
  };
  if (!together_ || in_air_ || !is_worth_following(start)) {
    for (std::size_t i = 0; i < samples.size(); ++i) make_path(i);
    return trace(samples);
  }
  scratch_->rays += samples.size();
  const bool one = scene_->geometry.is_one_object();
  const std::uint32_t lit = one ? meet_one(start, rays, samples) : meet_any(start, rays, samples);
  if (lit == all_of(samples)) return;
  std::array<FoundSurface*, most_together> waiting;
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    FoundSurface& found = scratch_->found[i];
    const MeetingRay& ray = scratch_->meeting[i];
    found.waits = false;
    if ((lit >> i & 1) != 0) continue;
    if (!ray.met) {
      see_sky(rays.d[i], samples[i]);
      continue;
    }
    make_path(i);
    found.waits = see(samples[i], true, ray.hit, found);
    if (found.waits) waiting[count++] = &found;
  }
  if (count > 0) light_found(samples, std::span(waiting).first(count), sees_plainly());
}

/// What the rays meet, in Scratch::meeting but for those that are lit at once: returns their bits.
std::uint32_t Tracer::meet_one(const Path& start, const PacketRays& rays,
                               std::span<Sample> samples) {
  PacketMeeting meeting;
  scene_->geometry.closest(rays, start.kind(), meeting);
  std::uint32_t lit = 0;
  if (meeting.met != 0 && sees_plainly()) lit = light_met(start, rays, meeting, samples);
  if (lit == all_of(samples)) return lit;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    scratch_->meeting[i].met = (meeting.met >> i & 1) != 0;
  }
  if (lit == meeting.met) return lit;
  std::size_t number = 0;
  wide::each_bit(meeting.met, [&](std::size_t i) DURER_LAMBDA_INLINE {
    meeting.fill_in(number++, scratch_->meeting[i].hit);
  });
  return lit;
}

/// The same where rays may meet several objects.
std::uint32_t Tracer::meet_any(const Path& start, const PacketRays& rays,
                               std::span<Sample> samples) {
  Packet<Ray> each;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    each[i] = rays.ray(i);
    MeetingRay& ray = scratch_->meeting[i];
    ray.ray = &each[i];
    ray.t_from = rays.t_from[i];
    ray.t_to = rays.t_to[i];
  }
  scene_->geometry.closest(std::span(scratch_->meeting).first(samples.size()), start.kind(),
                           *scratch_->geometry);
  return sees_plainly() ? light_met(samples, &start) : 0;
}

/// What is seen of surfaces that wait for it, of which those in `waiting` are all.
void Tracer::light_found(std::span<Sample> samples, std::span<FoundSurface*> waiting,
                         bool plainly) {
  for (std::size_t first = 0; first < waiting.size();) {
    const TextureProgram* texture = waiting[first]->look.view.texture;
    std::size_t end = first + 1;
    while (end < waiting.size() && waiting[end]->look.view.texture == texture) ++end;
    if (end - first > 1) look_up(waiting.subspan(first, end - first), first);
    first = end;
  }
  if (plainly) light_together(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!scratch_->found[i].waits) continue;
    Sample& sample = samples[i];
    const View& view = scratch_->found[i].look.view;
    scratch_->noise = sample.noise;
    if (is_plain(view) && !in_air_) {
      plain_light(view, sample.path.inside, sample.seen.colour);
      sample.seen.transmittance = 0;
      continue;
    }
    const Step step = surface(view, sample.path);
    Along along = scratch_->found[i].along;
    along.add(step);
    if (step.continues) {
      along.through *= step.through;
      sample.seen = follow(sample.path, step.straight, along);
    } else {
      sample.seen = {along.sum, along.transmittance};
    }
  }
}

/// What the rays meet, found for all of them together in Scratch::meeting; false if they do not see
/// the same things, or some are not worth following.
bool Tracer::meet(std::span<Sample> samples) {
  const RayKind kind = samples.front().path.kind();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Path& path = samples[i].path;
    if (path.kind() != kind || !is_worth_following(path)) return false;
    MeetingRay& ray = scratch_->meeting[i];
    ray.ray = &path.ray;
    ray.t_from = t_min;
    ray.t_to = path.reach;
  }
  scratch_->rays += samples.size();
  scene_->geometry.closest(std::span(scratch_->meeting).first(samples.size()), kind,
                           *scratch_->geometry);
  return true;
}

/// The surface that a ray meets, if it waits to be lit; else what the ray sees is known.
DURER_INLINE bool Tracer::see(Sample& sample, bool met, const Hit& hit, FoundSurface& found) {
  Path& path = sample.path;
  Along& along = *::new (&found.along) Along;
  if (in_air_) {
    scratch_->noise = sample.noise;
    pass_air(path, met ? &hit : nullptr, along);
    sample.noise = scratch_->noise;  // goes on from here
  }
  if (!met) {
    const Sky::Seen s = scene_->sky.at(path.ray.d, !alpha_);
    sample.seen = along.ends_with({s.colour, s.transmittance});
    return false;
  }
  ++path.level;
  Look& look = *::new (&found.look) Look;
  this->look(hit, path.ray.d, look);
  if (!is_mixed(look)) return true;
  scratch_->noise = sample.noise;
  sample.seen = along.ends_with(mixed(look, hit, path));
  return false;
}

/// The sky, with nothing before it.
DURER_INLINE void Tracer::see_sky(const dvec3& d, Sample& sample) const {
  if (plain_sky_) {
    sample.seen = *plain_sky_;
  } else {
    const Sky::Seen s = scene_->sky.at(d, !alpha_);
    sample.seen = {vec3(0.0F) + s.colour, s.transmittance};
  }
}

bool Tracer::find(Sample& sample, FoundSurface& found) {
  const Path& path = sample.path;
  if (!is_worth_following(path)) {
    sample.seen = {};
    return false;
  }
  Hit hit;
  ++scratch_->rays;
  const bool met =
      scene_->geometry.closest(path.ray, t_min, path.reach, path.kind(), hit, *scratch_->geometry);
  if (met || in_air_) return see(sample, met, hit, found);
  see_sky(sample.path.ray.d, sample);
  return false;
}
bool Tracer::find_met(Sample& sample, const MeetingRay& ray, FoundSurface& found) {
  if (ray.met || in_air_) return see(sample, ray.met, ray.hit, found);
  see_sky(sample.path.ray.d, sample);
  return false;
}

/// The layers of a texture at several points, as far as they show. `place`: what is kept of them in
/// Scratch::found_layers begins there.
void Tracer::look_up(std::span<FoundSurface* const> found, std::size_t place) {
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
    dvec3* const normals = &scratch_->found_layers[i].normals[place];
    Colour* const colours = &scratch_->found_layers[i].colours[place];
    look_up_layer(layer, {seen.data(), count}, normals, colours);
    std::size_t left = 0;
    for (std::size_t k = 0; k < count; ++k) {
      FoundSurface& f = *seen[k];
      View& view = f.look.view;
      f.layers[i] = {layer.normal == scene::none ? &view.g : &normals[k], &colours[k]};
      view.known = {f.layers.data(), i + 1};
      if (i + 1 == layers) continue;
      f.through *= colours[k].transmission();
      if (std::min(1.0F, std::abs(grey(f.through))) > least) seen[left++] = &f;
    }
    count = left;
  }
}

void Tracer::look_up_layer(const LayerProgram& layer, std::span<FoundSurface* const> found,
                           dvec3* normals, Colour* colours) const {
  std::array<dvec3, most_together> places;
  const std::size_t count = found.size();
  const auto points = [&] {
    for (std::size_t i = 0; i < count; ++i) places[i] = found[i]->look.view.q;
    return std::span(places).first(count);
  };
  scene_->textures.pigments().at(layer.pigment, points(), colours);
  if (layer.normal == scene::none) return;
  const auto in_the_world = [](const FoundSurface* f) {
    return f->look.view.places == 0 && f->look.view.frame_count == 0;
  };
  if (std::all_of(found.begin(), found.end(), in_the_world)) {
    for (std::size_t i = 0; i < count; ++i) normals[i] = found[i]->look.view.g;
    scene_->textures.normals().at(layer.normal, points(), normals);
    for (std::size_t i = 0; i < count; ++i) normals[i] = glm::normalize(normals[i]);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {  // there and back through other spaces
    const View& view = found[i]->look.view;
    SurfaceView seen{view.p, view.d, view.g, view.uv};
    normals[i] = bend(view, layer, seen);
  }
}

}  // namespace durer::tracer

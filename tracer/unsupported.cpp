#include "tracer/unsupported.h"

#include <fmt/format.h>

#include <algorithm>

#include "tracer/shading/texture.h"

namespace durer::tracer {
namespace {

// Marks `id` and tells whether it was new.
bool mark(std::vector<bool>& seen, std::uint32_t id) {
  if (seen.size() <= id) seen.resize(id + 1);
  const bool is_new = !seen[id];
  seen[id] = true;
  return is_new;
}

}  // namespace

void UnsupportedReport::check_texture(scene::TextureId id, std::uint32_t depth) {
  const scene::Texture& texture = scene_->textures[id];
  if (depth > max_texture_depth) {
    report(fmt::format("more than {} patterned textures inside of each other", max_texture_depth),
           texture.origin);
    return;
  }
  if (!mark(textures_seen_, id) && !texture.patterned()) return;
  report(texture.unsupported, texture.origin);
  for (const scene::TextureEntry& e : texture.entries) check_texture(e.texture, depth + 1);
  for (const scene::Layer& layer : texture.layers) {
    const scene::OriginId place = layer.pigment->origin != 0 ? layer.pigment->origin : texture.origin;
    report(layer.unsupported, place);
    check_pigment(*layer.pigment);
    check_normal(*layer.normal);
    check_finish(*layer.finish, place);
  }
}

void UnsupportedReport::check_interior(scene::InteriorId id) {
  if (!mark(interiors_seen_, id)) return;
  report(scene_->interiors[id].unsupported, scene_->interiors[id].origin);
  check_media(*scene_->interiors[id].media);
}

void UnsupportedReport::check_media(std::span<const scene::Media> media) {
  for (const scene::Media& m : media) {
    for (const scene::Pigment& d : m.densities) check_pigment(d);
  }
}

void UnsupportedReport::check_pigment(const scene::Pigment& pigment) {
  report(pigment.unsupported, pigment.origin);
  for (const scene::Pigment& child : pigment.children) {
    check_pigment(child);
  }
}

void UnsupportedReport::check_normal(const scene::Normal& normal) {
  report(normal.unsupported, normal.origin);
  for (const scene::Normal& child : normal.children) {
    check_normal(child);
  }
}

void UnsupportedReport::check_sky_pigment(const scene::Pigment& pigment) {
  if (pigment.uv_mapping) report("`uv_mapping` in a sky", pigment.origin);
  report(pigment.unsupported, pigment.origin);
  for (const scene::Pigment& child : pigment.children) check_sky_pigment(child);
}

void UnsupportedReport::check_finish(const scene::Finish& finish, scene::OriginId origin) {
  report(finish.unsupported, origin);
  const bool reflects =
      finish.reflection_min != vec3(0.0F) || finish.reflection_max != vec3(0.0F);
  // The mean of powers is not the power of the mean.
  if (paths_ && reflects && finish.reflection_exponent != 1) {
    report("`reflection_exponent` in path tracing", origin);
  }
  if (paths_ && scene_->settings.subsurface && finish.translucency != vec3(0.0F)) {
    report("`subsurface` in path tracing", origin);
  }
}

void UnsupportedReport::report(std::string_view feature, scene::OriginId origin) {
  if (feature.empty()) return;
  const std::pair key{std::string(feature), origin};
  if (std::find(reported_.begin(), reported_.end(), key) != reported_.end()) return;
  reported_.push_back(key);

  Diagnostic d;
  d.code = Code::not_supported;
  d.span = scene_->origins[origin].span;
  d.message = fmt::format("{} is not supported yet", feature);
  d.at = "used by an object of the scene";
  for (scene::OriginId i = scene_->origins[origin].parent; i != 0; i = scene_->origins[i].parent) {
    d.trace.push_back({scene_->origins[i].span, "expanded from here"});
  }
  diagnostics_->report(std::move(d));
}

}  // namespace durer::tracer

#include "tracer/shading/texture.h"

#include <algorithm>
#include <bit>

#include "tracer/patterns/patterns.h"

namespace durer::tracer {
namespace {

bool asks_view(const scene::Pattern& pattern) {
  return pattern.exists() && pattern_types()[pattern.type]->asks_view;
}
template <typename Look>  // Pigment or Normal
bool asks_view(const Look& look) {
  return asks_view(*look.pattern) ||
         std::any_of(look.children.begin(), look.children.end(),
                     [](const Look& child) { return asks_view(child); });
}

}  // namespace

std::size_t TextureStore::KeyHash::operator()(const Key& key) const {
  std::uint64_t h = key.texture;
  for (const dvec3& row : {key.placement.x, key.placement.y, key.placement.z, key.placement.t}) {
    for (int i = 0; i < 3; ++i) {
      h = (h ^ std::bit_cast<std::uint64_t>(row[i])) * 0x9E3779B97F4A7C15U;
      h ^= h >> 32;
    }
  }
  return h;
}

TextureStore::TextureStore(const scene::Scene& scene, Quality quality)
    : scene_(&scene),
      quality_(quality),
      pigments_(scene.settings, quality.quick_colours),
      normals_(scene.settings),
      patterns_(scene.settings) {}

ProgramId TextureStore::add(const scene::TextureUse& use) {
  const scene::Texture& texture = scene_->textures[use.texture];
  const Transform placement = scene::has_place(texture) ? use.transform.get() : Transform{};
  const Key key{use.texture, placement.forward};
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const TextureProgram program = texture.patterned() ? compile_choice(texture, placement)
                                                     : compile_layers(use.texture, placement);
  const auto id = static_cast<ProgramId>(programs_.size());
  programs_.push_back(program);
  known_.emplace(key, id);
  return id;
}

TextureProgram TextureStore::compile_layers(scene::TextureId id, const Transform& placement) {
  const scene::Texture& texture = scene_->textures[id];
  const std::uint32_t finish = finishes_of(id);
  TextureProgram program;
  program.first_layer = static_cast<std::uint32_t>(layers_.size());
  for (std::size_t i = texture.layers.size(); i-- > 0;) {  // the last written is the outermost
    const scene::Layer& layer = texture.layers[i];
    LayerProgram out;
    out.finish = finish + static_cast<std::uint32_t>(i);
    out.pigment = pigments_.add(*layer.pigment, placement);
    program.uses_uv = program.uses_uv || scene::uses_uv(*layer.pigment);
    program.asks_view = program.asks_view || asks_view(*layer.pigment);
    if (quality_.normals && layer.normal->pattern->exists()) {
      out.normal = normals_.add(*layer.normal, placement);
      program.uses_uv = program.uses_uv || scene::uses_uv(*layer.normal);
      program.asks_view = program.asks_view || asks_view(*layer.normal);
    }
    layers_.push_back(out);
    program.opaque = program.opaque || pigments_.opaque(out.pigment);
  }
  program.end_layer = static_cast<std::uint32_t>(layers_.size());
  program.plain = program.opaque && texture.layers.size() == 1 &&
                  !finishes_[finish].reflects && finishes_[finish].translucency == vec3(0.0F);
  return program;
}

TextureProgram TextureStore::compile_choice(const scene::Texture& texture,
                                            const Transform& placement) {
  TextureProgram program;
  program.opaque = true;
  program.uses_uv = texture.uv_mapping || scene::uses_uv(*texture.pattern);
  std::vector<TextureChoiceEntry> entries;
  for (const scene::TextureEntry& e : texture.entries) {
    entries.push_back({e.key, add({e.texture, {}})});
    const TextureProgram& part = programs_[entries.back().texture];
    program.opaque = program.opaque && part.opaque;
    program.uses_uv = program.uses_uv || part.uses_uv;
  }
  TextureChoice choice;
  choice.by_uv = texture.uv_mapping;
  if (!choice.by_uv) {
    choice.pattern = patterns_.compile(*texture.pattern, placement);
    choice.frame = NormalFrame(*texture.pattern, placement, texture.no_bump_scale);
  }
  choice.first_entry = static_cast<std::uint32_t>(choice_entries_.size());
  choice_entries_.insert(choice_entries_.end(), entries.begin(), entries.end());
  choice.end_entry = static_cast<std::uint32_t>(choice_entries_.size());
  program.choice = static_cast<std::uint32_t>(choices_.size());
  choices_.push_back(choice);
  return program;
}

std::uint32_t TextureStore::finishes_of(scene::TextureId id) {
  const auto [known, is_new] =
      first_finish_.try_emplace(id, static_cast<std::uint32_t>(finishes_.size()));
  if (is_new) {
    const scene::Settings& settings = scene_->settings;
    // Light that is gathered takes the place of light that is assumed (participating §2.2).
    const bool gathered = ((settings.radiosity && quality_.radiosity) || quality_.path) &&
                          settings.effective_version >= 370;
    const vec3 ambient = gathered ? vec3(0.0F) : settings.ambient_light;
    for (const scene::Layer& layer : scene_->textures[id].layers) {
      finishes_.push_back(
          compile_finish(*layer.finish, ambient, settings.irid_wavelength,
                         settings.resolved_noise_generator()));
    }
  }
  return known->second;
}

}  // namespace durer::tracer

#include "tracer/shading/texture.h"

#include <algorithm>
#include <bit>

namespace durer::tracer {
namespace {

// A texture of plain colours looks the same wherever it is placed.
bool has_pattern(const scene::Texture& texture) {
  return std::any_of(texture.layers.begin(), texture.layers.end(),
                     [](const scene::Layer& l) { return l.pigment->pattern.exists(); });
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

ProgramId TextureStore::add(const scene::TextureUse& use) {
  const scene::Texture& texture = scene_->textures[use.texture];
  const Transform placement = has_pattern(texture) ? use.transform.get() : Transform{};
  const auto [known, is_new] = known_.try_emplace({use.texture, placement.forward},
                                                  static_cast<ProgramId>(programs_.size()));
  if (!is_new) return known->second;

  const std::uint32_t finish = finishes_of(use.texture);
  TextureProgram program;
  program.first_layer = static_cast<std::uint32_t>(layers_.size());
  for (std::size_t i = texture.layers.size(); i-- > 0;) {  // the last written is the outermost
    const scene::Layer& layer = texture.layers[i];
    const bool by_uv = layer.pigment->uv_mapping;
    const PigmentId pigment = pigments_.add(*layer.pigment, by_uv ? Transform{} : placement);
    layers_.push_back({pigment, finish + static_cast<std::uint32_t>(i), by_uv});
    program.uses_uv = program.uses_uv || by_uv;
    program.opaque = program.opaque || pigments_.opaque(pigment);
  }
  program.end_layer = static_cast<std::uint32_t>(layers_.size());
  programs_.push_back(program);
  return known->second;
}

std::uint32_t TextureStore::finishes_of(scene::TextureId id) {
  const auto [known, is_new] =
      first_finish_.try_emplace(id, static_cast<std::uint32_t>(finishes_.size()));
  if (is_new) {
    const scene::Settings& settings = scene_->settings;
    for (const scene::Layer& layer : scene_->textures[id].layers) {
      finishes_.push_back(
          compile_finish(*layer.finish, settings.ambient_light, settings.irid_wavelength));
    }
  }
  return known->second;
}

}  // namespace durer::tracer

// What photons add to surfaces and media, and the shadows that they fill (participating-and-global
// §3.10-3.12).
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tracer/transport/media.h"

namespace durer::tracer {

// The photons around a surface; all of its layers share them. `n`: of the outermost.
void Tracer::find_photons(const View& view, dvec3 n) {
  const PhotonMaps& maps = *scratch_->photons;
  tracer::gather(maps.surfaces, maps.on_surfaces, view.p, n, scratch_->near_photons);
}

// Each photon is a beam of light that falls onto its share of the surface.
vec3 Tracer::caustics(const View& view, const LayerPoint& layer) {
  const FoundPhotons& found = scratch_->near_photons;
  if (found.count == 0) return vec3(0.0F);
  const Finish& f = *layer.finish;
  const bool plain = f.irid <= 0 && f.crand <= 0;
  const vec3 sum = plain ? plain_caustics(view, layer) : any_caustics(view, layer);
  return sum * static_cast<float>(1 / (std::numbers::pi * found.radius * found.radius));
}

namespace {
// What has come in at grazing angles covers so much that it would count without bound.
constexpr float least_cosine = 0.1F;
}  // namespace

vec3 Tracer::any_caustics(const View& view, const LayerPoint& layer) {
  const PhotonMap& map = scratch_->photons->surfaces;
  vec3 sum(0.0F);
  for (const std::uint32_t i : scratch_->near_photons.photons()) {
    const Photon& photon = map[i];
    const dvec3 l(photon.l);
    const bool hidden = is_behind(view, layer, l);
    if (hidden && layer.finish->diffuse_back == 0) continue;
    const float cosine = std::clamp(static_cast<float>(glm::dot(view.g, l)), least_cosine, 1.0F);
    sum += shade(view, layer, {l, photon.power / cosine, true}, hidden);
  }
  return sum;
}

// The same for finishes that are diffuse or shine, and nothing else.
vec3 Tracer::plain_caustics(const View& view, const LayerPoint& layer) {
  const PhotonMap& map = scratch_->photons->surfaces;
  const Finish& f = *layer.finish;
  const bool shines = f.highlights && !view.gathering;
  const vec3 n(layer.n);
  const vec3 g(view.g);
  vec3 sum(0.0F);
  vec3 shine(0.0F);
  for (const std::uint32_t i : scratch_->near_photons.photons()) {
    const Photon& photon = map[i];
    const float cosine = glm::dot(n, photon.l);
    const bool hidden = cosine < static_cast<float>(epsilon) && !view.double_illuminate;
    const float spread = std::clamp(glm::dot(g, photon.l), least_cosine, 1.0F);
    if (const float share = hidden ? f.diffuse_back : f.diffuse; share > 0) {
      const float bright =
          f.brilliance.is_one() ? std::abs(cosine)
                                : std::pow(std::abs(cosine), float{f.brilliance});
      sum += share * bright / spread * photon.power;
    }
    if (shines && !hidden) {
      const vec3 share = highlight(f, view.d, layer.n, dvec3(photon.l), layer.pigment);
      shine += share / spread * photon.power;
    }
  }
  return sum * layer.opacity * layer.pigment + shine;
}

// Light through a target comes as photons.
bool Tracer::leaves_to_photons(const Light& light, const Hit& hit) const {
  const PhotonTraits& traits =
      scene_->surfaces[scene_->geometry.leaves()[hit.leaf].surface].photons;
  return traits.target != scene::none && agree(traits.refraction, light.photons.refraction);
}

// Light of photons that media scatter along the ray, for a unit of their scattering.
vec3 MediaIntegrator::photons_at(dvec3 p) {
  const PhotonMaps& maps = *scratch_.photons;
  FoundPhotons& near = scratch_.media_photons;
  gather(maps.media, maps.in_media, p, dvec3(0.0), near);
  vec3 sum(0.0F);
  for (const std::uint32_t i : near.photons()) {
    const Photon& photon = maps.media[i];
    sum += static_cast<float>(mean_phase(glm::dot(ray_.d, dvec3(photon.l)))) * photon.power;
  }
  return sum * static_cast<float>(3 / (4 * std::numbers::pi * near.radius * near.radius * near.radius));
}

}  // namespace durer::tracer

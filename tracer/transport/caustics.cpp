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
  scratch_->photon_radius =
      tracer::gather(maps.surfaces, maps.on_surfaces, view.p, n, scratch_->near_photons);
}

// Each photon is a beam of light that falls onto its share of the surface.
vec3 Tracer::caustics(const View& view, const LayerPoint& layer) {
  // What has come in at grazing angles covers so much that it would count without bound.
  constexpr double least_cosine = 0.1;
  vec3 sum(0.0F);
  for (const NearPhoton& found : scratch_->near_photons) {
    const Photon& photon = scratch_->photons->surfaces[found.index];
    const dvec3 l(photon.l);
    const bool hidden = is_behind(view, layer, l);
    if (hidden && layer.finish->diffuse_back == 0) continue;
    const double cosine = std::clamp(glm::dot(view.g, l), least_cosine, 1.0);
    sum += shade(view, layer, {l, photon.power / static_cast<float>(cosine), true}, hidden);
  }
  const double r = scratch_->photon_radius;
  return sum * static_cast<float>(1 / (std::numbers::pi * r * r));
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
  const double r =
      gather(maps.media, maps.in_media, p, dvec3(0.0), scratch_.near_photons);
  vec3 sum(0.0F);
  for (const NearPhoton& found : scratch_.near_photons) {
    const Photon& photon = maps.media[found.index];
    sum += static_cast<float>(mean_phase(glm::dot(ray_.d, dvec3(photon.l)))) * photon.power;
  }
  return sum * static_cast<float>(3 / (4 * std::numbers::pi * r * r * r));
}

}  // namespace durer::tracer

#include "tracer/transport/photon_tracer.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "tracer/random.h"
#include "tracer/shading/spectrum.h"
#include "tracer/transport/texture_parts.h"

namespace durer::tracer {
namespace {

/// What a photon's weight is multiplied by once more where it is reflected or let through: its
/// limit is on the square of what a camera ray would have left, as the oracle's stored photons show.
float strongest(vec3 share) { return std::max({share.r, share.g, share.b}); }

}  // namespace

PhotonTracer::PhotonTracer(const CompiledScene& scene, Scratch& scratch)
    : scene_(scene), scratch_(scratch), tracer_(scene, scratch, false) {
  const scene::Settings& settings = scene.scene->settings;
  const scene::Photons& photons = *settings.photons;
  max_level_ = std::clamp(photons.max_trace_level.value_or(settings.max_trace_level), 1, 256);
  adc_ = static_cast<float>(photons.adc_bailout.value_or(settings.adc_bailout));
}

bool PhotonTracer::shoot(const PhotonPair& pair, const EmittedPhoton& photon, PhotonLists& out) {
  Journey journey{pair, out};
  Flight flight;
  flight.path.ray = photon.ray;
  flight.colour = photon.colour;
  if (pair.lamp->projector != scene::none) {
    // It shines through that object, and begins behind it.
    const Geometry& shape = scene_.projectors[pair.lamp->projector];
    Hit hit;
    bool met = false;
    while (shape.closest(flight.path.ray, t_min, no_hit_depth, RayKind::image, hit,
                         *scratch_.projectors[pair.lamp->projector])) {
      flight.path.ray.o = hit.p;
      flight.way += hit.t;
      met = true;
    }
    if (!met) return false;
  }
  start_inside(flight);
  follow(flight, journey);
  return journey.on_target;
}

void PhotonTracer::start_inside(Flight& flight) const {
  scratch_.containing.clear();
  scene_.geometry.containing(flight.path.ray.o, scratch_.containing, *scratch_.geometry);
  for (const std::uint32_t id : scratch_.containing) flight.path.inside.append(id);
}

void PhotonTracer::follow(Flight flight, Journey& journey) {
  Path& path = flight.path;
  if (path.level >= max_level_ || path.weight < adc_) return;
  Hit hit;
  ++scratch_.rays;
  const RayKind kind = path.reflected     ? RayKind::reflection
                       : path.transmitted ? RayKind::transmission
                                          : RayKind::image;
  if (!scene_.geometry.closest(path.ray, t_min, no_hit_depth, kind, hit, *scratch_.geometry)) {
    return;
  }
  const PhotonTraits& traits =
      scene_.surfaces[scene_.geometry.leaves()[hit.leaf].surface].photons;
  if (!goes_on(flight, traits, journey)) return;
  through_media(flight, hit, traits, journey);
  const Interior& body = scene_.interiors[hit.interior];
  if (fades(body) && path.inside.contains(hit.interior)) flight.colour *= fade(body, hit.t);
  flight.way += hit.t;
  if (flight.hits > 0 && traits.collects()) {
    leave(flight, hit.p, flight.colour, flight.way, journey.pair, journey.out.surfaces);
  }
  if (flight.hits > 0 || !traits.pass_through) ++flight.hits;
  ++path.level;

  const Tracer::Look look = tracer_.look(hit, path.ray.d);
  if (look.blend.count <= 1) return bounce(look.view, flight, traits, journey);
  for (std::uint32_t i = 0; i < look.blend.count; ++i) {
    const TextureBlend::Part& part = look.blend.parts[i];
    if (part.weight < adc_) continue;
    View view = look.view;
    tracer_.dress(view, look, hit, part.texture);
    Flight own = flight;
    own.colour *= part.weight;
    bounce(view, own, traits, journey);
  }
}

// Until a photon is at its target, nothing else may be in its way but what lets it pass.
bool PhotonTracer::goes_on(const Flight& flight, const PhotonTraits& surface,
                           Journey& journey) const {
  if (flight.hits > 0) return true;
  if (surface.target == journey.pair.target) return journey.on_target = true;
  return surface.pass_through;
}

void PhotonTracer::through_media(Flight& flight, const Hit& hit, const PhotonTraits& surface,
                                 Journey& journey) {
  if (scene_.media.empty()) return;
  const Containment& inside = flight.path.inside;
  if (inside.empty() || !tracer_.in_the_open(inside)) return;
  const bool arrived = flight.hits > 0 && !(surface.pass_through && flight.hits == 0);
  if (arrived && scene_.scene->settings.photons->media_steps > 0) {
    leave_in_media(flight, hit, journey);
  }
  flight.colour *= tracer_.light_through_bodies(flight.path.ray, hit.t, inside);
}

// Photons along the ray, as far apart as those on surfaces would be there (§3.6).
void PhotonTracer::leave_in_media(const Flight& flight, const Hit& hit, Journey& journey) {
  const Path& path = flight.path;
  const std::uint32_t set = scene_.surfaces[scene_.geometry.leaves()[hit.leaf].surface].lamps;
  {
    MediaIntegrator media(tracer_, path.ray, hit.t,
                          {.inside = path.inside, .lamps = scene_.geometry.lamp_sets()[set]});
    for (const std::uint32_t id : path.inside.ids()) media.add(scene_.interiors[id].media);
    media.find_stretches(stretches_);
  }
  const scene::Photons& settings = *scene_.scene->settings.photons;
  const bool parallel = journey.pair.lamp->parallel;
  for (const MediaIntegrator::Interval& s : stretches_) {
    const double apart = journey.pair.spread * (parallel ? 1 : flight.way);
    double factor = settings.media_factor;
    int n = static_cast<int>(std::min(s.length / (apart * factor), 1e9));
    if (n > settings.media_steps) {
      factor *= static_cast<double>(n) / settings.media_steps;
      n = settings.media_steps;
    }
    for (int j = 0; j < n; ++j) {
      const double u =
          (j + 0.5 + (next_random(scratch_.noise) - 0.5) * settings.jitter) / n;
      const double t = s.t + u * s.length;
      const double way = flight.way + t;
      const double length = factor * journey.pair.spread * (parallel ? 1 : way);
      leave(flight, path.ray.at(t), flight.colour * static_cast<float>(length), way, journey.pair,
            journey.out.media);
    }
  }
}

void PhotonTracer::leave(const Flight& flight, dvec3 p, vec3 colour, double way,
                         const PhotonPair& pair, std::vector<Photon>& out) const {
  const vec3 power = colour * static_cast<float>(pair.energy(way));
  out.push_back({vec3(p), power, -vec3(flight.path.ray.d)});
}

// Both ways on are followed, by all the textures that are seen.
void PhotonTracer::bounce(const View& seen, const Flight& flight, const PhotonTraits& traits,
                          Journey& journey) {
  View view = seen;
  tracer_.narrow(view);
  if (view.texture->patterned()) {
    tracer_.for_parts(view, [&](const View& part, float weight) {
      Flight own = flight;
      own.colour *= weight;
      bounce(part, own, traits, journey);
    });
    return;
  }
  const std::size_t first = scratch_.reflections.size();
  const LayerSum sum = layers(view, flight.path);
  const scene::LightPhotons& lamp = journey.pair.lamp->photons;
  bool tir = false;
  if (flight.hits == 0) {
    Flight on = flight;  // straight through
    on.path.ray = {view.p, view.d};
    on.path.inside.toggle(view.interior);
    on.path.level = flight.path.level - 1;
    on.colour *= sum.through;
    if (sum.sigma > adc_) follow(on, journey);
  } else {
    if (sum.sigma > adc_ && agree(traits.refraction, lamp.refraction)) {
      tir = transmit(view, sum, flight, journey);
    }
    if (agree(traits.reflection, lamp.reflection)) reflect(view, sum, flight, first, tir, journey);
  }
  scratch_.reflections.resize(first);
}

// What the layers let through; their reflections are left on the stack of the scratch.
Tracer::LayerSum PhotonTracer::layers(const View& view, const Path& path) {
  const TextureStore& textures = scene_.textures;
  LayerSum sum;
  SurfaceView seen{view.p, view.d, view.g, view.uv};
  for (std::uint32_t i = view.texture->first_layer; i < view.texture->end_layer; ++i) {
    const LayerProgram& program = textures.layer(i);
    const dvec3 n = program.normal == scene::none ? view.g : tracer_.bend(view, program, seen);
    if (i == view.texture->first_layer) sum.top = n;
    const Colour c = textures.pigments().at(program.pigment, view.q, &seen);
    const Tracer::LayerPoint layer{&textures.finish(program), 1, n, c.rgb};
    vec3 rho(0.0F);
    if (layer.finish->reflects) rho = tracer_.remember_reflection(view, path, layer, sum.sigma);
    sum.through *= c.transmission();
    if (layer.finish->conserve_energy) sum.through *= glm::min(vec3(1.0F), 1.0F - rho);
    sum.sigma = std::min(1.0F, std::abs(grey(sum.through)));
  }
  return sum;
}

void PhotonTracer::reflect(const View& view, const LayerSum& sum, const Flight& flight,
                           std::size_t first, bool tir, Journey& journey) {
  const std::size_t end = scratch_.reflections.size();
  for (std::size_t i = first; i < end; ++i) {
    const Reflection r = scratch_.reflections[i];  // a copy: others go on that stack
    if (tir && Tracer::same_direction(r.n, sum.top)) continue;
    Flight on = flight;
    on.path.ray = {view.p, mirror(view.d, r.n, view.g)};
    on.path.weight = r.weight * strongest(r.rho);
    on.path.reflected = true;
    const Finish& f = *r.finish;
    if (f.irid > 0) {
      on.colour *= iridescence(f, view.p, glm::dot(r.n, on.path.ray.d), glm::dot(r.n, view.d));
    }
    if (f.reflection_power != 1) on.colour = glm::pow(on.colour, vec3(f.reflection_power));
    on.colour *= r.rho;
    follow(on, journey);
  }
}

// True if the photon was totally reflected.
bool PhotonTracer::transmit(const View& view, const LayerSum& sum, const Flight& flight,
                            Journey& journey) {
  const vec3 loss(scene_.interiors[view.interior].refraction);
  Tracer::Crossing c = tracer_.cross(view, sum, flight.path);
  const auto go_on = [&](double wavelength, vec3 hue) {
    Flight on = flight;
    on.path = c.next;
    on.colour *= loss * hue;
    std::optional<vec3> film;
    if (!c.straight) {
      film = tracer_.bend_path(view, sum, flight.path, c.eta(wavelength), on.path);
    }
    on.path.wavelength = wavelength;
    on.colour *= film ? *film : sum.through;
    if (!film) on.path.weight *= strongest(sum.through);
    follow(on, journey);
    return film.has_value();
  };
  if (!c.disperses || flight.path.wavelength != 0) return go_on(flight.path.wavelength, vec3(1.0F));
  const int n = tracer_.bands(view, c);
  for (int i = 0; i < n; ++i) {
    const Band band = spectral_band(i, n);
    go_on(band.wavelength, band.hue / static_cast<float>(n));
  }
  return false;
}

}  // namespace durer::tracer

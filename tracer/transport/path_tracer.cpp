#include "tracer/transport/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/transport/layers.h"

namespace durer::tracer {

Radiance PathTracer::trace(const Path& path, SobolSampler& random) {
  random_ = &random;
  Walk walk;
  walk.path = path;
  while (step(walk)) {
  }
  return {walk.light, walk.clear};
}

// From one surface to the next.
bool PathTracer::step(Walk& walk) {
  // Samples of a pixel that have gone through as many surfaces ask for the same dimensions.
  constexpr std::uint32_t dimensions = 16;
  random_->go_to(2 * dimensions * ++walk.steps);
  Path& path = walk.path;
  Hit hit;
  ++scratch_->rays;
  const bool met = scene_->geometry.closest(path.ray, t_min, path.reach, path.kind(), hit,
                                            *scratch_->geometry);
  if (tracer_.in_air_ && tracer_.in_the_open(path.inside) && cross(walk, met ? &hit : nullptr)) {
    return survives(walk);
  }
  if (!met) {
    const Sky::Seen sky =
        scene_->sky.at(path.ray.d, path.reflected || path.bounce > 0 || !alpha_);
    walk.light += walk.throughput * sky.colour * chance_weight(walk);
    walk.clear *= sky.transmittance;
    return false;
  }
  random_->go_to(2 * dimensions * walk.steps + dimensions);
  if (interact(walk, see(hit, path.ray.d))) return true;
  walk.clear = 0;
  return false;
}

// The share of light met by chance that looking for light does not find: by the balance heuristic
// (Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997).
float PathTracer::chance_weight(const Walk& walk) const {
  if (walk.density == 0 || !rules_.next_event || scene_->emitters.empty()) return 1;
  const double other = scene_->emitters.density(walk.from, walk.path.ray.d);
  return static_cast<float>(walk.density / (walk.density + other));
}

bool PathTracer::interact(Walk& walk, const View& view) {
  Vertex vertex;
  vertex.view = &view;
  survey(vertex, walk.path);
  if (vertex.glow != vec3(0.0F)) {
    walk.light += walk.throughput * vertex.glow * chance_weight(walk);
  }
  if (walk.bounces >= rules_.max_bounces && !vertex.step.straight) return false;
  find_lobes(vertex);
  if (walk.bounces < rules_.max_bounces && vertex.scatters) {
    vec3 light = lamp_light(view, walk.path.inside);
    light += emitter_light(view, walk.path.inside);
    walk.light += walk.throughput * light;
  }
  return leave(walk, vertex) && survives(walk);
}

// One of the ways on, by chance.
bool PathTracer::leave(Walk& walk, const Vertex& vertex) {
  const View& view = *vertex.view;
  Path& path = walk.path;
  double rest = random_->next();
  const Lobe* lobe = nullptr;
  for (const Lobe& l : lobes_) {
    lobe = &l;
    if (rest < l.share) break;
    rest -= l.share;
  }
  if (lobe == nullptr) return false;
  const auto share = static_cast<float>(lobe->share);
  if (lobe->kind == LobeKind::beyond) {
    if (!vertex.step.straight) ++walk.bounces;
    walk.throughput *= vertex.step.through * vertex.hue / share;
    walk.clear *= vertex.step.transmittance / share;
    walk.density = 0;
    path = vertex.beyond;
    return walk.bounces <= rules_.max_bounces;
  }
  if (walk.bounces >= rules_.max_bounces) return false;
  ++walk.bounces;
  walk.clear = 0;
  if (lobe->kind == LobeKind::mirror) {
    const Coat& coat = coats_[lobe->coat];
    const dvec3 n = coat.layer.n;
    path.ray = {view.p, mirror(view.d, n, view.g)};
    path.reflected = true;
    walk.throughput *= coat.rho / share;
    walk.density = 0;
    const Finish& f = *coat.layer.finish;
    if (f.irid > 0) {
      walk.throughput *=
          iridescence(f, view.p, glm::dot(n, path.ray.d), glm::dot(n, view.d));
    }
    return true;
  }
  const dvec3 d = direction(view, *lobe);
  walk.density = density(view, d);
  if (!(walk.density > 0)) return false;
  walk.throughput *= scattered(view, d) / static_cast<float>(walk.density);
  walk.from = view.p;
  path.inside = behind(view, path.inside, d);
  path.ray = {view.p, d};
  path.reach = no_hit_depth;
  path.bounce = 1;
  return true;
}

// Russian roulette: dim paths end, and those that go on make up for them.
bool PathTracer::survives(Walk& walk) {
  constexpr int sure = 3;  // bounces
  const vec3 t = walk.throughput;
  const float size = std::max({std::abs(t.x), std::abs(t.y), std::abs(t.z)});
  if (!(size > 0)) return false;
  if (walk.bounces <= sure || size >= 1) return true;
  if (random_->next() >= double{size}) return false;
  walk.throughput /= size;
  walk.clear /= size;
  return true;
}

}  // namespace durer::tracer

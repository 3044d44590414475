// What random paths meet between surfaces: fog, media, rainbows (docs/path-tracing.md).
#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "tracer/transport/directions.h"
#include "tracer/transport/path_tracer.h"

namespace durer::tracer {

// What media do to light on one piece of a path, and where they scatter it.
struct PathTracer::Drift {
  vec3 added{0.0F};
  vec3 kept{1.0F};
  // What a random place scatters of the light that arrives there, divided by how likely it was to be
  // chosen; black: nothing scatters.
  vec3 scattered{0.0F};
  double t = 0;
};

void PathTracer::see_through(Walk& walk, const Veil& veil) {
  walk.light += walk.throughput * veil.glow;
  walk.throughput *= veil.through;
  walk.clear *= veil.transmittance;
}

// From one surface to the next, through fog before media before rainbows. True if the path was
// scattered on the way, and goes on from there.
bool PathTracer::cross(Walk& walk, const Hit* hit) {
  const Path& path = walk.path;
  const double depth = hit == nullptr ? no_hit_depth : hit->t;
  if (tracer_.air_) see_through(walk, scene_->atmosphere.fog(path.ray, depth));
  if (!scene_->media.empty()) {
    list_media(path.inside, hit != nullptr);
    const std::uint32_t lamps =
        hit == nullptr ? 0 : scene_->surfaces[scene_->geometry.leaves()[hit->leaf].surface].lamps;
    if (!media_.empty() && drift(walk, depth, lamps)) return true;
  }
  if (tracer_.air_) {
    see_through(walk, scene_->atmosphere.rainbow(path.ray, depth, scratch_->noise));
  }
  return false;
}

// Bodies without a surface behind them are not seen, as in the oracle: their media end nowhere.
void PathTracer::list_media(const Containment& inside, bool met) {
  media_.clear();
  const auto add = [&](MediaRange range) {
    for (std::uint32_t i = range.first; i < range.end; ++i) media_.push_back(i);
  };
  if (!tracer_.in_the_open(inside)) return;
  add(scene_->air_media);
  if (!met) return;
  for (const std::uint32_t id : inside.ids()) add(scene_->interiors[id].media);
}

bool PathTracer::media_vary() const {
  return std::any_of(media_.begin(), media_.end(),
                     [this](std::uint32_t i) { return scene_->media[i].varies; });
}

PathTracer::Matter PathTracer::matter_at(dvec3 p) const {
  Matter sum;
  for (const std::uint32_t i : media_) {
    const MediaProgram& m = scene_->media[i];
    const vec3 density = m.varies ? scene_->media.density(m, p) : m.density;
    sum.extinction += density * m.extinction;
    sum.emission += density * m.emission;
    sum.scattering += density * m.scattering;
  }
  return sum;
}

namespace {

// The integral of exp(-x t) from 0 to `depth`.
vec3 attenuated_length(vec3 x, double depth) {
  vec3 sum;
  for (int i = 0; i < 3; ++i) {
    const double thickness = double{x[i]} * depth;
    sum[i] = static_cast<float>(std::abs(thickness) < 1e-6 ? depth * (1 - thickness / 2)
                                                           : -std::expm1(-thickness) / double{x[i]});
  }
  return sum;
}

vec3 exp_of(vec3 x, double depth) { return glm::exp(x * static_cast<float>(-depth)); }

}  // namespace

// Media that are the same everywhere, exactly. The place is chosen by how the light of one colour
// fades, and weighed by all three.
PathTracer::Drift PathTracer::evenly(const Ray& ray, double depth) {
  const Matter matter = matter_at(ray.o);
  const vec3 x = matter.extinction;
  Drift drift;
  drift.added = matter.emission * attenuated_length(x, depth);
  drift.kept = exp_of(x, depth);
  if (matter.scattering == vec3(0.0F)) return drift;
  const dvec2 u = random_->next2();
  const int colour = std::min(2, static_cast<int>(u.x * 3));
  const auto lost = [&](int i) { return -std::expm1(-double{x[i]} * depth); };
  const auto is_clear = [&](int i) { return double{x[i]} * depth < 1e-6; };
  drift.t = is_clear(colour) ? u.y * depth
                             : -std::log1p(-u.y * lost(colour)) / double{x[colour]};
  double density = 0;
  for (int i = 0; i < 3; ++i) {
    density += is_clear(i) ? 1 / depth : double{x[i]} * std::exp(-double{x[i]} * drift.t) / lost(i);
  }
  drift.scattered =
      matter.scattering * exp_of(x, drift.t) * static_cast<float>(3 / density);
  return drift;
}

// How many steps the scene's settings amount to.
int PathTracer::march_steps() const {
  constexpr int least = 8;
  constexpr int most = 512;
  int steps = least;
  for (const std::uint32_t i : media_) {
    const MediaProgram& m = scene_->media[i];
    steps = std::max(steps, m.intervals * m.min_samples);
  }
  return std::min(steps, most);
}

// Others, in equal steps from a random place on. The more steps, the nearer is the mean of what
// comes through to the truth; all else has no bias but that.
PathTracer::Drift PathTracer::unevenly(const Ray& ray, double depth) {
  const int steps = march_steps();
  const double length = depth / steps;
  const double offset = random_->next();
  Draw draw{random_->next()};
  Drift drift;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + offset) * length;
    const Matter matter = matter_at(ray.at(t));
    const vec3 here = drift.kept * attenuated_length(matter.extinction, length);
    drift.added += matter.emission * here;
    const vec3 scattered = matter.scattering * here;
    if (draw.take(std::abs(double{grey(scattered)}))) {
      drift.scattered = scattered;
      drift.t = t;
    }
    drift.kept *= exp_of(matter.extinction, length);
  }
  if (draw.own > 0) drift.scattered *= draw.factor();
  return drift;
}

// What comes straight through. `met`: there is a surface at its end.
vec3 PathTracer::kept(const Ray& ray, double depth, const Containment& inside, bool met) {
  vec3 left(1.0F);
  if (!tracer_.in_air_ || !tracer_.in_the_open(inside)) return left;
  if (tracer_.air_) {
    left = scene_->atmosphere.fog(ray, depth).through *
           scene_->atmosphere.rainbow(ray, depth, scratch_->noise).through;
  }
  list_media(inside, met);
  if (media_.empty()) return left;
  if (!media_vary()) return left * exp_of(matter_at(ray.o).extinction, depth);
  const int steps = march_steps();
  const double length = depth / steps;
  const double offset = random_->next();
  vec3 thickness(0.0F);
  for (int i = 0; i < steps; ++i) {
    thickness += matter_at(ray.at((i + offset) * length)).extinction;
  }
  return left * exp_of(thickness, length);
}

// Light that media add and take, lamps that shine on a place in them, and the choice whether the
// path goes on from there.
bool PathTracer::drift(Walk& walk, double depth, std::uint32_t lamps) {
  Path& path = walk.path;
  const Drift drift = media_vary() ? unevenly(path.ray, depth) : evenly(path.ray, depth);
  walk.light += walk.throughput * drift.added;
  const double stays = std::abs(double{grey(drift.kept)});
  const double leaves = std::abs(double{grey(drift.scattered)});
  const bool scatters = leaves > 0 && walk.bounces < rules_.max_bounces;
  const double chance = scatters ? leaves / (leaves + stays) : 0;
  const bool turns = scatters && random_->next() < chance;
  if (scatters) {
    const dvec3 p = path.ray.at(drift.t);
    const vec3 arriving = walk.throughput * drift.scattered;
    // Looking for light needs the list of media for itself.
    const dvec3 on = phase_direction(p, path.ray.d);
    const double density = phase_density(p, glm::dot(path.ray.d, on));
    walk.light += arriving * lamp_light_in_media(p, path.ray.d, lamps, path.inside);
    walk.light += arriving * emitter_light_in_media(p, path.ray.d, path.inside);
    if (turns) {
      walk.throughput = arriving / static_cast<float>(chance);
      walk.clear = 0;
      walk.from = p;
      walk.density = density;
      ++walk.bounces;
      path.ray = {p, on};
      path.reach = no_hit_depth;
      path.bounce = 1;
      return true;
    }
  }
  walk.throughput *= drift.kept / static_cast<float>(1 - chance);
  walk.clear *= grey(drift.kept) / static_cast<float>(1 - chance);
  return false;
}

// As the oracle has it, the phase is the mean over all media, scattering or not.
vec3 PathTracer::lamp_light_in_media(dvec3 p, dvec3 d, std::uint32_t lamps,
                                     const Containment& inside) {
  Draw draw{random_->next()};
  const dvec2 place = random_->next2();
  std::uint32_t chosen = 0;
  LampView seen;
  double phase = 0;
  for (const std::uint32_t i : scene_->geometry.lamp_sets()[lamps]) {
    const Light& light = scene_->lights[i];
    if (light.shadowless || !light.media_interaction || !scene_->reaches[i].contains(p)) continue;
    const LampView lamp = view_lamp(light, incidence(light, p), p, place, false);
    if (dark(lamp.shading.colour)) continue;
    double factor = 0;
    for (const std::uint32_t m : media_) {
      factor += phase_factor(scene_->media[m], glm::dot(d, lamp.shading.l));
    }
    factor /= static_cast<double>(media_.size());
    if (!draw.take(std::abs(double{grey(lamp.shading.colour)} * factor))) continue;
    chosen = i;
    seen = lamp;
    phase = factor;
  }
  if (draw.own == 0) return vec3(0.0F);
  return static_cast<float>(phase) * draw.factor() *
         tracer_.shadowed(scene_->lights[chosen], seen.shadow, p, inside, {.as_point = true});
}

vec3 PathTracer::emitter_light_in_media(dvec3 p, dvec3 d, const Containment& inside) {
  const Aim aim = aim_for_light(p);
  if (!(aim.density > 0)) return vec3(0.0F);
  const double share = phase_density(p, glm::dot(d, aim.d));
  return static_cast<float>(share / (aim.density + share)) * light_along({p, aim.d}, inside);
}

double PathTracer::scattering_size(std::uint32_t media, dvec3 p) const {
  const MediaProgram& m = scene_->media[media];
  if (!m.scatters) return 0;
  return std::abs(double{grey(m.scattering * (m.varies ? scene_->media.density(m, p) : m.density))});
}

// The phases of all media by how much they scatter; it loses nothing and adds nothing. `cosine`: of
// the angle between ways in and out.
double PathTracer::phase_density(dvec3 p, double cosine) const {
  double sum = 0;
  double total = 0;
  for (const std::uint32_t i : media_) {
    const double size = scattering_size(i, p);
    if (size == 0) continue;
    total += size;
    const MediaProgram& m = scene_->media[i];
    sum += size * phase_factor(m, cosine) / mean_phase_factor(m);
  }
  return total > 0 ? sum / total * sphere_density : 0;
}

dvec3 PathTracer::phase_direction(dvec3 p, dvec3 d) {
  Draw draw{random_->next()};
  std::uint32_t chosen = 0;
  for (const std::uint32_t i : media_) {
    if (draw.take(scattering_size(i, p))) chosen = i;
  }
  const double cosine = phase_cosine(scene_->media[chosen], random_->next2());
  return direction_about(d, cosine, 2 * std::numbers::pi * random_->next());
}

}  // namespace durer::tracer

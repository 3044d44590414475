// Light that enters a surface somewhere and comes out where it is seen (participating-and-global §4).
#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <map>
#include <numbers>

#include "tracer/random.h"
#include "tracer/shading/translucent.h"
#include "tracer/transport/trace.h"

namespace durer::tracer {
namespace {

constexpr double pi = std::numbers::pi;

// A turn at random: where all places would err alike, the eye would see it.
glm::dmat3 random_turn(std::uint32_t& random) {
  const double x = 2 * next_random(random) - 1;
  const double phi = 2 * pi * next_random(random);
  const double r = std::sqrt(std::max(0.0, 1 - x * x));
  const dvec3 a(x, r * std::cos(phi), r * std::sin(phi));
  const dvec3 b = glm::normalize(glm::cross(a, std::abs(x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
  return {a, b, glm::cross(a, b)};
}

}  // namespace

// Points of the Halton sequence.
std::vector<dvec3> SubsurfaceProgram::sphere_directions(int count) {
  std::vector<dvec3> all;
  for (std::uint32_t i = 1; i <= static_cast<std::uint32_t>(count); ++i) {
    const double x = 2 * radical_inverse(i, 2) - 1;
    const double phi = 2 * pi * radical_inverse(i, 3);
    const double r = std::sqrt(std::max(0.0, 1 - x * x));
    all.push_back({x, r * std::cos(phi), r * std::sin(phi)});
  }
  return all;
}

void SubsurfaceProgram::add_interiors(std::span<const Interior> interiors) {
  std::map<double, std::uint32_t> known;  // by ior
  for (const Interior& interior : interiors) {
    const auto next = static_cast<std::uint32_t>(tables.size());
    const auto [at, is_new] = known.try_emplace(interior.ior, next);
    if (is_new) tables.emplace_back(interior.ior);
    table_of.push_back(at->second);
  }
}

// A place where light is asked to come from, below or at the surface of one body.
struct Tracer::Body {
  const View& view;
  const Path& path;
  Translucency matter;
  double mm = 1;  // per unit of length
  int samples = 1;
  int single_samples = 1;
  bool indirect = false;  // gathered light enters, too

  [[nodiscard]] double exit_cosine() const { return std::abs(glm::dot(view.d, view.g)); }
};

// True if light goes below this layer.
bool Tracer::is_translucent(const View& view, const Finish& finish) const {
  if (!scene_->subsurface) return false;
  if (view.gathering && !(scene_->radiosity && scene_->radiosity->settings.subsurface)) {
    return false;
  }
  const vec3 t = finish.translucency;
  return t.x > 0 && t.y > 0 && t.z > 0;
}

vec3 Tracer::subsurface(const View& view, const Path& path, const LayerPoint& layer) {
  constexpr int most_levels = 2;  // light from below that is seen in light from below
  if (scratch_->below >= most_levels) return vec3(0.0F);
  const SubsurfaceProgram& program = *scene_->subsurface;
  const bool nested = scratch_->below > 0;
  const Body body{
      view,
      path,
      translucency(layer.pigment * layer.finish->diffuse, layer.finish->translucency,
                   program.albedo(view.interior),
                   fresnel_index(scene_->interiors, view.interior, path.inside)),
      program.mm_per_unit,
      nested ? 1 : program.settings.samples,
      nested ? 1 : program.settings.single_samples,
      program.settings.radiosity};
  ++scratch_->below;
  vec3 seen(diffused(body));
  if (Below below; look_below(body, below)) {
    seen += vec3(scattered_once(body, below));  // one after the other: both draw random numbers
    seen += unscattered(body, below);
  }
  --scratch_->below;
  return layer.opacity * seen;
}

// The surface of the body that a ray inside of it meets.
bool Tracer::reach_surface(const Body& body, const Ray& ray, Hit& hit) {
  ++scratch_->rays;
  return scene_->geometry.closest(ray, 0, no_hit_depth, RayKind::image, hit,
                                  *scratch_->geometry) &&
         hit.interior == body.view.interior;
}

// Light of all lamps that falls onto a place of the surface, each with its cosine.
template <typename Visit>  // visit(light, unit direction to it, cosine)
void Tracer::each_lamp(const Body& body, dvec3 p, dvec3 n, Visit visit) {
  for (const std::uint32_t i : scene_->geometry.lamp_sets()[body.view.lamps]) {
    if (!scene_->reaches[i].contains(p)) continue;
    const Light& light = scene_->lights[i];
    const Incidence in = incidence(light, p);
    const double cosine = glm::dot(n, in.l);
    if (cosine <= 0 || dark(in.colour)) continue;
    const vec3 arriving =
        shadowed(light, in, p, body.path.inside, {body.view.gathering, body.view.collects});
    if (!dark(arriving)) visit(arriving, in.l, cosine);
  }
}

// From a place below the one that is seen, rays go out in all directions: where they end, light may
// have come in that was scattered often.
dvec3 Tracer::diffused(const Body& body) {
  const SubsurfaceProgram& program = *scene_->subsurface;
  const View& view = body.view;
  const double way = 1 / (grey(vec3(body.matter.extinction)) * body.mm);
  double depth = way;
  Hit hit;
  ++scratch_->rays;
  if (scene_->geometry.closest({view.p, -view.g}, t_min, 2 * way, RayKind::image, hit,
                               *scratch_->geometry)) {
    if (hit.interior == view.interior) {
      depth = hit.t / 2;
    } else {
      depth = std::min(depth, hit.t);
    }
  }
  const dvec3 base = view.p - depth * view.g;
  const double out = transmittance(body.matter, body.exit_cosine());
  const glm::dmat3 turn = random_turn(scratch_->noise);
  dvec3 sum(0.0);
  int met = 0;
  for (int i = 0; i < body.samples; ++i) {
    const dvec3 d = turn * program.directions[static_cast<std::size_t>(i)];
    ++scratch_->rays;
    if (!scene_->geometry.closest({base, d}, 0, no_hit_depth, RayKind::image, hit,
                                  *scratch_->geometry)) {
      continue;
    }
    ++met;
    if (hit.interior != view.interior) continue;
    const double towards = glm::dot(hit.n, d);
    const dvec3 n = towards < 0 ? -hit.n : hit.n;
    constexpr double least_cosine = 0.01;
    const double reach = hit.t * body.mm;
    const double area = 4 * pi * reach * reach / std::max(least_cosine, std::abs(towards));
    const dvec3 p = hit.p;
    dvec3 light(0.0);
    each_lamp(body, p, n, [&](vec3 arriving, dvec3, double cosine) {
      light += dvec3(arriving) * cosine * transmittance(body.matter, cosine);
    });
    if (body.indirect) light += entering(body, p, n);
    if (light == dvec3(0.0)) continue;
    sum += area * light * diffuse_transport(body.matter, glm::length(p - view.p) * body.mm);
  }
  return met == 0 ? dvec3(0.0) : out / met * sum;
}

// Gathered light, as if it fell in straight.
dvec3 Tracer::entering(const Body& body, dvec3 p, dvec3 n) {
  if (!scene_->radiosity || body.path.bounce >= scene_->radiosity->bounces.size()) {
    return dvec3(0.0);
  }
  View there = body.view;
  there.p = p;
  there.g = n;
  const vec3 light = indirect(there, n, body.path.weight, body.path.bounce);
  return dvec3(light) * transmittance(body.matter, 1);
}

bool Tracer::look_below(const Body& body, Below& below) {
  const View& view = body.view;
  below.ray.o = view.p;
  if (!refracted(view.d, view.g, 1 / body.matter.eta, below.ray.d)) return false;
  ++scratch_->rays;
  return scene_->geometry.closest(below.ray, t_min, no_hit_depth, RayKind::image, below.end,
                                  *scratch_->geometry);
}

// Where the view is scattered towards a lamp, light of that may have come in. A place serves all
// three colours: each proposes some, in turn, and the others take them by what they are worth.
dvec3 Tracer::scattered_once(const Body& body, const Below& below) {
  const double inner_cosine = std::abs(glm::dot(below.ray.d, body.view.g));
  const SingleDepths depths(body.matter, below.end.t * body.mm);
  const int n = body.single_samples;
  const auto first = static_cast<int>(3 * next_random(scratch_->noise));
  dvec3 sum(0.0);
  for (int i = 0; i < n; ++i) {
    const double way = depths.at((first + i) % 3, (i + next_random(scratch_->noise)) / n);
    const dvec3 light = single_light(body, below.ray.at(way / body.mm), inner_cosine);
    sum += light * depths.weight(way);
  }
  const double out = transmittance(body.matter, body.exit_cosine());
  return out / (4 * n) * body.matter.scattering * sum;
}

// The light that gets straight to a place inside.
dvec3 Tracer::single_light(const Body& body, dvec3 x, double inner_cosine) {
  const dvec3 extinction = body.matter.extinction;
  dvec3 sum(0.0);
  for (const std::uint32_t i : scene_->geometry.lamp_sets()[body.view.lamps]) {
    const Incidence to_lamp = incidence(scene_->lights[i], x);
    if (to_lamp.l == dvec3(0.0) || dark(to_lamp.colour)) continue;
    Hit hit;
    if (!reach_surface(body, {x, to_lamp.l}, hit)) continue;
    const dvec3 p = hit.p;
    const double cosine = glm::dot(hit.n, to_lamp.l);
    const Incidence in = incidence(scene_->lights[i], p);
    if (cosine <= 0 || dark(in.colour)) continue;
    const double eta = body.matter.eta;
    const double bent = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (eta * eta)));
    if (bent <= 0) continue;
    const vec3 arriving = shadowed(scene_->lights[i], in, p, body.path.inside,
                                   {body.view.gathering, body.view.collects});
    if (dark(arriving)) continue;
    const double way = hit.t * body.mm * cosine / bent;
    const double entering = cosine * transmittance(body.matter, cosine) / (1 + inner_cosine / bent);
    sum += entering * dvec3(arriving) / extinction * glm::exp(-way * extinction);
  }
  return sum;
}

// What is seen right through the body, where it is thin.
vec3 Tracer::unscattered(const Body& body, const Below& below) {
  const Hit& end = below.end;
  if (end.interior != body.view.interior) return vec3(0.0F);
  const vec3 kept(glm::exp(-body.matter.extinction * (end.t * body.mm)));
  const float most = std::max({kept.x, kept.y, kept.z});
  if (!(most > limits(body.path).adc)) return vec3(0.0F);
  Path on = body.path;
  on.ray.o = end.p;
  if (!refracted(below.ray.d, end.n, body.matter.eta, on.ray.d)) return vec3(0.0F);
  on.weight *= most;
  return kept * trace(on).colour;
}

}  // namespace durer::tracer

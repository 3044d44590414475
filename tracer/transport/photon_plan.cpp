#include "tracer/transport/photon_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tracer/random.h"

namespace durer::tracer {
namespace {

constexpr double pi = std::numbers::pi;

struct Ball {
  dvec3 centre;
  double radius;
};
Ball ball_around(const Bounds3& box) {
  return {(box.lo + box.hi) / 2.0, glm::length(box.hi - box.lo) / 2};
}

dvec3 turned(dvec3 v, dvec3 axis, double angle) {
  const double c = std::cos(angle);
  return c * v + std::sin(angle) * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis;
}

// How a lamp sees a target; false if neither of them wants photons to go on behind it.
struct Wanted {
  bool refraction;
  bool reflection;
  [[nodiscard]] bool any() const { return refraction || reflection; }
};
Wanted wanted(const Light& light, const PhotonTarget& target) {
  return {agree(light.photons.refraction, target.refraction),
          agree(light.photons.reflection, target.reflection)};
}

// Photons of the pair with a spacing of 1, as far as `count` is concerned.
double estimated_count(const PhotonTarget& target, Wanted w) {
  const double radius = ball_around(target.box).radius / target.density;
  double x = 0.5 * pi * radius * radius;
  const bool both = w.refraction && w.reflection;
  if (both) x *= 1.5;
  if (target.collects && w.refraction) x *= both ? 3 : 2;
  return x;
}

// The pair of one place of a lamp with a target; `share` of its light.
PhotonPair pair_of(const Light& light, dvec3 origin, std::uint32_t index,
                   const PhotonTarget& target, double spacing, double share) {
  const Ball ball = ball_around(target.box);
  PhotonPair pair;
  pair.light = light;
  pair.light.fade_power = 0;
  pair.light.position = origin;
  pair.lamp = &light;
  pair.target = index;
  pair.origin = origin;
  pair.centre = ball.centre;
  pair.colour = light.colour * static_cast<float>(share);
  pair.spread = target.density * spacing / std::sqrt(share);
  if (light.parallel) {
    pair.axis = light.axis;
    // On the plane through the lamp, before the target.
    pair.origin = ball.centre - glm::dot(ball.centre - origin, light.axis) * light.axis;
    pair.step = pair.spread;
    pair.end = ball.radius;
  } else {
    const double distance = glm::length(ball.centre - origin);
    pair.axis = distance > 0 ? (ball.centre - origin) / distance : dvec3(0, 0, 1);
    pair.spread /= std::max(distance, epsilon);
    pair.step = std::atan(pair.spread);
    pair.end = distance > ball.radius ? std::asin(ball.radius / distance) : pi;
  }
  const bool steep = std::abs(std::abs(pair.axis.z) - 1) < 0.1;
  pair.left = glm::normalize(glm::cross(pair.axis, steep ? dvec3(0, 1, 0) : dvec3(0, 0, 1)));
  return pair;
}

template <typename Visit>  // visit(light, target index, target, wanted)
void for_each_pair(const CompiledScene& scene, Visit visit) {
  const auto targets = scene.geometry.photon_targets();
  for (const std::uint32_t l : scene.geometry.lamp_sets()[0]) {
    const Light& light = scene.lights[l];
    if (light.shadowless) continue;
    for (std::uint32_t t = 0; t < targets.size(); ++t) {
      const Wanted w = wanted(light, targets[t]);
      if (w.any() && !targets[t].box.infinite()) visit(light, t, targets[t], w);
    }
  }
}

}  // namespace

int PhotonPair::rings() const { return static_cast<int>(std::ceil(end / step)); }

double PhotonPair::energy(double way) const {
  double area = spread * spread;
  if (!lamp->parallel) area *= way * way;
  if (lamp->fade_power > 0 && std::abs(lamp->fade_distance) > epsilon) {
    area *= 2 / (1 + std::pow(way / lamp->fade_distance, lamp->fade_power));
  }
  return area;
}

std::vector<PhotonPair> plan_photons(const CompiledScene& scene) {
  const scene::Photons& settings = *scene.scene->settings.photons;
  double spacing = settings.spacing;
  if (settings.count > 0) {
    double sum = 0;
    for_each_pair(scene, [&](const Light&, std::uint32_t, const PhotonTarget& target, Wanted w) {
      sum += estimated_count(target, w);
    });
    spacing *= std::sqrt(sum / settings.count);
  }
  std::vector<PhotonPair> pairs;
  for_each_pair(scene, [&](const Light& light, std::uint32_t index, const PhotonTarget& target,
                           Wanted) {
    if (!light.photons.area || !light.has_area) {
      pairs.push_back(pair_of(light, light.position, index, target, spacing, 1));
      return;
    }
    const scene::LightArea& area = light.area;
    const dvec3 l = glm::normalize(light.position - ball_around(target.box).centre);
    for (int v = 0; v < area.n2; ++v) {
      for (int u = 0; u < area.n1; ++u) {
        pairs.push_back(pair_of(light, light.position + area_offset(area, u, v, l), index, target,
                                spacing, 1.0 / (area.n1 * area.n2)));
      }
    }
  });
  return pairs;
}

PhotonRing ring_of(const PhotonPair& pair, int ring, std::uint32_t seed) {
  PhotonRing r;
  r.radius = pair.ring(ring);
  const double across = pair.lamp->parallel ? r.radius : std::sin(r.radius);
  r.step = r.radius < epsilon ? 2 * pi : pair.step / across;
  // Where a turn is no whole number of steps there is a gap, or an overlap: anywhere, and as often
  // the one as the other, so that nothing of it is seen.
  r.first = 2 * pi * next_random(seed);
  r.count = static_cast<int>(2 * pi / r.step + next_random(seed));
  return r;
}

bool emitted(const PhotonPair& pair, const PhotonRing& ring, int i, double jitter,
             std::uint32_t& random, EmittedPhoton& out) {
  const double phi = ring.first + (i + jitter * (next_random(random) - 0.5)) * ring.step;
  const double theta = ring.radius + jitter * (next_random(random) - 0.5) * pair.step;
  if (pair.lamp->parallel) {
    out.ray = {pair.origin + turned(theta * pair.left, pair.axis, phi), pair.axis};
  } else {
    const dvec3 d = std::cos(theta) * pair.axis - std::sin(theta) * pair.left;
    out.ray = {pair.origin, glm::normalize(turned(d, pair.axis, phi))};
  }
  constexpr double least = 1e-5;
  const double a = attenuation(pair.light, {-out.ray.d, 1, vec3(0.0F)}, out.ray.at(1));
  if (a < least) return false;
  out.colour = pair.colour * static_cast<float>(a);
  return true;
}

}  // namespace durer::tracer

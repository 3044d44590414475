#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/shading/atmosphere.h"

namespace durer::tracer {
namespace {

// Mean of the density 1/(1 + h²) of ground fog, 1 below the ground, between two heights.
double mean_density(double from, double to) {
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  if (high <= 0) return 1;
  if (low <= 0) return (std::atan(high) - low) / (high - low);
  if (high - low > epsilon) return (std::atan(high) - std::atan(low)) / (high - low);
  return 1 / (low * low + 1);
}

}  // namespace

Fog::Fog(const scene::Fog& in, functions::NoiseGenerator generator)
    : kind(in.kind),
      distance(in.distance),
      colour(in.colour),
      offset(in.offset),
      alt(in.alt),
      up(in.up),
      turbulent(in.turbulent),
      turbulence(in.turbulence),
      turb_depth(in.turb_depth),
      octaves{in.octaves, in.omega, in.lambda},
      noise_generator(generator) {}

double Fog::clarity(const Ray& ray, double depth) const {
  double x = depth;
  if (turbulent) {
    constexpr double nothing = 1e-30;  // of which any multiple that there is leaves 1 as it is
    const double share = std::exp(-depth / distance);
    if (share > nothing) {
      const dvec3 middle = turbulence * ray.at(depth / 2);
      const double stirred = functions::turbulence(middle, octaves, noise_generator) * turb_depth;
      x *= 1 - share * std::min(1.0, stirred);
    }
  }
  if (kind == scene::Fog::Kind::ground) {
    const auto height = [&](double t) { return (glm::dot(ray.at(t), up) - offset) / alt; };
    x *= mean_density(height(0), height(depth));
  }
  return std::max(std::exp(-x / distance), static_cast<double>(colour.transmit));
}

Veil Atmosphere::fog(const Ray& ray, double depth) const {
  Veil veil;
  for (const Fog& f : fogs_) {
    const double a = f.clarity(ray, depth);
    veil.through *= f.tint(a);
    veil.glow += static_cast<float>(1 - a) * f.colour.rgb;  // not dimmed by the others
  }
  veil.transmittance = grey(veil.through);
  return veil;
}

vec3 Atmosphere::fog_shadow(const Ray& ray, double depth) const {
  vec3 through(1.0F);
  for (const Fog& f : fogs_) through *= f.tint(f.clarity(ray, depth));
  return through;
}

}  // namespace durer::tracer

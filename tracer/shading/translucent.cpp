#include "tracer/shading/translucent.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <numbers>

#include "tracer/shading/finish.h"

namespace durer::tracer {
namespace {

double boundary_of(double fresnel) { return (1 + fresnel) / (1 - fresnel); }

// What matter of an albedo reflects.
double reflected(double albedo, double boundary) {
  const double q = std::sqrt(3 * (1 - albedo));
  return albedo / 2 * (1 + std::exp(-4.0 / 3 * boundary * q)) * std::exp(-q);
}

double albedo_of(double colour, double boundary) {
  if (colour <= 0) return 0;
  if (colour >= 1) return 1;
  double lo = 0;
  double hi = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = (lo + hi) / 2;
    (reflected(middle, boundary) < colour ? lo : hi) = middle;
  }
  return (lo + hi) / 2;
}

}  // namespace

double diffuse_fresnel(double eta) {
  if (eta < 1) return eta * eta - std::pow(eta, 2.25);
  const double x = 1 - 1 / eta;
  return (x + 3 * std::pow(x, 4.5)) / 4;
}

// The oracle knows hundredths, and goes straight between them.
double reduced_albedo(double colour, double boundary) {
  constexpr double steps = 100;
  const double at = std::clamp(colour, 0.0, 1.0) * steps;
  const double below = std::min(std::floor(at), steps - 1);
  const double lo = albedo_of(below / steps, boundary);
  const double hi = albedo_of((below + 1) / steps, boundary);
  return lo + (at - below) * (hi - lo);
}

Translucency translucency(vec3 colour, vec3 mean_way, double ior, double eta) {
  Translucency t;
  t.eta = eta;
  t.boundary = boundary_of(diffuse_fresnel(eta));
  const double inner = boundary_of(diffuse_fresnel(ior));
  constexpr double least_albedo = 1e-6;  // of black matter, which only absorbs
  for (int i = 0; i < 3; ++i) {
    const double albedo = std::max(least_albedo, reduced_albedo(colour[i], inner));
    t.scattering[i] = 1.0 / mean_way[i];
    t.extinction[i] = t.scattering[i] / albedo;
    const double absorption = t.extinction[i] - t.scattering[i];
    t.effective[i] = std::sqrt(3 * absorption * t.extinction[i]);
  }
  return t;
}

// Two sources stand for the light: one below the surface, one above that takes some of it back.
dvec3 diffuse_transport(const Translucency& t, double distance) {
  const dvec3 below = 1.0 / t.extinction;
  const dvec3 above = below * (1 + 4.0 / 3 * t.boundary);
  const auto part = [&](dvec3 z) {
    const dvec3 d = glm::sqrt(z * z + distance * distance);
    return z * (t.effective + 1.0 / d) * glm::exp(-t.effective * d) / (d * d);
  };
  return t.scattering / t.extinction / (4 * std::numbers::pi) * (part(below) + part(above));
}

double transmittance(const Translucency& t, double cosine) {
  return 1 - fresnel_reflectance(std::abs(cosine), t.eta);
}

}  // namespace durer::tracer

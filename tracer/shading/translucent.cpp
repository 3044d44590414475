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

AlbedoTable::AlbedoTable(double ior) {
  const double boundary = boundary_of(diffuse_fresnel(ior));
  for (std::size_t i = 0; i <= steps; ++i) albedo_[i] = albedo_of(double(i) / steps, boundary);
}

double AlbedoTable::operator()(double colour) const {
  const double at = std::clamp(colour, 0.0, 1.0) * steps;
  const auto below = std::min(static_cast<std::size_t>(at), steps - 1);
  return albedo_[below] + (at - double(below)) * (albedo_[below + 1] - albedo_[below]);
}

Translucency translucency(vec3 colour, vec3 mean_way, const AlbedoTable& table, double eta) {
  Translucency t;
  t.eta = eta;
  t.boundary = boundary_of(diffuse_fresnel(eta));
  constexpr double least_albedo = 1e-6;  // of black matter, which only absorbs
  for (int i = 0; i < 3; ++i) {
    const double albedo = std::max(least_albedo, table(colour[i]));
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

SingleDepths::SingleDepths(const Translucency& matter, double length)
    : extinction_(matter.extinction) {
  for (int i = 0; i < 3; ++i) share_[i] = -std::expm1(-2 * extinction_[i] * length);
}

double SingleDepths::at(int component, double u) const {
  return -std::log1p(-u * share_[component]) / (2 * extinction_[component]);
}

dvec3 SingleDepths::weight(double depth) const {
  const dvec3 kept = glm::exp(-2 * depth * extinction_);
  const dvec3 density = 2.0 * extinction_ * kept / share_;
  return extinction_ * kept * (3 / (density.x + density.y + density.z));
}

double transmittance(const Translucency& t, double cosine) {
  return 1 - fresnel_reflectance(std::abs(cosine), t.eta);
}

}  // namespace durer::tracer

#include "tracer/shading/finish.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace durer::tracer {
namespace {

float greatest(vec3 c) { return std::max({c.x, c.y, c.z}); }

// Where a power of the cosine falls below what any picture can show.
double least_cosine(double exponent) {
  constexpr double unseen = 1e-9;
  return exponent > 0 ? std::pow(unseen, 1 / exponent) : 0;
}

vec3 blend(const Finish& f, double share) {
  if (std::abs(share) < epsilon) return f.reflection_min;
  if (std::abs(share - 1) < epsilon) return f.reflection_max;
  return static_cast<float>(share) * f.reflection_max +
         static_cast<float>(1 - share) * f.reflection_min;
}

}  // namespace

vec3 metal_tint(float metallic, double cosine, vec3 pigment) {
  const double x = std::abs(std::acos(std::clamp(cosine, -1.0, 1.0))) / (std::numbers::pi / 2);
  const double u = x - 1.12;
  const double phi = std::clamp(0.014567225 / (u * u) - 0.011612903, 0.0, 1.0);
  return 1.0F + static_cast<float>(metallic * (1 - phi)) * (pigment - 1.0F);
}

double fresnel_reflectance(double cosi, double n) {
  const double g2 = n * n + cosi * cosi - 1;
  if (g2 <= 0) return 1;
  const double g = std::sqrt(g2);
  const double a = (g - cosi) / (g + cosi);
  const double b = (cosi * (g + cosi) - 1) / (cosi * (g - cosi) + 1);
  return std::clamp(0.5 * a * a * (1 + b * b), 0.0, 1.0);
}

Finish compile_finish(const scene::Finish& in, vec3 ambient_light, vec3 irid_wavelength,
                      functions::NoiseGenerator noise_generator) {
  Finish f;
  f.glow_pigment = in.ambient * ambient_light + in.emission;
  f.reflection_min = in.reflection_min;
  f.reflection_max = in.reflection_max;
  f.diffuse = in.diffuse;
  f.diffuse_back = in.diffuse_back;
  f.indirect = in.indirect;
  f.indirect_back = in.indirect_back;
  f.brilliance = in.brilliance;
  f.phong = in.phong;
  f.phong_size = in.phong_size;
  f.specular = in.specular;
  f.specular_exponent = in.roughness == 0 ? 0 : 1 / in.roughness;
  f.least_phong = least_cosine(f.phong_size);
  f.least_specular = least_cosine(f.specular_exponent);
  f.metallic = in.metallic;
  f.crand = in.crand;
  f.reflection_falloff = in.reflection_falloff;
  f.reflection_power = 1 / in.reflection_exponent;
  f.reflection_metallic = in.reflection_metallic;
  f.irid = in.irid;
  f.irid_thickness = in.irid_thickness;
  f.irid_turbulence = in.irid_turbulence;
  f.irid_wavelength = irid_wavelength;
  f.noise_generator = noise_generator;
  if (in.subsurface) f.translucency = in.translucency;
  f.fresnel = in.fresnel;
  f.conserve_energy = in.conserve_energy;
  f.highlights = in.phong != 0 || in.specular != 0;
  f.lit = f.highlights || in.diffuse != 0 || in.diffuse_back != 0;
  f.reflects = in.reflection_min != vec3(0.0F) || in.reflection_max != vec3(0.0F);
  return f;
}

Reflectivity reflectivity(const Finish& f, double cosi, double relative_ior, vec3 pigment) {
  Reflectivity r;
  if (f.fresnel) {
    r.rho = blend(f, fresnel_reflectance(cosi, relative_ior));
    r.weight = greatest(r.rho);
  } else {
    const double away = 1 - cosi;
    r.rho = blend(f, f.reflection_falloff == 1 ? away : std::pow(away, f.reflection_falloff));
    r.weight = std::max(greatest(f.reflection_max), greatest(f.reflection_min));
  }
  if (f.reflection_metallic != 0) {
    r.rho *= metal_tint(f.reflection_metallic, cosi, pigment);
  }
  return r;
}

vec3 highlight(const Finish& f, const dvec3& d, const dvec3& n, const dvec3& l, vec3 pigment) {
  double sum = 0;
  if (f.phong > 0) {
    const dvec3 mirrored = d - 2 * glm::dot(d, n) * n;
    const double s = glm::dot(mirrored, l);
    if (s > f.least_phong && (f.phong_size < 60 || s > 0.0008)) {
      sum += f.phong * f.phong_size.of(s);
    }
  }
  if (f.specular > 0) {
    const dvec3 half = (l - d) / 2.0;
    const double along = glm::dot(half, n);
    const double square = glm::dot(half, half);
    const double least = f.least_specular * (1 - highlight_rounding);
    if (along > 0 && along * along > least * least * square) {
      const double s = along / std::sqrt(square);
      if (s > f.least_specular) sum += f.specular * f.specular_exponent.of(s);
    }
  }
  if (sum == 0) return vec3(0.0F);
  const vec3 white(static_cast<float>(sum));
  return f.metallic > 0 ? white * metal_tint(f.metallic, glm::dot(n, l), pigment) : white;
}

vec3 iridescence(const Finish& f, dvec3 p, double cos_light, double cos_view) {
  double thickness = f.irid_thickness;
  if (f.irid_turbulence != 0) {
    constexpr functions::Octaves octaves{5, 0.5, 2};
    const double stirred = functions::turbulence(p, octaves, f.noise_generator);
    thickness *= 1 + f.irid_turbulence * (2 * stirred - 1);
  }
  const double path = 2 * std::numbers::pi * thickness * (std::abs(cos_light) + std::abs(cos_view));
  vec3 c;
  for (int i = 0; i < 3; ++i) {
    c[i] = 1 + f.irid * static_cast<float>(std::cos(path / f.irid_wavelength[i]));
  }
  return c;
}

}  // namespace durer::tracer

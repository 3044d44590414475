// The surface model: what a layer adds to light, as formulas (shading §4).
#pragma once

#include "base/vec.h"
#include "functions/noise.h"
#include "scene/texture.h"
#include "tracer/shading/power.h"

namespace durer::tracer {

/// A finish with everything worked out that does not depend on the point.
struct Finish {
  vec3 glow_pigment{0.0F};  // ambient·ambient_light + emission, times pigment and opacity
  vec3 reflection_min{0.0F};
  vec3 reflection_max{0.0F};
  float diffuse = 0;
  float diffuse_back = 0;
  float indirect = 0;  // shares of gathered light
  float indirect_back = 0;
  Exponent brilliance = 1;
  float phong = 0;
  Exponent phong_size = 40;
  float specular = 0;
  Exponent specular_exponent = 20;
  // Cosines below which highlights are too weak to be worth a power.
  double least_phong = 0;
  double least_specular = 0;
  float metallic = 0;
  float crand = 0;
  float reflection_falloff = 1;
  float reflection_power = 1;  // reflected light is raised to this
  float reflection_metallic = 0;
  float irid = 0;
  float irid_thickness = 0;
  float irid_turbulence = 0;
  functions::NoiseGenerator noise_generator = 2;  // of the turbulence
  vec3 irid_wavelength{1.0F};
  vec3 translucency{0.0F};  // mm; 0: light comes out where it falls in
  bool fresnel = false;
  bool conserve_energy = false;
  bool lit = true;          // some term needs lights
  bool highlights = false;  // phong or specular
  bool reflects = false;
};

[[nodiscard]] Finish compile_finish(const scene::Finish& finish, vec3 ambient_light,
                                    vec3 irid_wavelength,
                                    functions::NoiseGenerator noise_generator = 2);

/// How much a surface reflects, per component, and how much that counts for the trace limits.
struct Reflectivity {
  vec3 rho{0.0F};
  float weight = 0;
};

/// `cosi`: cosine between the normal and the way back along the ray. `relative_ior`: n behind over
/// n before the surface, used by fresnel finishes only (shading §4.8).
[[nodiscard]] Reflectivity reflectivity(const Finish& finish, double cosi, double relative_ior,
                                        vec3 pigment);

/// Unpolarised reflectance of a dielectric; 1 beyond the critical angle. `n`: behind over before.
[[nodiscard]] double fresnel_reflectance(double cosine, double n);

/// How far a metal's colour shows at an angle: towards grazing it turns white (shading §4.5).
[[nodiscard]] vec3 metal_tint(float metallic, double cosine, vec3 pigment);

/// Most highlights are too weak; squares of cosines tell it without a root, but for rounding.
inline constexpr double highlight_rounding = 1e-12;

/// Phong and specular light of one lamp, without the lamp's colour; per component because metals
/// tint it. `d`: view direction, `l`: to the light, both of unit length (shading §4.5).
[[nodiscard]] vec3 highlight(const Finish& finish, const dvec3& d, const dvec3& n, const dvec3& l,
                             vec3 pigment);

/// Thin-film interference at the world point `p`, for the two angles' cosines (shading §4.6).
[[nodiscard]] vec3 iridescence(const Finish& finish, dvec3 p, double cos_light, double cos_view);

}  // namespace durer::tracer

// Light below a translucent surface, as formulas (participating-and-global §4; Jensen, Marschner,
// Levoy, Hanrahan: "A Practical Model for Subsurface Light Transport", 2001).
#pragma once

#include <array>
#include <cstddef>

#include "base/vec.h"

namespace durer::tracer {

/// The share of light that single events of scattering keep, such that matter reflects a colour.
class AlbedoTable {
 public:
  /// `ior`: of the matter.
  explicit AlbedoTable(double ior);
  /// `colour`: 0…1, or what is nearest.
  [[nodiscard]] double operator()(double colour) const;

 private:
  // For hundredths of the colour, as the oracle has it, and straight between them.
  static constexpr std::size_t steps = 100;
  std::array<double, steps + 1> albedo_;
};

/// How matter scatters and absorbs light, by component. Per mm.
struct Translucency {
  dvec3 scattering{0.0};  // reduced: as if in all directions alike
  dvec3 extinction{0.0};  // reduced; of scattering and absorption together
  dvec3 effective{0.0};   // of light that has been scattered often
  double eta = 1;         // index of refraction behind the surface over that before
  double boundary = 1;    // how much the surface reflects back inside
};

/// `colour`: what the surface reflects of light that falls in, 0…1. `mean_way`: in mm, positive.
[[nodiscard]] Translucency translucency(vec3 colour, vec3 mean_way, const AlbedoTable& albedo,
                                        double eta);

/// Light that comes out `distance` mm from where a narrow beam of it went in; per mm² of surface. Without
/// the transmission of the surface at both places.
[[nodiscard]] dvec3 diffuse_transport(const Translucency& matter, double distance);

/// Share of light that passes the surface at an angle, either way.
[[nodiscard]] double transmittance(const Translucency& matter, double cosine);

/// Share of light of all directions that is reflected back inside at a surface.
[[nodiscard]] double diffuse_fresnel(double eta);

}  // namespace durer::tracer

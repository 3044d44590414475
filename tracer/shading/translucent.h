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

/// Depths, along the view below a surface, where light may have been scattered once: random ones,
/// dense where much of it comes from. Light is dimmed on its way out, and counts as dimmed once more
/// (as the oracle has it), so they thin out by the square of that.
class SingleDepths {
 public:
  /// `length`: in mm, positive.
  SingleDepths(const Translucency& matter, double length);
  /// In mm, as one component would have it. `u`: random, 0…1.
  [[nodiscard]] double at(int component, double u) const;
  /// What light at a depth is worth, by component, where components propose equally many depths.
  [[nodiscard]] dvec3 weight(double depth) const;

 private:
  dvec3 extinction_;
  dvec3 share_;  // of an endless ray's depths, those that are below `length`
};

/// Share of light that passes the surface at an angle, either way.
[[nodiscard]] double transmittance(const Translucency& matter, double cosine);

/// Share of light of all directions that is reflected back inside at a surface.
[[nodiscard]] double diffuse_fresnel(double eta);

}  // namespace durer::tracer

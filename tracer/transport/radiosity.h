// Indirect diffuse light: what a bounce may do, and what a thread knows of it
// (participating-and-global §2).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "tracer/transport/irradiance_cache.h"

namespace durer::tracer {

/// The rules of one bounce (participating-and-global §2.9).
struct Bounce {
  int rays = 0;             // to gather light with
  double needed = 0;        // samples that make gathering superfluous
  double error_factor = 1;  // 2^depth
  int first_level = 0;      // trace level that its gather rays begin with …
  int max_level = 0;        // … and end at
  float weight = 0;         // of its gather rays
};

/// Radiosity of a scene, compiled. Immutable.
struct RadiosityProgram {
  explicit RadiosityProgram(const scene::Scene& scene);

  scene::Radiosity settings;
  dvec3 camera{0.0};              // location
  std::vector<dvec3> directions;  // about +y, cosine-weighted
  std::vector<Bounce> bounces;    // by depth

  /// `brightness` and `gray_threshold`.
  [[nodiscard]] vec3 finished(dvec3 light) const;
  /// Distance up to which a sample is worth being found: that of queries whose result matters.
  [[nodiscard]] double reach(const IrradianceSample& sample) const;
};

/// The direction pool: `count` points of the Halton sequence on the hemisphere about +y.
[[nodiscard]] std::vector<dvec3> cosine_directions(int count);

/// Turns what is about +y so that it is about the unit vector `n`.
class Hemisphere {
 public:
  explicit Hemisphere(dvec3 n);
  [[nodiscard]] dvec3 direction(dvec3 d) const { return d.x * x_ + d.y * y_ + d.z * z_; }

 private:
  dvec3 x_, y_, z_;
};

/// Radiosity as one thread sees it while it works on one block of the picture. Other blocks cannot
/// be seen, so that no picture depends on who was faster.
struct RadiosityState {
  const IrradianceCache* known = nullptr;  // of all blocks, from earlier passes
  IrradianceCache fresh;                   // of this block, from this pass
  bool final_pass = true;
  std::array<std::uint32_t, IrradianceCache::max_depth + 1> next_direction{};
  double ray_quality = 1;  // lowest quality of a query along the present gather ray
  // Queries of surfaces that the camera sees.
  double top_weight = 0;
  std::uint32_t top_queries = 0;

  /// Forgets the last block. `seed` tells blocks and passes apart.
  void begin(const IrradianceCache* all, bool final, std::uint32_t seed, std::uint32_t pool);
};

}  // namespace durer::tracer

// Which photons are shot from where to where (participating-and-global §3.3, §3.4).
#pragma once

#include <cstdint>
#include <vector>

#include "base/ray.h"
#include "tracer/compiled_scene.h"

namespace durer::tracer {

/// Photons that one lamp, or one place of its area, sends to one target: rings around the line to
/// the target's middle, equally far apart.
struct PhotonPair {
  Light light;                // without fading, which depends on the whole way
  const Light* lamp = nullptr;  // as it is in the scene
  std::uint32_t target = 0;
  dvec3 origin{0.0};
  dvec3 centre{0.0};  // of the target
  dvec3 axis{0.0};    // unit, towards it; of parallel light: along that
  dvec3 left{0.0};    // unit, at right angles to the axis
  double spread = 0;  // distance of photons: tangent of an angle, or a length for parallel light
  double step = 0;    // of the rings, and along them: radians, or that length
  double end = 0;     // where rings end: likewise
  vec3 colour{0.0F};  // of one photon, before attenuation

  [[nodiscard]] int rings() const;
  [[nodiscard]] double ring(int i) const { return i * step; }
  /// Energy of a photon that has come so far: what it stands for on a surface across its way, and
  /// how the lamp fades.
  [[nodiscard]] double energy(double way) const;
};

/// A photon as it leaves the lamp.
struct EmittedPhoton {
  Ray ray;
  vec3 colour{0.0F};
};

/// All pairs of a scene, with the spacing that its settings ask for.
[[nodiscard]] std::vector<PhotonPair> plan_photons(const CompiledScene& scene);

/// Photons on a ring: how many there are, and where the first one is. Random, but always the same.
struct PhotonRing {
  int count = 0;
  double first = 0;  // radians
  double step = 0;
  double radius = 0;  // as PhotonPair::step
};
[[nodiscard]] PhotonRing ring_of(const PhotonPair& pair, int ring, std::uint32_t seed);

/// Photon number `i` of a ring; false if the lamp sends nothing there. Draws from `random`.
[[nodiscard]] bool emitted(const PhotonPair& pair, const PhotonRing& ring, int i, double jitter,
                           std::uint32_t& random, EmittedPhoton& out);

}  // namespace durer::tracer

// What objects and lamps tell of photons, as the tracer wants to know it (participating-and-global
// §3.2).
#pragma once

#include <cstdint>
#include <optional>

#include "base/bounds.h"
#include "scene/texture.h"

namespace durer::tracer {

/// What a surface does with photons.
struct PhotonTraits {
  std::uint32_t target = scene::none;  // index into Geometry::photon_targets()
  std::optional<bool> refraction;
  std::optional<bool> reflection;
  std::optional<bool> collect;
  bool pass_through = false;

  [[nodiscard]] bool collects() const { return collect != false; }

  friend bool operator==(const PhotonTraits&, const PhotonTraits&) = default;
};

/// An object that photons are sent to.
struct PhotonTarget {
  double density = 1;  // photons are so many times as far apart
  std::optional<bool> refraction;
  std::optional<bool> reflection;
  bool collects = true;
  Bounds3 box;  // world
};

/// A lamp and an object bend or mirror photons together: one wants it, and the other does not object.
[[nodiscard]] inline bool agree(std::optional<bool> a, std::optional<bool> b) {
  return (a == true || b == true) && a != false && b != false;
}

}  // namespace durer::tracer

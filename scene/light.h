// Light sources as plain data (shading §6).
#pragma once

#include <cstdint>
#include <vector>

#include "base/boxed.h"
#include "base/vec.h"
#include "scene/origin.h"
#include "scene/pattern.h"
#include "scene/photons.h"

namespace durer::scene {

/// A lamp of some extent: a grid of n1 x n2 samples, `u` and `v` from edge to edge.
struct LightArea {
  dvec3 u{0.0};
  dvec3 v{0.0};
  int n1 = 1;
  int n2 = 1;
  int adaptive = 100;  // levels of subdivision that are always made
  bool jitter = false;
  bool circular = false;
  bool orient = false;        // turned towards every point that it lights
  bool illumination = false;  // highlights and shades see the whole area, not only its centre
};

/// Position and colour of light. World space once the transforms of the objects that hold it are
/// applied; angles in degrees.
struct Light {
  enum class Kind : std::uint8_t { point, spotlight, cylinder };
  Kind kind = Kind::point;
  dvec3 position{0.0};
  vec3 colour{0.0F};
  bool parallel = false;
  bool shadowless = false;
  dvec3 point_at{0, 0, 1};
  double radius_deg = 30;   // full intensity inside; cylinder: a length
  double falloff_deg = 45;  // nothing outside; likewise
  double tightness = 0;
  double fade_distance = 0;  // 0: off
  double fade_power = 0;
  bool media_interaction = true;   // media scatter it
  bool media_attenuation = false;  // fog and atmospheric media weaken it
  bool has_area = false;
  LightArea area;
  /// ObjectId, in the space of the light: only what shines through this one gets on.
  std::uint32_t projected_through = none;
  LightPhotons photons;
  OriginId origin = 0;
};

}  // namespace durer::scene

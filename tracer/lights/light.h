// Lamps: where their light comes from and how much of it arrives (shading §6.1-6.3).
#pragma once

#include "base/vec.h"
#include "scene/scene.h"

namespace durer::tracer {

/// A lamp with everything worked out that does not depend on the lit point. World space.
struct Light {
  dvec3 position{0.0};
  dvec3 axis{0, 0, 1};  // unit, from position to point_at
  vec3 colour{0.0F};
  bool spot = false;
  bool parallel = false;
  bool shadowless = false;
  double cos_radius = 0;
  double cos_falloff = 0;
  double tightness = 0;
  double fade_distance = 0;
  double fade_power = 0;
  bool media_interaction = true;
  bool media_attenuation = false;
};

[[nodiscard]] Light compile_light(const scene::Light& light);

/// One lamp as seen from a point.
struct Incidence {
  dvec3 l{0.0};         // unit, towards the lamp
  double distance = 0;  // world units; <= 0 behind a parallel lamp: lit, without shadows
  vec3 colour{0.0F};    // after attenuation, before shadows
};

[[nodiscard]] Incidence incidence(const Light& light, dvec3 p);

/// True if a colour is too dark to matter: every component below epsilon in size.
[[nodiscard]] inline bool dark(vec3 c) {
  constexpr auto e = static_cast<float>(epsilon);
  return c.x < e && c.x > -e && c.y < e && c.y > -e && c.z < e && c.z > -e;
}

}  // namespace durer::tracer

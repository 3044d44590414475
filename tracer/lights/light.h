// Lamps: where their light comes from and how much of it arrives (shading §6.1-6.3).
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/vec.h"
#include "scene/light.h"

namespace durer::tracer {

/// A lamp with everything worked out that does not depend on the lit point. World space.
struct Light {
  scene::Light::Kind kind = scene::Light::Kind::point;
  dvec3 position{0.0};
  dvec3 point_at{0, 0, 1};
  dvec3 axis{0, 0, 1};  // unit, from position to point_at
  vec3 colour{0.0F};
  bool parallel = false;
  bool shadowless = false;
  bool dimmed_by_air = false;  // fog and atmospheric media weaken it
  bool has_area = false;
  bool weakened = false;  // by a cone, a beam or fading
  bool plain = false;     // a point that casts shadows, with nothing to shine through
  double radius = 0;   // spotlight: cosine of the angle; cylinder: a length
  double falloff = 0;  // likewise
  double tightness = 0;
  double fade_distance = 0;
  double fade_power = 0;
  scene::LightArea area;
  std::uint32_t projector = scene::none;  // index into CompiledScene::projectors
  bool media_interaction = true;
  scene::LightPhotons photons;
};

/// `areas`: lamps of some extent are such; else they are points.
[[nodiscard]] Light compile_light(const scene::Light& light, bool areas = true);

/// One lamp as seen from a point.
struct Incidence {
  dvec3 l{0.0};         // unit, towards the lamp
  double distance = 0;  // world units; <= 0 behind a parallel lamp: lit, without shadows
  vec3 colour{0.0F};    // after attenuation, before shadows
};

/// Where a lamp at `position` shines to; unit.
[[nodiscard]] dvec3 axis_from(const Light& light, dvec3 position);
/// The same as `incidence` for one sample of a lamp's area, `offset` from its centre. Without colour.
[[nodiscard]] inline Incidence direction_to(const Light& light, dvec3 offset, dvec3 p) {
  Incidence in;
  const dvec3 position = light.position + offset;
  const dvec3 way = position - p;
  in.distance = glm::length(way);
  if (in.distance == 0) return in;  // the lamp itself: no direction, no light
  in.l = way / in.distance;
  if (light.parallel) {
    const dvec3 axis = light.has_area ? axis_from(light, position) : light.axis;
    in.distance *= -glm::dot(axis, in.l);
    in.l = -axis;
  }
  return in;
}
/// Share of the colour that arrives at `p`, before shadows: cones and fading.
[[nodiscard]] double attenuation(const Light& light, const Incidence& in, dvec3 p);
/// A lamp, or the centre of one, from `p`.
[[nodiscard]] inline Incidence incidence(const Light& light, const dvec3& p) {
  Incidence in = direction_to(light, dvec3(0.0), p);
  if (in.l == dvec3(0.0)) return in;
  in.colour = light.colour;
  if (light.weakened) {
    const Incidence kept = in;  // `in` itself may stay in registers
    in.colour *= static_cast<float>(attenuation(light, kept, p));
  }
  return in;
}

/// A lamp's grid of samples, as one lit point sees it.
struct AreaGrid {
  /// `l`: unit, from the lit point to the lamp's centre.
  AreaGrid(const scene::LightArea& area, dvec3 l);

  /// Where sample (u, v) is, as shares of the edges from the centre. `u` and `v` need not be whole:
  /// jitter moves them by up to half.
  [[nodiscard]] dvec2 place(double u, double v) const {
    double a = along(u, area->n1);
    double b = along(v, area->n2);
    if (area->circular) {
      // Squares become circles. The middle is moved a little, where there is no direction.
      a += 0.001;
      b += 0.001;
      const double scale = std::max(std::abs(a), std::abs(b)) / std::sqrt(a * a + b * b);
      a *= scale;
      b *= scale;
    }
    return {a, b};
  }
  [[nodiscard]] dvec3 offset(dvec2 place) const { return place.x * u_axis + place.y * v_axis; }
  /// Bounds of the places that samples can have, to either side.
  [[nodiscard]] dvec2 reach() const;

  const scene::LightArea* area;
  dvec3 u_axis;  // the edges
  dvec3 v_axis;

 private:
  // -1/2…1/2 along one side; a single sample is in the middle.
  [[nodiscard]] static double along(double index, int samples) {
    return samples > 1 ? index / (samples - 1) - 0.5 : 0;
  }
};

/// Where sample (u, v) of a lamp's grid is, from its centre.
[[nodiscard]] inline dvec3 area_offset(const scene::LightArea& area, double u, double v, dvec3 l) {
  const AreaGrid grid(area, l);
  return grid.offset(grid.place(u, v));
}

/// Which points a lamp can reach at all: a cone, or everything. Small, because scenes of many lamps
/// ask all of them at every point.
struct Reach {
  dvec3 position{0.0};
  dvec3 axis{0.0};      // unit
  double cosine2 = 0;   // square of the cosine of the widest angle
  bool bounded = false;

  /// False only if no light gets to `p`.
  [[nodiscard]] bool contains(dvec3 p) const {
    if (!bounded) return true;
    const dvec3 way = p - position;
    const double along = way.x * axis.x + way.y * axis.y + way.z * axis.z;
    return along > 0 &&
           along * along >= cosine2 * (way.x * way.x + way.y * way.y + way.z * way.z);
  }
};
[[nodiscard]] Reach reach_of(const Light& light);

/// True if a colour is too dark to matter: every component below epsilon in size.
[[nodiscard]] inline bool dark(vec3 c) {
  constexpr auto e = static_cast<float>(epsilon);
  return c.x < e && c.x > -e && c.y < e && c.y > -e && c.z < e && c.z > -e;
}

}  // namespace durer::tracer

// The solid that limits a surface of functions: where a line enters and leaves it.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "base/ray.h"
#include "scene/function_surface.h"

namespace durer::tracer {

/// Part 0 of a function's surface is the surface itself; 1 to 6 are the faces -x +x -y +y -z +z of a
/// box around it, 7 is the sphere around it.
inline constexpr std::uint32_t sphere_part = 7;

/// A stretch of a line inside a container, and the faces at its ends.
struct Stretch {
  double from;
  double to;
  std::uint32_t face_from;
  std::uint32_t face_to;
};

[[nodiscard]] inline std::optional<Stretch> stretch_in_box(const dvec3& lo, const dvec3& hi,
                                                           const Ray& ray) {
  Stretch s{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0,
            0};
  for (int k = 0; k < 3; ++k) {
    if (ray.d[k] == 0) {
      if (!(ray.o[k] >= lo[k] && ray.o[k] <= hi[k])) return std::nullopt;
      continue;
    }
    const bool rising = ray.d[k] > 0;
    const double near = ((rising ? lo[k] : hi[k]) - ray.o[k]) / ray.d[k];
    const double far = ((rising ? hi[k] : lo[k]) - ray.o[k]) / ray.d[k];
    const auto face = static_cast<std::uint32_t>(2 * k + 1);
    if (near > s.from) s.from = near, s.face_from = face + (rising ? 0 : 1);
    if (far < s.to) s.to = far, s.face_to = face + (rising ? 1 : 0);
  }
  if (!(s.from < s.to) || !std::isfinite(s.from)) return std::nullopt;
  return s;
}

[[nodiscard]] inline std::optional<Stretch> stretch_in_sphere(const dvec3& centre, double radius,
                                                              const Ray& ray) {
  const double d2 = glm::dot(ray.d, ray.d);
  const double middle = glm::dot(centre - ray.o, ray.d) / d2;
  const dvec3 miss = ray.at(middle) - centre;
  const double h2 = radius * radius - glm::dot(miss, miss);
  if (!(h2 > 0)) return std::nullopt;
  const double half = std::sqrt(h2 / d2);
  return Stretch{middle - half, middle + half, sphere_part, sphere_part};
}

/// The part of the line inside the container; none for lines that miss or make no sense.
[[nodiscard]] inline std::optional<Stretch> stretch_in(const scene::Container& c, const Ray& ray) {
  return c.kind == scene::Container::Kind::box ? stretch_in_box(c.lo, c.hi, ray)
                                               : stretch_in_sphere(c.centre, c.radius, ray);
}

[[nodiscard]] inline bool contains(const scene::Container& c, const dvec3& p) {
  if (c.kind == scene::Container::Kind::box) return c.bounds().contains(p);
  const dvec3 q = p - c.centre;
  return glm::dot(q, q) <= c.radius * c.radius;
}

/// Outward, not of unit length.
[[nodiscard]] inline dvec3 face_normal(const scene::Container& c, const dvec3& p,
                                       std::uint32_t part) {
  if (part == sphere_part) return p - c.centre;
  dvec3 n(0.0);
  n[static_cast<int>(part - 1) / 2] = part % 2 == 0 ? 1 : -1;
  return n;
}

}  // namespace durer::tracer

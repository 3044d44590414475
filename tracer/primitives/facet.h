// Triangles that stand alone.
#pragma once

#include <glm/geometric.hpp>
#include <optional>

#include "tracer/accel/sheared_ray.h"
#include "tracer/primitives/typed_store.h"

namespace durer::tracer {

struct Corners {
  dvec3 a{0.0};
  dvec3 b{0.0};
  dvec3 c{0.0};

  /// Twice the area long; towards a viewer who sees a, b, c counter-clockwise (objects §11.2).
  [[nodiscard]] dvec3 normal() const { return glm::cross(a - b, c - b); }
  [[nodiscard]] Corners moved(const Transform& t) const {
    return {t.point(a), t.point(b), t.point(c)};
  }
  [[nodiscard]] Bounds3 bounds() const {
    Bounds3 box;
    for (const dvec3 p : {a, b, c}) box.add(p);
    return {box.lo - epsilon, box.hi + epsilon};
  }
  /// Shares of the corners at a point of the plane; they add up to 1.
  [[nodiscard]] dvec3 weights(dvec3 p) const {
    const dvec3 n = normal();
    const double area = glm::dot(n, n);
    const double of_a = glm::dot(glm::cross(p - b, c - b), n) / area;
    const double of_c = glm::dot(glm::cross(a - b, p - b), n) / area;
    return {of_a, 1 - of_a - of_c, of_c};
  }
  /// Where the line meets the triangle, edges included.
  [[nodiscard]] std::optional<double> depth(const Ray& ray) const {
    const ShearedRay sheared(ray);
    const auto shadow = [&](dvec3 p) {
      const double z = p[sheared.z] - sheared.o.z;
      return dvec2((p[sheared.x] - sheared.o.x) - sheared.sx * z,
                   (p[sheared.y] - sheared.o.y) - sheared.sy * z);
    };
    const dvec2 sa = shadow(a);
    const dvec2 sb = shadow(b);
    const dvec2 sc = shadow(c);
    const double u = sb.x * sc.y - sb.y * sc.x;
    const double v = sc.x * sa.y - sc.y * sa.x;
    const double w = sa.x * sb.y - sa.y * sb.x;
    const bool in = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    if (!in) return std::nullopt;
    const dvec3 n = normal();
    const double slope = glm::dot(n, ray.d);
    const double least = epsilon * epsilon * glm::dot(n, n) * glm::dot(ray.d, ray.d);
    if (slope * slope < least || slope == 0) return std::nullopt;
    return glm::dot(n, a - ray.o) / slope;
  }
};

/// What flat and smooth triangles have in common; `Self` says how they move and look.
template <typename Self>
struct Facet {
  Corners corners;

  static constexpr double far = t_far;

  [[nodiscard]] Bounds3 bounds() const { return corners.bounds(); }
  [[nodiscard]] static bool contains(dvec3 /*p*/) { return false; }
  /// Nothing inside, hence nothing that could be inverted (objects §8.5).
  [[nodiscard]] Self flipped() const { return static_cast<const Self&>(*this); }
  void crossings(const Ray& ray, Crossings& out) const {
    if (const auto t = corners.depth(ray)) out.push_back({.t = *t, .side = Side::sheet});
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    const auto t = corners.depth(ray);
    if (!t || !(*t >= t_from && *t < t_to)) return std::nullopt;
    return Nearest{*t, 0};
  }
};

}  // namespace durer::tracer

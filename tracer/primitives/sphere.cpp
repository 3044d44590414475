#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/primitives/around_axis.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer {
namespace {

/// The factor of a map that only rotates, mirrors, moves and scales evenly; none for other maps.
std::optional<double> even_scale(const Affine& m) {
  const double s2 = glm::dot(m.x, m.x);
  const double tolerance = 1e-14 * s2;
  const auto differs = [&](double a, double b) { return !(std::abs(a - b) <= tolerance); };
  if (differs(glm::dot(m.y, m.y), s2) || differs(glm::dot(m.z, m.z), s2)) return std::nullopt;
  if (differs(glm::dot(m.x, m.y), 0) || differs(glm::dot(m.y, m.z), 0) ||
      differs(glm::dot(m.z, m.x), 0)) {
    return std::nullopt;
  }
  return std::sqrt(s2);
}

// Solid ball (objects §10.1). A negative radius gives the surface of |radius| with normals inwards.
struct Sphere {
  dvec3 center{0.0};
  double radius = 1;

  static constexpr std::array params{
      positional<&Sphere::center>("center", "centre of the ball"),
      positional<&Sphere::radius>("radius", "radius of the ball; any sign, 0 is invisible"),
  };
  static constexpr bool convex = true;
  static constexpr double far = t_far;
  static constexpr bool uv_turns = true;

  static std::vector<Sphere> samples() {
    return {{dvec3(0.0), 1}, {{1, 2, 3}, 2}, {{-3, 0.5, 2}, -0.25}, {{1e4, 0, 0}, 3}};
  }

  [[nodiscard]] Bounds3 bounds() const {
    const double r = std::abs(radius);
    return {center - r, center + r};
  }
  [[nodiscard]] bool contains(dvec3 p) const {
    const dvec3 v = p - center;
    return glm::dot(v, v) < radius * radius;
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t /*part*/) const {
    return (p - center) / radius;
  }
  [[nodiscard]] dvec2 uv(dvec3 p, std::uint32_t /*part*/) const {
    const dvec3 d = glm::normalize(p - center);
    return {turn_around_y(d), 0.5 + std::asin(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi};
  }

  [[nodiscard]] std::optional<Sphere> moved(const Transform& m) const {
    const auto scale = even_scale(m.forward);
    if (!scale) return std::nullopt;
    return Sphere{m.point(center), radius * *scale};
  }

  struct Chord {
    double middle;
    double half;
  };
  // To the oracle's last bit, for patterns have borders at round distances from the centre (objects
  // §10.1). A small distant ball would lose its discriminant to cancellation: there it is measured
  // from the point nearest the centre [Haines et al., Ray Tracing Gems 2019, ch. 7].
  [[nodiscard]] std::optional<Chord> chord(const Ray& ray) const {
    constexpr double distant = 1e6;  // square of the distance, in radii
    const dvec3 way = center - ray.o;
    const double middle = glm::dot(way, ray.d);
    const double q = glm::dot(way, way);
    const double r2 = radius * radius;
    if (!(q <= distant * r2)) return chord(ray, 1);
    const double h2 = r2 - q + middle * middle;
    if (!(h2 > epsilon)) return std::nullopt;  // tangent rays miss; also stops NaN
    return Chord{middle, std::sqrt(h2)};
  }
  // For directions of any length; `per_d2` is 1 / |d|².
  [[nodiscard]] std::optional<Chord> chord(const Ray& ray, double per_d2) const {
    const double middle = glm::dot(center - ray.o, ray.d) * per_d2;
    const dvec3 miss = ray.at(middle) - center;
    const double h2 = radius * radius - glm::dot(miss, miss);
    if (!(h2 > epsilon)) return std::nullopt;
    return Chord{middle, std::sqrt(h2 * per_d2)};
  }
  [[nodiscard]] static std::optional<Nearest> first(const std::optional<Chord>& c, double t_from,
                                                    double t_to) {
    if (!c) return std::nullopt;
    double t = c->middle - c->half;
    if (t < t_from) t = c->middle + c->half;
    if (!(t >= t_from && t < t_to)) return std::nullopt;
    return Nearest{t, 0};
  }

  [[nodiscard]] bool misses(const ShaftHull& hull) const {
    const dvec3 m = hull.apex - center;
    return hull.beyond(center, m, std::abs(radius) * glm::length(m));
  }

  void crossings(const Ray& ray, Crossings& out) const {
    const double d2 = glm::dot(ray.d, ray.d);
    const bool unit = std::abs(d2 - 1) < 1e-14;  // but for rounding
    const auto c = unit ? chord(ray) : chord(ray, 1 / d2);
    if (!c) return;
    out.push_back({.t = c->middle - c->half, .side = Side::enter});
    out.push_back({.t = c->middle + c->half, .side = Side::exit});
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    return first(chord(ray, 1 / glm::dot(ray.d, ray.d)), t_from, t_to);
  }
  [[nodiscard]] std::optional<Nearest> nearest_of_unit(const Ray& ray, double t_from,
                                                       double t_to) const {
    return first(chord(ray), t_from, t_to);
  }
};

}  // namespace

extern constinit const PrimitiveType sphere_primitive =
    describe<Sphere>("sphere", "A ball: centre, radius.");

}  // namespace durer::tracer

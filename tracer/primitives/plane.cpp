#include <cmath>

#include "tracer/primitives/describe.h"

namespace durer::tracer {
namespace {

// Half-space behind a plane (objects §12.1): the inside is the side opposite to the normal.
struct Plane {
  dvec3 normal_vector{0, 1, 0};
  double distance = 0;  // along the unit normal

  static constexpr std::array params{
      positional<&Plane::normal_vector>("normal", "direction of the normal, any length"),
      positional<&Plane::distance>("distance", "distance from the origin along the unit normal"),
  };

  static std::vector<Plane> samples() {
    return {{{0, 1, 0}, 1}, {{1, 2, -3}, 1}, {{-2, 0, 0}, -0.5}};
  }

  [[nodiscard]] std::optional<std::string> problem() const {
    if (glm::length(normal_vector) < epsilon) return "the normal of a plane must not be zero";
    return std::nullopt;
  }

  struct HalfSpace;
  [[nodiscard]] std::optional<Framed<HalfSpace>> shape() const;
};

struct Plane::HalfSpace {
  dvec3 n;  // unit
  double distance = 0;
  dvec3 unit_normal = glm::normalize(n);  // as normal() is rounded for all other shapes

  static constexpr bool convex = true;
  static constexpr double far = t_far;

  /// Planes along the axes bound one side; others bound nothing (objects §7).
  [[nodiscard]] Bounds3 bounds() const {
    Bounds3 b = Bounds3::everything();
    for (int i = 0; i < 3; ++i) {
      if (std::abs(n[(i + 1) % 3]) >= epsilon || std::abs(n[(i + 2) % 3]) >= epsilon) continue;
      (n[i] > 0 ? b.hi : b.lo)[i] = distance * n[i];
    }
    return b;
  }
  [[nodiscard]] bool contains(dvec3 p) const { return glm::dot(n, p) - distance < epsilon; }
  [[nodiscard]] dvec3 normal(dvec3 /*p*/, std::uint32_t /*part*/) const { return n; }

  [[nodiscard]] std::optional<HalfSpace> moved(const Transform& m) const {
    const dvec3 stretched = m.normal(n);
    const dvec3 unit = glm::normalize(stretched);
    return HalfSpace{unit, glm::dot(unit, m.point(n * distance))};
  }
  [[nodiscard]] HalfSpace flipped() const { return {-n, -distance}; }

  [[nodiscard]] bool begins_inside(const Ray& ray) const {
    const double slope = glm::dot(n, ray.d);
    return std::abs(slope) < epsilon ? contains(ray.o) : slope > 0;
  }
  void crossings(const Ray& ray, Crossings& out) const {
    const double slope = glm::dot(n, ray.d);
    if (!(std::abs(slope) >= epsilon)) return;
    out.push_back({.t = (distance - glm::dot(n, ray.o)) / slope,
                   .side = slope > 0 ? Side::exit : Side::enter});
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    const double slope = glm::dot(n, ray.d);
    if (!(std::abs(slope) >= epsilon)) return std::nullopt;
    const double t = (distance - glm::dot(n, ray.o)) / slope;
    if (!(t >= t_from && t < t_to)) return std::nullopt;
    return Nearest{t, 0};
  }
};

std::optional<Framed<Plane::HalfSpace>> Plane::shape() const {
  return Framed<HalfSpace>{{glm::normalize(normal_vector), distance}, {}};
}

}  // namespace

extern constinit const PrimitiveType plane_primitive =
    describe<Plane>("plane", "A plane and the half-space behind it: normal, distance.");

}  // namespace durer::tracer

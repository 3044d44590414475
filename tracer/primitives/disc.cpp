#include <cmath>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/frame.h"

namespace durer::tracer {
namespace {

// Flat ring (objects §11.1). Its inside is the whole half-space behind it. Canonical: z = 0.
struct Disc {
  dvec3 center{0.0};
  dvec3 normal_vector{0, 1, 0};
  double radius = 1;
  double hole = 0;

  static constexpr std::array params{
      positional<&Disc::center>("center", "centre of the ring"),
      positional<&Disc::normal_vector>("normal", "direction of the normal, any length"),
      positional<&Disc::radius>("radius", "outer radius"),
      trailing<&Disc::hole>("hole", "inner radius"),
  };

  static std::vector<Disc> samples() {
    return {{dvec3(0.0), {0, 1, 0}, 1, 0},
            {dvec3(0.0), {1, 2, -3}, 1, 0.3},
            {{1, 2, 3}, {0, 0, -2}, -4, 1}};
  }

  struct Ring;
  [[nodiscard]] std::optional<Framed<Ring>> shape() const;
};

struct Disc::Ring {
  double outer2 = 1;  // squared radii
  double inner2 = 0;

  static constexpr double far = t_far;

  [[nodiscard]] Bounds3 bounds() const {
    const double r = std::sqrt(outer2);
    return {{-r, -r, -0.001}, {r, r, 0.001}};
  }
  [[nodiscard]] static Bounds3 inside_bounds() { return Bounds3::everything(); }
  [[nodiscard]] static bool contains(dvec3 p) { return p.z < 0; }
  [[nodiscard]] static dvec3 normal(dvec3 /*p*/, std::uint32_t /*part*/) { return {0, 0, 1}; }

  [[nodiscard]] static bool meets_plane(const Ray& ray) {
    return ray.d.z * ray.d.z > epsilon * epsilon * glm::dot(ray.d, ray.d);
  }
  [[nodiscard]] bool in_ring(dvec3 p) const {
    const double r2 = p.x * p.x + p.y * p.y;
    return r2 >= inner2 && r2 <= outer2;
  }
  [[nodiscard]] static bool begins_inside(const Ray& ray) {
    return meets_plane(ray) ? ray.d.z > 0 : contains(ray.o);
  }
  void crossings(const Ray& ray, Crossings& out) const {
    if (!meets_plane(ray)) return;
    const double t = -ray.o.z / ray.d.z;
    out.push_back(
        {.t = t, .side = ray.d.z > 0 ? Side::exit : Side::enter, .visible = in_ring(ray.at(t))});
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    if (!meets_plane(ray)) return std::nullopt;
    const double t = -ray.o.z / ray.d.z;
    if (!(t >= t_from && t < t_to) || !in_ring(ray.at(t))) return std::nullopt;
    return Nearest{t, 0};
  }
};

std::optional<Framed<Disc::Ring>> Disc::shape() const {
  const double length = glm::length(normal_vector);
  if (length == 0) return std::nullopt;
  return Framed<Ring>{{radius * radius, hole * hole},
                      frame_along(center, normal_vector / length, 1, 1)};
}

}  // namespace

extern constinit const PrimitiveType disc_primitive =
    describe<Disc>("disc", "A flat ring: centre, normal, radius, radius of the hole.");

}  // namespace durer::tracer

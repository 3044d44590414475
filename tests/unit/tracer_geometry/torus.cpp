#include "tests/unit/tracer_geometry/scenes.h"

namespace durer::tracer::test {
namespace {

/// Distance of p from the torus surface, in long double.
long double distance_to_torus(const Ray& ray, double t, double major, double minor) {
  const long double x = static_cast<long double>(ray.o.x) + static_cast<long double>(t) * ray.d.x;
  const long double y = static_cast<long double>(ray.o.y) + static_cast<long double>(t) * ray.d.y;
  const long double z = static_cast<long double>(ray.o.z) + static_cast<long double>(t) * ray.d.z;
  return hypotl(hypotl(x, z) - static_cast<long double>(major), y) -
         static_cast<long double>(minor);
}

}  // namespace

TEST_CASE("torus: hits lie on the surface for thick and thin rings, near and far",
          "[tracer][torus][precision]") {
  const double minor = GENERATE(1e-3, 1e-2, 0.25, 0.999);
  const double away = GENERATE(1.5, 100.0, 1e5);
  CAPTURE(minor, away);
  const Geometry geometry = only(primitive("torus", {1, minor}));
  const auto scratch = geometry.make_scratch();
  Random random(3);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    // Aim at a point of the ring, give or take its thickness.
    const double angle = uniform(random, 0, 6.3);
    const dvec3 target =
        dvec3(std::cos(angle), 0, std::sin(angle)) + 1.5 * minor * direction(random);
    const dvec3 d = direction(random);
    const Ray ray{target - away * d, d};
    Hit hit;
    if (!geometry.closest(ray, t_min, no_hit_depth, RayKind::image, hit, *scratch)) continue;
    ++hits;
    REQUIRE(std::abs(static_cast<double>(distance_to_torus(ray, hit.t, 1, minor))) <
            1e-9 * minor + 1e-15 * away);
  }
  CHECK(hits > 1000);
}

}  // namespace durer::tracer::test

// Who may cast shadows into a shaft: never one too few.
#include <algorithm>

#include "tests/unit/tracer_geometry/scenes.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer::test {
namespace {

/// Primitives of one sort, spread around the origin.
SceneBuilder crowd(const PrimitiveType& type, std::uint64_t seed) {
  Random random(seed);
  SceneBuilder b;
  const auto samples = type.samples();
  for (int i = 0; i < 40; ++i) {
    scene::Object o = primitive(type.name, samples[random() % samples.size()]);
    o.transform = Transform::scale(dvec3(std::exp(uniform(random, -3, 0))))
                      .then(Transform::rotate_deg(point_in_cube(random, 180)))
                      .then(Transform::translate(point_in_cube(random, 6)));
    b.show(o);
  }
  return b;
}

}  // namespace

TEST_CASE("casters: hold all that stops a ray in a shaft", "[tracer][accel][shaft]") {
  std::size_t dark = 0;
  std::size_t left_out = 0;
  for (const PrimitiveType* type : types_with_samples()) {
    CAPTURE(type->name);
    Geometry geometry = crowd(*type, 5).build();
    geometry.set_opaque(std::vector<bool>(geometry.surfaces().size(), true));
    const auto scratch = geometry.make_scratch();
    std::vector<Caster> casters;
    Random random(31);
    for (int i = 0; i < 300; ++i) {
      // Most points to be lit lie on something.
      Hit hit;
      const Ray look{point_in_cube(random, 8), direction(random)};
      const bool met =
          geometry.closest(look, t_min, no_hit_depth, RayKind::image, hit, *scratch);
      const dvec3 apex = met ? hit.p : look.o;
      const dvec3 centre = point_in_cube(random, 12);
      const dvec3 u = point_in_cube(random, 1);
      const dvec3 v = point_in_cube(random, 1);
      if (!geometry.casters(Shaft(apex, centre, u, v, t_shadow), casters)) continue;
      left_out += 40 - std::min<std::size_t>(40, casters.size());
      for (int k = 0; k < 12; ++k) {
        const dvec3 to = centre + uniform(random, -1, 1) * u + uniform(random, -1, 1) * v - apex;
        const double length = glm::length(to);
        const Ray ray{apex, to / length};
        const bool blocked = geometry.occluded(ray, t_shadow, length - t_shadow, *scratch);
        if (blocked) ++dark;
        REQUIRE(geometry.occluded_by(casters, ray, t_shadow, length - t_shadow, *scratch) ==
                blocked);
      }
    }
  }
  CHECK(dark > 1000);
  CHECK(left_out > 10000);  // the test is about something
}

TEST_CASE("casters: the ground and the body that is lit are none", "[tracer][accel][shaft]") {
  SceneBuilder b;
  b.show(primitive("plane", {0, 1, 0, 0}));
  b.show(primitive("sphere", {0, 1, 0, 1}));
  b.show(primitive("cylinder", {5, 0, 0, 5, 2, 0, 0.5, 0}));
  b.show(primitive("torus", {1, 0.25}, Transform::translate({-5, 0.25, 0})));
  Geometry geometry = b.build();
  geometry.set_opaque(std::vector<bool>(geometry.surfaces().size(), true));
  std::vector<Caster> casters;
  const auto lit = [&](dvec3 p) {
    const Shaft shaft(p, {0, 40, 0}, {0.5, 0, 0}, {0, 0, 0.5}, t_shadow);
    return geometry.casters(shaft, casters) && casters.empty();
  };
  CHECK(lit({0, 0, 12}));       // on the plane
  CHECK(lit({0, 2, 0}));        // on the top of the sphere
  CHECK(lit({0, 1.6, 0.8}));    // on its shoulder
  CHECK(lit({5, 2, 0}));        // on the cap of the cylinder
  CHECK(lit({4.5, 1, 0}));      // on the wall, towards the lamp
  CHECK(lit({-3.75, 0.25, 0})); // outside on the ring
  CHECK_FALSE(lit({0, 0, 0.1}));  // below the sphere
  CHECK_FALSE(lit({5.5, 1, 0}));  // on the wall, away from the lamp
}

}  // namespace durer::tracer::test

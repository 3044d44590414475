// Julia sets: what is found for eight points at a time is what is found for each alone.
#include "tests/unit/tracer_geometry/scenes.h"
#include "tracer/primitives/julia_lanes.h"
#include "tracer/primitives/julia_orbit.h"

namespace durer::tracer::test {

TEST_CASE("julia_fractal: eight points together are what each is alone", "[tracer][julia]") {
  JuliaSet set;
  set.hypercomplex = GENERATE(false, true);
  set.function = GENERATE(JuliaFunction::sqr, JuliaFunction::cube);
  set.iterations = GENERATE(1U, 7U, 20U);
  set.c = {-0.083, 0.1, -0.83, -0.025};
  set.slice = {0.1, -0.2, 0.3};
  set.slice_at = 0.05;
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const dvec3 o = point_in_cube(random, 1.2);
    const dvec3 d = glm::normalize(point_in_cube(random, 1) - o);
    JuliaOrbits::Lanes s{};
    for (double& at : s) at = point_in_cube(random, 1).x;
    const unsigned inside = julia_contains(set, o, d, s);
    JuliaOrbits orbits;
    julia_orbits(set, o, d, s, orbits);
    for (std::size_t k = 0; k < julia_lanes; ++k) {
      const dvec3 p = o + s[k] * d;
      const bool contains = set.contains(p);
      CHECK(((inside >> k & 1U) != 0) == contains);
      REQUIRE((orbits.escape[k] < 0) == contains);
      if (contains) continue;
      const auto steps = static_cast<std::uint32_t>(orbits.escape[k]);
      const auto number = [k](const std::array<JuliaOrbits::Lanes, 4>& of) {
        return four(HypercomplexOrbit<double>{of[0][k], of[1][k], of[2][k], of[3][k]});
      };
      const double step =
          set.hypercomplex
              ? set.step_hypercomplex(steps, number(orbits.product), number(orbits.q), d)
              : set.step_quaternion(steps, orbits.product[0][k], orbits.q[0][k]);
      CHECK(set.look(p, d).step == step);
    }
  }
}

}  // namespace durer::tracer::test

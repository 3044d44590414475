// What transformations do to bumps, and bumps whose slope is known.
#include "tracer/shading/normal.h"

#include <glm/geometric.hpp>

#include "tests/support/catch.h"
#include "tests/support/scene_builder.h"
#include "tracer/compile.h"

using namespace durer;
using namespace durer::tracer;

namespace {

scene::Normal normal_of(std::string_view pattern, std::vector<double> args = {}) {
  const test::SceneBuilder names(registry());
  scene::Normal n;
  n.pattern.edit().type = names.pattern(pattern);
  n.pattern.edit().args = std::move(args);
  return n;
}
dvec3 bent(const scene::Normal& normal, dvec3 p, dvec3 n, const Transform& to_world = {}) {
  NormalStore store;
  return store.at(store.add(normal, to_world), p, n, nullptr);
}
bool near(dvec3 a, dvec3 b) { return glm::distance(a, b) < 1e-9; }

const dvec3 up(0, 1, 0);

}  // namespace

TEST_CASE("normals: without a pattern nothing is bent", "[tracer][normals]") {
  CHECK(bent({}, {1, 2, 3}, up) == up);
}

TEST_CASE("normals: a ramp leans towards its lower side", "[tracer][normals]") {
  scene::Normal ramp = normal_of("gradient", {1, 0, 0});
  const dvec3 n = bent(ramp, {0.5, 0, 0}, up);
  // The corners of the tetrahedron give 4/3 of the slope times their size.
  const dvec3 expected = glm::normalize(dvec3(-0.5 * 5 * 0.02 * 4 / 3, 1, 0));
  CHECK(glm::distance(n, expected) < 1e-6);  // numbers of single precision
  ramp.accuracy = 0.01F;  // the same slope, from nearer points
  CHECK(glm::distance(n, bent(ramp, {0.5, 0, 0}, up)) < 1e-6);
}

TEST_CASE("normals: bumps get deeper as they get larger", "[tracer][normals]") {
  scene::Normal bumps = normal_of("bumps");
  const dvec3 p(0.3, 0.7, -0.2);
  const Transform larger = Transform::scale(dvec3(10.0));
  CHECK(near(bent(bumps, p, up), bent(bumps, larger.point(p), up, larger)));

  bumps.no_bump_scale = true;
  const dvec3 depth = bent(bumps, p, up) - up;
  const dvec3 kept = bent(bumps, larger.point(p), up, larger) - up;
  CHECK(near(kept * 10.0, depth));
}

TEST_CASE("normals: rotations turn the bumps", "[tracer][normals]") {
  const scene::Normal bumps = normal_of("bumps");
  const dvec3 p(0.3, 0.7, -0.2);
  const Transform turn = Transform::rotate_deg({20, 130, -50});
  const dvec3 n = bent(bumps, turn.point(p), turn.normal(up), turn);
  CHECK(near(n, turn.normal(bent(bumps, p, up))));
}

TEST_CASE("normals: an average of one kind is that kind", "[tracer][normals]") {
  const scene::Normal bumps = normal_of("bumps");
  scene::Normal average = normal_of("average");
  average.children = {bumps};
  average.entries = {{2, 0}, {0.5F, 0}};
  const dvec3 p(3, -0.7, 0.2);
  CHECK(near(bent(average, p, up), bent(bumps, p, up)));
}

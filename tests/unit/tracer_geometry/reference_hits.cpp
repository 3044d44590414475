// Hits and normals that the oracle printed for `trace` (objects §15).
#include "tests/unit/tracer_geometry/scenes.h"

namespace durer::tracer::test {
namespace {

void check_hit(const Geometry& geometry, dvec3 o, dvec3 p, dvec3 n) {
  const auto scratch = geometry.make_scratch();
  Hit hit;
  REQUIRE(geometry.closest({o, {0, 0, 1}}, t_min, no_hit_depth, RayKind::image, hit, *scratch));
  for (int i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(hit.p[i] == Approx(p[i]).margin(6e-8));
    CHECK(hit.n[i] == Approx(n[i]).margin(6e-7));
  }
  CHECK(hit.t == Approx(p.z - o.z).margin(1e-7));
}

Transform rotate(double x, double y, double z) { return Transform::rotate_deg({x, y, z}); }

}  // namespace

TEST_CASE("sphere: the oracle's hit", "[tracer][sphere]") {
  check_hit(only(primitive("sphere", {1, 2, 3, 2})), {1.5, 2.5, -10}, {1.5, 2.5, 1.1291713},
            {0.25, 0.25, -0.935414});
  check_hit(
      only(primitive("sphere", {0, 0, 0, 1}, Transform::scale({1, 2, 1}).then(rotate(0, 0, 30)))),
      {0.3, 0.5, -10}, {0.3, 0.5, -0.8485706}, {0.409214, 0.318579, -0.855015});
}

TEST_CASE("box: the oracle's hit", "[tracer][box]") {
  check_hit(only(primitive("box", {-1, -1, -1, 1, 1, 1}, rotate(20, 30, 0))), {0.2, 0.1, -10},
            {0.2, 0.1, -1.3022490}, {-0.469846, 0.342020, -0.813798});
}

TEST_CASE("cylinder: the oracle's hit", "[tracer][cylinder]") {
  check_hit(only(primitive("cylinder", {0, 0, 0, 1, 2, 0.5, 0.5, 0})), {0.5, 1, -10},
            {0.5, 1, -0.2623475}, {0.097590, 0.195180, -0.975900});
}

TEST_CASE("cone: the oracle's hit", "[tracer][cone]") {
  check_hit(only(primitive("cone", {0, 0, 0, 1, 0, 2, 0, 0.3, 0})), {0.2, 1, -10},
            {0.2, 1, -0.6184658}, {0.290418, 0.330350, -0.898068});
}

TEST_CASE("disc: the oracle's hit", "[tracer][disc]") {
  check_hit(only(primitive("disc", {0, 0, 0, 1, 2, -3, 1, 0.3})), {0.4, 0.2, -5},
            {0.4, 0.2, 0.2666667}, {0.267261, 0.534522, -0.801784});
}

TEST_CASE("plane: the oracle's hit", "[tracer][plane]") {
  check_hit(only(primitive("plane", {1, 2, -3, 1})), {0.1, 0.2, -5}, {0.1, 0.2, -1.0805525},
            {0.267261, 0.534522, -0.801784});
}

TEST_CASE("torus: the oracle's hit", "[tracer][torus]") {
  check_hit(only(primitive("torus", {1, 0.25}, rotate(-60, 0, 0))), {0.5, 0.6, -10},
            {0.5, 0.6, 0.1874472}, {-0.527428, -0.284973, -0.800381});
}

TEST_CASE("difference: the oracle's hit", "[tracer][csg]") {
  SceneBuilder b;
  const auto box = b.add(primitive("box", {-1, -1, -1, 1, 1, 1}));
  const auto ball = b.add(primitive("sphere", {0, 0, -1, 0.8}));
  const auto cut = b.csg(scene::NodeKind::difference, {box, ball});
  b.scene.objects[cut].transform = rotate(0, 20, 0);
  b.show(cut);
  check_hit(b.build(), {0.1, 0.2, -5}, {0.1, 0.2, -0.3035966}, {-0.552525, -0.25, -0.795120});
}

}  // namespace durer::tracer::test

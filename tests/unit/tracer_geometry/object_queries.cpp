// Answers that the oracle printed for trace, inside, min_extent and max_extent (objects §7, §15).
#include "tracer/object_queries.h"

#include "tests/unit/tracer_geometry/scenes.h"

namespace durer::tracer::test {
namespace {

using scene::NodeKind;

Transform turned(double x, double y, double z) { return Transform::rotate_deg({x, y, z}); }

void check_extent(const SceneBuilder& b, scene::ObjectId id, dvec3 lo, dvec3 hi) {
  const Bounds3 box = make_object_queries()->extent(b.scene, id);
  for (int i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(box.lo[i] == Approx(lo[i]).margin(2e-9));
    CHECK(box.hi[i] == Approx(hi[i]).margin(2e-9));
  }
}

void check_extent(scene::Object o, dvec3 lo, dvec3 hi) {
  SceneBuilder b;
  const auto id = b.add(std::move(o));
  check_extent(b, id, lo, hi);
}

const dvec3 endless_lo(-1e10);
const dvec3 endless_hi(1e10);

}  // namespace

TEST_CASE("extent: primitives", "[tracer][extent]") {
  check_extent(
      primitive("sphere", {0, 0, 0, 1}, Transform::scale({1, 2, 1}).then(turned(0, 0, 45))),
      {-2.121320248, -2.121320248, -1}, {2.121320248, 2.121320248, 1});
  check_extent(primitive("sphere", {0, 0, 0, 1}, turned(0, 0, 45).then(Transform::scale(dvec3(2)))),
               dvec3(-2), dvec3(2));
  check_extent(primitive("cylinder", {0, 0, 0, 1, 1, 0, 0.5, 0}), {-0.5, -0.5, -0.707106769},
               {1.5, 1.5, 0.707106769});
  check_extent(primitive("cone", {0, 0, 0, 1, 0, 2, 0, 0.3, 0}), {-1, 0, -1}, {1, 2, 1});
  check_extent(primitive("cone", {0, 0, 0, 0.3, 1, 2, 0, 1, 0}),
               {-1.199999928, -0.599999964, -1.341640830}, {2.200000286, 2.600000143, 1.341640830});
  check_extent(primitive("torus", {1, 0.25}, turned(30, 0, 0)), {-1.25, -0.841506362, -1.207531810},
               {1.25, 0.841506362, 1.207531810});
  check_extent(primitive("disc", {0, 0, 0, 1, 1, 0, 1, 0}),
               {-1.000707150, -1.000707150, -1.414213538}, {1.000707150, 1.000707150, 1.414213538});
  check_extent(primitive("plane", {0, 1, 0, 1}), endless_lo, endless_hi);
  check_extent(primitive("box", {-1, -1, -1, 1, 1, 1}, turned(0, 0, 45)),
               {-1.414213538, -1.414213538, -1}, {1.414213538, 1.414213538, 1});
  check_extent(
      primitive("box", {0, 0, 0, 1 / 3.0, 1 / 3.0, 1 / 3.0}, Transform::translate(dvec3(0.1))),
      dvec3(0.100000001), dvec3(0.433333337));
}

TEST_CASE("extent: solids", "[tracer][extent]") {
  SceneBuilder b;
  const auto unit_ball = b.add(primitive("sphere", {0, 0, 0, 1}));
  const auto big_ball = b.add(primitive("sphere", {0, 0, 0, 2}));
  const auto unit_box = b.add(primitive("box", {0, 0, 0, 1, 1, 1}));
  const auto far_box = b.add(primitive("box", {2, 2, 2, 3, 3, 3}));
  const auto below_one = b.add(primitive("plane", {0, 1, 0, 1}));
  const auto above_zero = b.add(primitive("plane", {0, -1, 0, 0}));
  scene::Object other = primitive("plane", {0, 1, 0, 1});
  other.inverse = true;
  const auto above_one = b.add(other);
  const auto tilted = b.add(primitive("plane", {0, 1, 0, 0}, turned(45, 0, 0)));

  const auto all = b.csg(NodeKind::union_, {unit_ball, unit_box});
  b.scene.objects[all].transform = turned(0, 45, 0);
  check_extent(b, all, {-1.414213538, -1, -1.414213538}, {1.414213538, 1, 1.414213538});
  const auto slice = b.csg(NodeKind::intersection, {below_one, above_zero, big_ball});
  check_extent(b, slice, {-2, 0, -2}, {2, 1, 2});
  const auto cap = b.csg(NodeKind::intersection, {big_ball, above_one});
  check_extent(b, cap, {-2, 1, -2}, {2, 2, 2});
  const auto lean = b.csg(NodeKind::intersection, {big_ball, tilted});
  check_extent(b, lean, dvec3(-2), dvec3(2));
  const auto nothing = b.csg(NodeKind::intersection, {unit_box, far_box});
  check_extent(b, nothing, endless_lo, endless_hi);
  const auto cut = b.csg(NodeKind::difference, {unit_box, big_ball});
  check_extent(b, cut, dvec3(0), dvec3(1));
  const auto endless = b.csg(NodeKind::difference, {below_one, unit_ball});
  check_extent(b, endless, endless_lo, endless_hi);
  scene::Object lamp;
  lamp.kind = NodeKind::light;
  lamp.light = 0;
  b.scene.lights.resize(1);
  const auto lit = b.csg(NodeKind::union_, {unit_ball, b.add(lamp)});
  check_extent(b, lit, endless_lo, endless_hi);
}

TEST_CASE("extent: clips and bounds replace larger boxes", "[tracer][extent]") {
  SceneBuilder b;
  scene::Object clipped = primitive("sphere", {0, 0, 0, 1});
  clipped.extras.edit().clips = {b.add(primitive("box", {0, 0, 0, 1, 1, 1}))};
  check_extent(b, b.add(clipped), dvec3(0), dvec3(1));
  scene::Object ground = primitive("plane", {0, 1, 0, 0});
  ground.extras.edit().clips = {b.add(primitive("sphere", {0, 0, 0, 1}))};
  check_extent(b, b.add(ground), dvec3(-1), dvec3(1));
  clipped.extras.edit().clips = {b.add(primitive("plane", {0, 1, 0, 0}))};
  check_extent(b, b.add(clipped), dvec3(-1), dvec3(1));
}

TEST_CASE("queries: trace, inside and what cannot be asked", "[tracer][queries]") {
  SceneBuilder b;
  scene::Object ball = primitive("sphere", {0, 0, 0, 1});
  ball.no_image = true;
  const auto id = b.add(ball);
  const auto queries = make_object_queries();
  const auto hit = queries->trace(b.scene, id, {0, 0, -5}, {0, 0, 3});
  REQUIRE(hit.has_value());
  CHECK(hit->point.z == Approx(-1));
  CHECK(hit->normal.z == Approx(-1));
  const auto back = queries->trace(b.scene, id, {0, 0, 0}, {0, 0, 3});
  REQUIRE(back.has_value());
  CHECK(back->normal.z == Approx(1));  // not turned towards the ray
  CHECK_FALSE(queries->trace(b.scene, id, {0, 0, 5}, {0, 0, 3}).has_value());
  CHECK_FALSE(queries->trace(b.scene, id, {0, 0, 5}, {0, 0, 0}).has_value());
  CHECK(queries->inside(b.scene, id, {0, 0.5, 0}) == true);
  CHECK(queries->inside(b.scene, id, {0, 1.5, 0}) == false);
  CHECK_FALSE(queries->unsupported(b.scene, id).has_value());

  scene::Object lamp;
  lamp.kind = NodeKind::light;
  lamp.light = 0;
  b.scene.lights.resize(1);
  const auto lit = b.csg(NodeKind::union_, {id, b.add(lamp)});
  CHECK_FALSE(queries->inside(b.scene, lit, {0, 0, 0}).has_value());
  CHECK(queries->trace(b.scene, lit, {0, 0, -5}, {0, 0, 1}).has_value());

  scene::Object text;
  text.kind = NodeKind::unsupported;
  text.extras.edit().unsupported = "text";
  scene::Object clipped = ball;
  clipped.extras.edit().clips = {b.add(text)};
  const auto strange = b.csg(NodeKind::union_, {b.add(clipped)});
  CHECK(queries->unsupported(b.scene, strange) == "text");
  CHECK_FALSE(queries->trace(b.scene, strange, {0, 0, -5}, {0, 0, 1}).has_value());
}

}  // namespace durer::tracer::test

// Rays side by side against the same rays one by one.
#include <cmath>

#include "functions/builder.h"
#include "tests/unit/tracer_geometry/scenes.h"

namespace durer::tracer::test {
namespace {

/// sin x cos y + sin y cos z + sin z cos x - threshold, with coordinates times k, in a box.
scene::Object gyroid(double k, double threshold, double half) {
  using functions::Op;
  functions::FunctionBuilder b(3);
  const auto wave = [&](Op op, int i) {
    return b.op(op, b.op(Op::multiply, b.parameter(i), b.constant(k)));
  };
  const auto term = [&](int i, int j) {
    return b.op(Op::multiply, wave(Op::sine, i), wave(Op::cosine, j));
  };
  scene::Isosurface s;
  s.function = std::make_shared<const functions::Function>(
      b.finish(b.op(Op::add, b.op(Op::add, term(0, 1), term(1, 2)), term(2, 0))));
  s.threshold = threshold;
  s.container.lo = dvec3(-half);
  s.container.hi = dvec3(half);
  scene::Object o = primitive("isosurface", {});
  o.extras.edit().isosurface = std::make_shared<const scene::Isosurface>(s);
  return o;
}

SceneBuilder mixed_scene() {
  SceneBuilder b;
  b.show(primitive("plane", {0, 1, 0, -1.3}));
  b.show(primitive("sphere", {0.8, 0.4, -0.6, 0.6}));
  b.show(gyroid(5, 0.1, 1));
  scene::Object turned = gyroid(4, -0.2, 0.7);
  turned.transform = Transform::scale({1, 0.6, 1.3})
                         .then(Transform::rotate_deg({20, 40, 0}))
                         .then(Transform::translate({-0.5, 0.3, -0.2}));
  b.show(turned);
  scene::Object inverted = gyroid(6, 0, 0.4);
  inverted.inverse = true;
  inverted.transform = Transform::translate({0, 1.2, 0});
  b.show(inverted);
  scene::Object clipped = gyroid(5, 0.3, 0.8);
  clipped.extras.edit().clips = {b.add(primitive("plane", {0.6, 0, 0.8, 0.7}))};
  clipped.transform = Transform::translate({0.43, 0.41, 0.9});
  b.show(clipped);
  scene::Object hidden = gyroid(5, 0.3, 0.5);
  hidden.no_image = true;
  hidden.transform = Transform::translate({0, 0, -1.2});
  b.show(hidden);
  scene::Object bounded = gyroid(3, 0, 0.6);
  // Right, but not so easily known to be.
  bounded.extras.edit().bounds = {
      b.csg(scene::NodeKind::merge, {b.add(primitive("sphere", {-1.3, 0.2, 0.6, 1.1})),
                                     b.add(primitive("sphere", {-1.3, 1.2, 0.6, 0.3}))})};
  bounded.transform = Transform::translate({-1.3, 0.2, 0.6});
  b.show(bounded);
  return b;
}

/// More of them behind each other than a ray puts off.
SceneBuilder row_of_many() {
  SceneBuilder b;
  for (int i = 0; i < 12; ++i) {
    scene::Object o = gyroid(7, 0.8, 0.5);
    o.transform = Transform::translate({0.1 * i - 0.6, 0.05 * i - 0.3, 0.2 * i - 1.2});
    b.show(o);
  }
  return b;
}

/// One of them, in a space of its own: alone, or among a few others.
SceneBuilder companion(bool alone) {
  SceneBuilder b;
  if (!alone) {
    b.show(primitive("plane", {0, 1, 0, -0.8}));
    b.show(primitive("sphere", {0.8, 0.4, -0.6, 0.5}));
  }
  scene::Object o = gyroid(5, 0.1, 1);
  if (!alone) o.transform = Transform::rotate_deg({20, 40, 0});
  b.show(o);
  if (!alone) b.show(primitive("sphere", {-0.9, -0.3, 0.6, 0.5}));
  return b;
}

/// One that is alone in the world and turned inside out in a space of its own; or has bounds, so
/// that not all of it is there; or is not there for all rays.
SceneBuilder lone(int kind) {
  SceneBuilder b;
  scene::Object o = gyroid(5, 0.1, 1);
  if (kind == 0) {
    o.inverse = true;
    o.transform = Transform::scale({1, 0.6, 1.3}).then(Transform::rotate_deg({20, 40, 0}));
  } else if (kind == 1) {
    o.extras.edit().bounds = {
        b.csg(scene::NodeKind::merge, {b.add(primitive("sphere", {-0.3, 0.2, 0.1, 0.8})),
                                       b.add(primitive("sphere", {0.5, 0, 0, 0.3}))})};
  } else {
    o.no_image = true;
    o.no_shadow = true;
  }
  b.show(o);
  return b;
}

SceneBuilder scene_of(int number) {
  switch (number) {
    case 0: return mixed_scene();
    case 1: return row_of_many();
    case 4:
    case 5:
    case 6: return lone(number - 4);
    default: return companion(number == 2);
  }
}

/// A bundle of rays that start near one place and go about the same way.
std::vector<Ray> bundle(Random& random, std::size_t count) {
  const dvec3 o = 4.0 * direction(random);
  const dvec3 to = point_in_cube(random, 1);
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i) {
    rays.push_back({o, glm::normalize(to + point_in_cube(random, 0.3) - o)});
  }
  return rays;
}

/// As exact as roots are.
bool same(const Hit& a, const Hit& b) {
  return std::abs(a.t - b.t) < 1e-7 && glm::distance(a.p, b.p) < 1e-7 &&
         glm::distance(a.n, b.n) < 1e-4 && a.leaf == b.leaf && a.interior == b.interior &&
         a.store == b.store && a.shape == b.shape && a.part == b.part && a.depth == b.depth;
}

/// In arrays rays get the same answers to the last bit, whoever of them is asked.
void check_packets(const Geometry& geometry, std::span<const MeetingRay> meeting,
                   std::span<const ShadowRay> shadow, RayKind kind, GeometryScratch& scratch) {
  PacketRays rays;
  for (const MeetingRay& m : meeting) rays.add(*m.ray, m.t_from, m.t_to);
  rays.fill_up();
  if (geometry.is_one_object()) {
    PacketMeeting packet;
    geometry.closest(rays, kind, packet);
    std::size_t number = 0;
    for (std::size_t i = 0; i < meeting.size(); ++i) {
      REQUIRE((packet.met >> i & 1) == (meeting[i].met ? 1 : 0));
      if (!meeting[i].met) continue;
      Hit hit;
      packet.fill_in(number++, hit);
      CHECK(hit.p == meeting[i].hit.p);
      CHECK(hit.n == meeting[i].hit.n);
      CHECK(same(hit, meeting[i].hit));
    }
  }
  const RaySet all = (RaySet{2} << (shadow.size() - 1)) - 1;
  for (const RaySet asked : {all, all & 0x5A5A, RaySet{1}, RaySet{0}}) {
    PacketRays own = rays;
    const RaySet blocked = geometry.occluded(own, asked, scratch);
    for (std::size_t i = 0; i < most_in_packet; ++i) {
      const bool is = (asked >> i & 1) != 0 && shadow[i].blocked;
      REQUIRE((blocked >> i & 1) == (is ? 1 : 0));
    }
  }
}

}  // namespace

TEST_CASE("together: rays side by side meet what each meets alone", "[tracer][together]") {
  const int scene = GENERATE(0, 1, 2, 3, 4, 5, 6);
  const auto hierarchy = GENERATE(Hierarchy::embree, Hierarchy::linear);
  Geometry geometry = scene_of(scene).build(hierarchy);
  geometry.set_opaque(std::vector<bool>(geometry.surfaces().size(), true));
  REQUIRE(geometry.answers_together());
  const auto scratch = geometry.make_scratch();
  Random random(7);
  int hits = 0;
  int shadows = 0;
  for (int round = 0; round < 150; ++round) {
    const auto count = static_cast<std::size_t>(1 + random() % most_in_packet);
    const std::vector<Ray> rays = bundle(random, count);
    std::vector<MeetingRay> meeting(count);
    std::vector<ShadowRay> shadow(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double reach = random() % 4 == 0 ? uniform(random, 2, 5) : no_hit_depth;
      meeting[i].ray = &rays[i];
      meeting[i].t_from = shadow[i].t_from = t_min;
      meeting[i].t_to = shadow[i].t_to = reach;
      shadow[i].ray = rays[i];
    }
    const RayKind kind = random() % 2 == 0 ? RayKind::image : RayKind::reflection;
    geometry.closest(meeting, kind, *scratch);
    geometry.occluded(shadow, *scratch);
    check_packets(geometry, meeting, shadow, kind, *scratch);
    for (std::size_t i = 0; i < count; ++i) {
      const MeetingRay& m = meeting[i];
      Hit alone;
      REQUIRE(geometry.closest(rays[i], m.t_from, m.t_to, kind, alone, *scratch) == m.met);
      CAPTURE(m.hit.t - alone.t, m.hit.leaf, alone.leaf);
      if (m.met) REQUIRE(same(m.hit, alone));
      REQUIRE(geometry.occluded(rays[i], m.t_from, m.t_to, *scratch) == shadow[i].blocked);
      hits += m.met ? 1 : 0;
      shadows += shadow[i].blocked ? 1 : 0;
    }
  }
  CHECK(hits > 300);
  CHECK((scene == 6 ? shadows == 0 : shadows > 300));
}

TEST_CASE("together: no rays, and one", "[tracer][together]") {
  const Geometry geometry = only(gyroid(5, 0.1, 1));
  const auto scratch = geometry.make_scratch();
  geometry.closest(std::span<MeetingRay>(), RayKind::image, *scratch);
  geometry.occluded(std::span<ShadowRay>(), *scratch);
  const Ray ray{{0.1, 0.2, -3}, {0, 0, 1}};
  MeetingRay one;
  one.ray = &ray;
  one.t_to = no_hit_depth;
  geometry.closest(std::span(&one, 1), RayKind::image, *scratch);
  CHECK(one.met);
}

TEST_CASE("together: scenes without such objects know it", "[tracer][together]") {
  CHECK_FALSE(only(primitive("sphere", {0, 0, 0, 1})).answers_together());
}

}  // namespace durer::tracer::test

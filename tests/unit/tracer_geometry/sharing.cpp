// Contents that are kept once and placed many times, against the same scene with everything copied:
// the same hits, insides, interiors and lights.
#include <glm/geometric.hpp>
#include <set>

#include "tests/unit/tracer_geometry/scenes.h"
#include "tracer/flatten.h"
#include "tracer/placements.h"

namespace durer::tracer::test {
namespace {

using scene::NodeKind;

constexpr SharingLimits always{1, 0};
constexpr SharingLimits never{1, 1e300};

Transform random_place(Random& random, double spread) {
  return Transform::scale({std::exp(uniform(random, -0.5, 0.5)), std::exp(uniform(random, -0.5, 0.5)),
                           std::exp(uniform(random, -0.5, 0.5))})
      .then(Transform::rotate_deg(point_in_cube(random, 180)))
      .then(Transform::translate(point_in_cube(random, spread)));
}

/// Some primitives side by side, or a solid of them.
scene::ObjectId random_contents(SceneBuilder& b, Random& random, NodeKind kind) {
  std::vector<scene::ObjectId> children;
  for (int i = 0; i < 5; ++i) {
    scene::Object o = random() % 2 == 0 ? primitive("box", {-0.6, -0.5, -0.4, 0.6, 0.5, 0.4})
                                        : primitive("sphere", {0, 0, 0, 0.7});
    o.transform = random_place(random, 0.5);
    if (i == 1) o.texture = {1, o.transform};
    if (i == 2) o.interior = 0;
    if (i == 3) o.no_image = true;
    if (i == 4) o.hollow = true;
    children.push_back(b.add(std::move(o)));
  }
  return b.csg(kind, children);
}

/// A copy of an object, as `object { It … }` makes it.
scene::Object copy_of(const SceneBuilder& b, scene::ObjectId id, const Transform& t) {
  scene::Object o = b.scene.objects[id];
  o.transform = o.transform.then(t);
  if (o.texture.texture != scene::none) o.texture.transform = o.texture.transform.then(t);
  return o;
}

/// Copies of copies: clusters of contents in a crowd, with settings of their own.
SceneBuilder crowd(std::uint64_t seed, bool some_inverse = true) {
  Random random(seed);
  SceneBuilder b;
  b.scene.textures.resize(4);
  for (scene::Texture& t : b.scene.textures) {
    t.layers.resize(1);
    t.layers[0].pigment.edit().pattern.edit().type = 0;  // has a place
  }
  b.scene.interiors.resize(2);
  const auto loose = random_contents(b, random, NodeKind::union_);
  const auto solid = random_contents(b, random, NodeKind::difference);
  scene::Object lamp;
  lamp.kind = NodeKind::light;
  lamp.light = 0;
  b.scene.lights.resize(1);
  lamp.transform = Transform::translate({0, 1, 0});
  b.show(lamp);
  std::vector<scene::ObjectId> children;
  for (int i = 0; i < 6; ++i) {
    scene::Object o = copy_of(b, i % 2 == 0 ? loose : solid, random_place(random, 3));
    if (i == 2) o.texture = {2, Transform::translate({0, 0, 1})};
    if (i == 3) o.interior = 1;
    if (i == 4) o.inverse = some_inverse;
    if (i == 5) o.no_shadow = true;
    children.push_back(b.add(o));
  }
  const auto cluster = b.csg(NodeKind::union_, children);
  std::vector<scene::ObjectId> placed;
  for (int i = 0; i < 8; ++i) {
    scene::Object o = copy_of(b, cluster, random_place(random, 12));
    if (i == 3) o.texture = {3, {}};
    if (i == 4) o.extras.edit().bounds = {b.add(primitive("sphere", {0, 0, 0, 4}, o.transform))};
    if (i == 5) o.extras.edit().clips = {b.add(primitive("sphere", {0, 0, 0, 4}, o.transform))};
    if (i % 2 == 0) {
      b.show(o);
    } else {
      placed.push_back(b.add(o));
    }
  }
  scene::Object rest;
  rest.kind = NodeKind::union_;
  rest.children = placed;
  rest.texture = {2, {}};
  b.show(rest);
  b.show(primitive("plane", {0, 1, 0, -30}));
  return b;
}

Geometry build(const SceneBuilder& b, const SharingLimits& limits) {
  const SourceMap sources;
  Diagnostics diagnostics(sources);
  auto geometry = Geometry::build(b.scene, diagnostics, Hierarchy::embree, limits);
  REQUIRE(geometry.has_value());
  return std::move(*geometry);
}

/// The outside texture that is seen at a hit: which one, and the point where it is looked up.
std::pair<scene::TextureId, dvec3> texture_at(const Geometry& g, const Hit& hit) {
  std::uint32_t level = hit.depth;
  scene::TextureUse use = g.surfaces()[g.leaves()[hit.leaf].surface].texture;
  while (use.texture == texture_of_placement) {
    use = g.surfaces()[g.placements()[hit.path[--level]].surface].texture;
  }
  return {use.texture, use.transform->backward.point(hit.at(level))};
}

}  // namespace

TEST_CASE("sharing: what is placed many times looks as if it were copied", "[tracer][sharing]") {
  const std::uint64_t seed = GENERATE(1U, 2U, 3U, 4U);
  CAPTURE(seed);
  const SceneBuilder b = crowd(seed);
  const Geometry copied = build(b, never);
  const Geometry shared = build(b, always);
  REQUIRE(copied.placements().empty());
  REQUIRE(shared.placements().size() > 8);
  CHECK(shared.leaves().size() < copied.leaves().size() / 3);
  REQUIRE(shared.interiors().size() == copied.interiors().size());
  REQUIRE(shared.lights().size() == copied.lights().size());
  for (std::size_t i = 0; i < copied.lights().size(); ++i) {
    CHECK(glm::distance(shared.lights()[i].position, copied.lights()[i].position) < 1e-9);
  }

  const auto shared_scratch = shared.make_scratch();
  const auto copied_scratch = copied.make_scratch();
  Random random(seed + 50);
  int hits = 0;
  std::set<std::uint32_t> depths;
  for (int i = 0; i < 4000; ++i) {
    const RayKind kind = static_cast<RayKind>(i % 3);
    const Ray ray{point_in_cube(random, 20), direction(random)};
    const Ray unit{ray.o, glm::normalize(ray.d)};
    Hit c;
    Hit s;
    const bool found = copied.closest(unit, t_min, no_hit_depth, kind, c, *copied_scratch);
    REQUIRE(shared.closest(unit, t_min, no_hit_depth, kind, s, *shared_scratch) == found);
    if (!found) continue;
    ++hits;
    depths.insert(s.depth);
    REQUIRE(s.t == Approx(c.t).epsilon(1e-9));
    REQUIRE(glm::distance(s.n, c.n) < 1e-6);
    REQUIRE(shared.interiors()[s.interior].interior == copied.interiors()[c.interior].interior);
    REQUIRE(shared.interiors()[s.interior].hollow == copied.interiors()[c.interior].hollow);
    REQUIRE(shared.leaves()[s.leaf].origin == copied.leaves()[c.leaf].origin);
    const auto [s_texture, s_point] = texture_at(shared, s);
    const auto [c_texture, c_point] = texture_at(copied, c);
    REQUIRE(s_texture == c_texture);
    REQUIRE(glm::distance(s_point, c_point) < 1e-7 * (1 + glm::length(c_point)));
  }
  CHECK(hits > 500);
  CHECK(depths.count(2) == 1);
}

TEST_CASE("sharing: insides count for every placement on its own", "[tracer][sharing]") {
  // None is inverse: the boxes in which these count lie along the axes of the contents' space.
  const SceneBuilder b = crowd(7, false);
  const Geometry copied = build(b, never);
  const Geometry shared = build(b, always);
  const auto shared_scratch = shared.make_scratch();
  const auto copied_scratch = copied.make_scratch();
  Random random(8);
  std::size_t inside = 0;
  for (int i = 0; i < 30000; ++i) {
    const dvec3 p = point_in_cube(random, 10);
    std::vector<std::uint32_t> c;
    std::vector<std::uint32_t> s;
    copied.containing(p, c, *copied_scratch);
    shared.containing(p, s, *shared_scratch);
    REQUIRE(c.size() == s.size());
    // Instances are numbered in another order, but as many of them are different.
    REQUIRE(std::set(c.begin(), c.end()).size() == std::set(s.begin(), s.end()).size());
    for (std::size_t k = 0; k < c.size(); ++k) {
      REQUIRE(copied.interiors()[c[k]].interior == shared.interiors()[s[k]].interior);
    }
    inside += c.size();
  }
  CHECK(inside > 200);
}

TEST_CASE("sharing: shadows of what is placed are those of copies", "[tracer][sharing]") {
  const SceneBuilder b = crowd(9);
  Geometry copied = build(b, never);
  Geometry shared = build(b, always);
  copied.set_opaque(std::vector<bool>(copied.surfaces().size(), true));
  shared.set_opaque(std::vector<bool>(shared.surfaces().size(), true));
  const auto shared_scratch = shared.make_scratch();
  const auto copied_scratch = copied.make_scratch();
  Random random(10);
  int dark = 0;
  for (int i = 0; i < 3000; ++i) {
    const Ray ray{point_in_cube(random, 15), glm::normalize(direction(random))};
    const double reach = uniform(random, 1, 20);
    const bool expected = copied.occluded(ray, t_shadow, reach, *copied_scratch);
    REQUIRE(shared.occluded(ray, t_shadow, reach, *shared_scratch) == expected);
    if (expected) ++dark;
  }
  CHECK(dark > 100);
}

TEST_CASE("sharing: what is not worth it, or depends on its place, is copied", "[tracer][sharing]") {
  SceneBuilder b;
  std::vector<scene::ObjectId> children{b.add(primitive("sphere", {0, 0, 0, 1})),
                                        b.add(primitive("box", {0, 0, 0, 1, 1, 1}))};
  SECTION("patches that are mirrored, whose sides would change") {
    children.push_back(b.add(primitive("triangle", {0, 0, 0, 1, 0, 0, 0, 1, 0})));
    const auto contents = b.csg(NodeKind::union_, children);
    b.show(copy_of(b, contents, Transform::scale({-1, 1, 1})));
    b.show(contents);
    CHECK(build(b, always).placements().size() == 1);
  }
  SECTION("boxes along the world's axes, left behind by bounds") {
    scene::Object bounded = primitive("sphere", {0, 0, 0, 1});
    bounded.extras.edit().bounds = {b.add(primitive("sphere", {0, 0, 0, 2}))};
    children.push_back(b.add(bounded));
    const auto contents = b.csg(NodeKind::union_, children);
    b.show(copy_of(b, contents, Transform::translate({1, 1, 1})));
    b.show(contents);
    CHECK(build(b, always).placements().empty());
  }
  SECTION("few primitives") {
    const auto contents = b.csg(NodeKind::union_, children);
    for (int i = 0; i < 100; ++i) {
      b.show(copy_of(b, contents, Transform::translate(dvec3(0, 0, i))));
    }
    CHECK(build(b, {}).placements().empty());
    CHECK(build(b, {2, 198}).placements().size() == 100);
    CHECK(build(b, {2, 199}).placements().empty());
  }
}

}  // namespace durer::tracer::test

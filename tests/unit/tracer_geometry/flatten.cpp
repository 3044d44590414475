// What children inherit, what moves with what, and what falls apart (objects §6.4, §8.6, §9.3).
#include "tracer/flatten.h"

#include "tests/unit/tracer_geometry/scenes.h"

namespace durer::tracer::test {
namespace {

using scene::NodeKind;

scene::Object ball(double x = 0) { return primitive("sphere", {x, 0, 0, 1}); }

Flat flat(const SceneBuilder& b) {
  const SourceMap sources;
  Diagnostics diagnostics(sources);
  Flat result = flatten(b.scene, diagnostics);
  CHECK_FALSE(diagnostics.has_errors());
  return result;
}

std::size_t bodies_at(const Geometry& geometry, dvec3 p) {
  std::vector<std::uint32_t> interiors;
  geometry.containing(p, interiors, *geometry.make_scratch());
  return interiors.size();
}

}  // namespace

TEST_CASE("flatten: textures of a plain colour have no place", "[tracer][flatten]") {
  SceneBuilder b;
  b.scene.textures.resize(2);
  b.scene.textures[1].layers.emplace_back();
  for (int i = 0; i < 3; ++i) {
    scene::Object o = ball();
    o.texture = {1, Transform::translate({1.0 * i, 0, 0})};
    b.show(o);
  }
  CHECK(flat(b).surfaces.size() == 1);
}

TEST_CASE("flatten: a texture moves with what stands around its object", "[tracer][flatten]") {
  SceneBuilder b;
  b.scene.textures.resize(3);
  for (scene::Texture& t : b.scene.textures) {  // a plain colour would look the same everywhere
    t.layers.emplace_back().pigment.edit().pattern.edit().type = 0;
  }
  scene::Object own = ball();
  own.texture = {1, Transform::scale(dvec3(2))};
  own.transform = Transform::translate({100, 0, 0});  // written before the texture: not in it
  scene::Object both;
  both.kind = NodeKind::union_;
  both.children = {b.add(own), b.add(ball())};
  both.texture = {2, Transform::translate({0, 0, 5})};
  both.transform = Transform::translate({1, 0, 0});
  scene::Object outer;
  outer.kind = NodeKind::union_;
  outer.children = {b.add(both), b.add(ball())};
  outer.transform = Transform::translate({0, 7, 0});
  b.show(outer);
  const Flat f = flat(b);
  REQUIRE(f.leaves.size() == 3);
  const auto use = [&](std::size_t leaf) { return f.surfaces[f.leaves[leaf].surface].texture; };
  CHECK(use(0).texture == 1);
  CHECK(use(0).transform->point({1, 1, 1}) == dvec3(3, 9, 2));  // scaled, then moved by both unions
  CHECK(use(1).texture == 2);
  CHECK(use(1).transform->point({0, 0, 0}) == dvec3(0, 7, 5));
  CHECK(use(2).texture == 0);  // the default is not moved
  CHECK(use(2).transform.is_identity());
}

TEST_CASE("flatten: interior textures are inherited on their own", "[tracer][flatten]") {
  SceneBuilder b;
  b.scene.textures.resize(3);
  scene::Object child = ball();
  child.texture.texture = 1;
  scene::Object parent;
  parent.kind = NodeKind::union_;
  parent.children = {b.add(child)};
  parent.extras.edit().interior_texture.texture = 2;
  b.show(parent);
  const Flat f = flat(b);
  CHECK(f.surfaces[f.leaves[0].surface].texture.texture == 1);
  CHECK(f.surfaces[f.leaves[0].surface].interior_texture.texture == 2);
}

TEST_CASE("flatten: objects that look the same share a surface", "[tracer][flatten]") {
  SceneBuilder b;
  b.scene.textures.resize(2);
  for (int i = 0; i < 10; ++i) {
    scene::Object o = ball(i);
    o.texture.texture = static_cast<scene::TextureId>(i % 2);
    b.show(o);
  }
  CHECK(flat(b).surfaces.size() == 2);
}

TEST_CASE("flatten: children without an interior share their parent's", "[tracer][flatten]") {
  SceneBuilder b;
  b.scene.interiors.resize(2);
  scene::Object glass = ball();
  glass.interior = 1;
  const auto shared = b.add(glass);
  scene::Object parent;
  parent.kind = NodeKind::union_;
  parent.children = {b.add(ball()), shared, b.add(ball()), shared};
  parent.hollow = true;
  b.show(parent);
  b.show(ball());
  const Flat f = flat(b);
  REQUIRE(f.leaves.size() == 5);
  CHECK(f.leaves[0].inner_interior == f.leaves[2].inner_interior);
  CHECK(f.leaves[1].inner_interior != f.leaves[0].inner_interior);
  CHECK(f.leaves[3].inner_interior != f.leaves[1].inner_interior);  // the same block, another instance
  CHECK(f.leaves[4].inner_interior != f.leaves[0].inner_interior);
  CHECK(f.world.interiors[f.leaves[1].inner_interior].interior == 1);
  CHECK(f.world.interiors[f.leaves[0].inner_interior].interior == scene::none);
  CHECK(f.world.interiors[f.leaves[1].inner_interior].hollow);
  CHECK_FALSE(f.world.interiors[f.leaves[4].inner_interior].hollow);
}

TEST_CASE("flatten: lights move with the objects that hold them", "[tracer][flatten]") {
  SceneBuilder b;
  b.scene.lights.resize(2);
  b.scene.lights[0].position = {1, 0, 0};
  b.scene.lights[1].point_at = {0, 0, 2};
  scene::Object lamp;
  lamp.kind = NodeKind::light;
  lamp.light = 0;
  const auto inner = b.add(lamp);
  lamp.light = 1;
  const auto lone = b.add(lamp);
  scene::Object pair;
  pair.kind = NodeKind::union_;
  pair.children = {inner, b.add(ball()), inner};
  pair.transform = Transform::scale(dvec3(3));
  b.show(lone);
  b.show(pair);
  const Flat f = flat(b);
  REQUIRE(f.lights.size() == 3);
  CHECK(f.lights[0].point_at == dvec3(0, 0, 2));
  CHECK(f.lights[1].position == dvec3(3, 0, 0));
  CHECK(f.lights[2].position == dvec3(3, 0, 0));
  CHECK(f.leaves.size() == 1);
}

TEST_CASE("geometry: who sees what", "[tracer][geometry]") {
  SceneBuilder b;
  scene::Object ghost = ball();
  ghost.no_image = true;
  scene::Object vampire = ball(5);
  vampire.no_reflection = true;
  scene::Object clear = ball(10);
  clear.no_shadow = true;
  scene::Object all;
  all.kind = NodeKind::union_;
  all.children = {b.add(ghost), b.add(vampire), b.add(clear)};
  b.show(all);
  Geometry geometry = b.build();
  geometry.set_opaque({true});
  const auto scratch = geometry.make_scratch();
  const auto sees = [&](RayKind kind, double x) {
    Hit hit;
    return geometry.closest({{x, 0, -10}, {0, 0, 1}}, t_min, no_hit_depth, kind, hit, *scratch);
  };
  CHECK_FALSE(sees(RayKind::image, 0));
  CHECK(sees(RayKind::reflection, 0));
  CHECK(sees(RayKind::shadow, 0));
  CHECK(sees(RayKind::image, 5));
  CHECK_FALSE(sees(RayKind::reflection, 5));
  CHECK(sees(RayKind::image, 10));
  CHECK_FALSE(sees(RayKind::shadow, 10));
  CHECK(geometry.occluded({{0, 0, -10}, {0, 0, 1}}, t_shadow, 100, *scratch));
  CHECK_FALSE(geometry.occluded({{0, 0, -10}, {0, 0, 1}}, t_shadow, 9, *scratch));
  CHECK_FALSE(geometry.occluded({{10, 0, -10}, {0, 0, 1}}, t_shadow, 100, *scratch));
  CHECK_FALSE(geometry.has_translucent_shadows());
}

TEST_CASE("geometry: only opaque surfaces occlude, shadow rays meet the others too",
          "[tracer][geometry]") {
  SceneBuilder b;
  b.scene.textures.resize(2);
  scene::Object glass = ball();
  glass.texture.texture = 1;
  const auto first = b.add(glass);
  const auto hole = b.add(primitive("sphere", {0, 0, 0, 0.5}));
  b.show(b.csg(NodeKind::difference, {first, hole}));
  b.show(primitive("sphere", {0, 0, 10, 1}));
  Geometry geometry = b.build();
  const auto clear = geometry.surfaces()[0].texture.texture == 1 ? std::size_t{0} : std::size_t{1};
  std::vector<bool> opaque(geometry.surfaces().size(), true);
  opaque[clear] = false;
  geometry.set_opaque(opaque);
  const auto scratch = geometry.make_scratch();
  const Ray beside{{0.8, 0, -10}, {0, 0, 1}};
  const Ray through{{0.1, 0, -10}, {0, 0, 1}};
  Hit hit;
  CHECK(geometry.has_translucent_shadows());
  CHECK_FALSE(geometry.occluded(beside, t_shadow, 15, *scratch));
  CHECK(geometry.occluded(through, t_shadow, 15, *scratch));  // the wall of the hole is opaque
  REQUIRE(geometry.closest(beside, t_shadow, 15, RayKind::shadow, hit, *scratch));
  CHECK(hit.leaf == 0);
}

TEST_CASE("geometry: flags of operands do not count inside an intersection", "[tracer][geometry]") {
  SceneBuilder b;
  scene::Object ghost = ball();
  ghost.no_image = true;
  const auto first = b.add(ghost);
  b.show(b.csg(NodeKind::intersection, {first, b.add(ball(0.5))}));
  const Geometry geometry = b.build();
  Hit hit;
  CHECK(geometry.closest({{0.2, 0, -10}, {0, 0, 1}}, t_min, no_hit_depth, RayKind::image, hit,
                         *geometry.make_scratch()));
}

TEST_CASE("geometry: a plain union counts as its children, other solids as one body",
          "[tracer][geometry]") {
  SceneBuilder b;
  const auto one = b.add(ball());
  const auto two = b.add(ball(0.5));
  const auto all = b.csg(NodeKind::union_, {one, two});
  b.show(all);
  CHECK(bodies_at(b.build(), {0.2, 0, 0}) == 2);
  b.scene.objects[all].kind = NodeKind::merge;
  CHECK(bodies_at(b.build(), {0.2, 0, 0}) == 1);
  b.scene.objects[all].kind = NodeKind::union_;
  b.scene.objects[all].extras.edit().clips = {b.add(primitive("plane", {0, 1, 0, 0.5}))};
  CHECK(bodies_at(b.build(), {0.2, 0, 0}) == 1);
  CHECK(bodies_at(b.build(), {0.2, 0.7, 0}) == 0);
  CHECK(bodies_at(b.build(), {3, 0, 0}) == 0);
}

TEST_CASE("geometry: bodies are told in order of declaration", "[tracer][geometry]") {
  SceneBuilder b;
  b.show(ball());
  b.show(primitive("plane", {0, 1, 0, 1}));
  scene::Object hole = primitive("torus", {5, 1});
  hole.inverse = true;
  b.show(hole);
  b.show(ball(0.1));
  const Geometry geometry = b.build();
  std::vector<std::uint32_t> interiors;
  geometry.containing({0, 0, 0}, interiors, *geometry.make_scratch());
  CHECK(interiors == std::vector<std::uint32_t>{0, 1, 2, 3});
}

TEST_CASE("geometry: an object that cannot be rendered is an error with its name and place",
          "[tracer][geometry]") {
  SourceMap sources;
  sources.add("a.pov", "isosurface { }");
  Diagnostics diagnostics(sources);
  SceneBuilder b;
  b.scene.origins.push_back({{1, 10}, 0});
  scene::Object o;
  o.kind = NodeKind::unsupported;
  o.extras.edit().unsupported = "isosurface";
  o.origin = 1;
  const auto id = b.add(o);
  b.show(id);
  b.show(b.csg(NodeKind::union_, {id, b.add(ball())}));
  CHECK_FALSE(Geometry::build(b.scene, diagnostics).has_value());
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].code == Code::not_supported);
  CHECK(diagnostics.all()[0].span == Span{1, 10});
  CHECK(diagnostics.all()[0].message.find("isosurface") != std::string::npos);
}

TEST_CASE("geometry: objects of no size are nowhere", "[tracer][geometry]") {
  SceneBuilder b;
  b.show(primitive("cylinder", {0, 0, 0, 0, 1, 0, 0, 0}));
  b.show(primitive("torus", {1, -0.2}));
  const auto nothing = b.add(primitive("torus", {-1, 0.2}));
  b.show(b.csg(NodeKind::difference, {b.add(ball()), nothing}));
  const Geometry geometry = b.build();
  CHECK(bodies_at(geometry, {0, 0.5, 0}) == 1);
  Hit hit;
  REQUIRE(geometry.closest({{0, 0, -10}, {0, 0, 1}}, t_min, no_hit_depth, RayKind::image, hit,
                           *geometry.make_scratch()));
  CHECK(hit.t == Approx(9));
}

}  // namespace durer::tracer::test

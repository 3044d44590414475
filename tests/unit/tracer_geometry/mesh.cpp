// Meshes: the tree against a loop over all triangles, no cracks, insides, shared data.
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "tests/unit/tracer_geometry/scenes.h"
#include "tracer/accel/triangle_tree.h"
#include "tracer/primitives/facet.h"
#include "tracer/primitives/mesh_shape.h"
#include "tracer/primitives/store.h"

namespace durer::tracer::test {
namespace {

using MeshPtr = std::shared_ptr<scene::Mesh>;

MeshPtr soup(Random& random, int count, double size, dvec3 middle) {
  auto mesh = std::make_shared<scene::Mesh>();
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    const dvec3 p = middle + point_in_cube(random, 1);
    for (int k = 0; k < 3; ++k) mesh->vertices.push_back(vec3(p + point_in_cube(random, size)));
    mesh->faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// A ball of n x 2n quads cut in two, closed, around the origin.
MeshPtr ball(std::uint32_t n) {
  auto mesh = std::make_shared<scene::Mesh>();
  const std::uint32_t around = 2 * n;
  for (std::uint32_t i = 0; i <= n; ++i) {
    const double v = 3.14159265358979 * i / n;
    for (std::uint32_t j = 0; j < around; ++j) {
      const double u = 2 * 3.14159265358979 * j / around;
      const bool pole = i == 0 || i == n;
      const double r = pole ? 0 : std::sin(v);
      mesh->vertices.push_back(vec3(dvec3(r * std::cos(u), std::cos(v), r * std::sin(u))));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const std::uint32_t k = (j + 1) % around;
      const std::uint32_t a = i * around;
      const std::uint32_t b = a + around;
      mesh->faces.push_back({a + j, a + k, b + j});
      mesh->faces.push_back({a + k, b + k, b + j});
    }
  }
  mesh->inside_vector = {0.1, 1, 0.2};
  return mesh;
}

Corners corners_of(const scene::Mesh& mesh, std::size_t face) {
  return {mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2)};
}

scene::Object object_of(const MeshPtr& mesh, const Transform& transform = {}) {
  scene::Object o = primitive("mesh", {}, transform);
  o.extras.edit().mesh = mesh;
  return o;
}

}  // namespace

TEST_CASE("triangle tree: finds what a loop over all triangles finds", "[tracer][mesh]") {
  Random random(7);
  struct Case {
    int count;
    double size;
    dvec3 middle;
    double eye;
  };
  for (const Case& c : {Case{1, 1, dvec3(0.0), 3}, Case{3, 0.5, dvec3(0.0), 3},
                        Case{3000, 0.1, dvec3(0.0), 3}, Case{500, 0.3, dvec3(1000, -500, 2), 5},
                        Case{500, 0.3, dvec3(0.0), 1e4}}) {
    const MeshPtr mesh = soup(random, c.count, c.size, c.middle);
    const TriangleTree tree(*mesh);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
      Ray ray;
      ray.o = c.middle + c.eye * direction(random);
      ray.d = c.middle + point_in_cube(random, 1) - ray.o;  // not of unit length
      if (i % 7 == 0) {
        ray.d = {0, 0, i % 2 == 0 ? 2 : -2};
        ray.o = {c.middle.x + uniform(random, -1, 1), c.middle.y + uniform(random, -1, 1),
                 c.middle.z - c.eye * ray.d.z};
      }
      std::optional<TriangleTree::Hit> expected;
      std::size_t all = 0;
      for (std::uint32_t f = 0; f < mesh->faces.size(); ++f) {
        const auto t = corners_of(*mesh, f).depth(ray);
        if (t) ++all;
        if (t && *t >= 0 && (!expected || *t < expected->t)) expected = {*t, f};
      }
      const auto found = tree.nearest(ray, 0, 1e9);
      REQUIRE(found.has_value() == expected.has_value());
      if (found) {
        ++met;
        CHECK(found->t == Approx(expected->t).epsilon(1e-12));
        CHECK(found->face == expected->face);
      }
      CHECK(tree.any(ray, 0, 1e9).has_value() == expected.has_value());
      if (expected) CHECK_FALSE(tree.any(ray, 0, expected->t * (1 - 1e-9)));
      std::vector<TriangleTree::Hit> hits;
      tree.all(ray, -1e9, 1e9, hits);
      CHECK(hits.size() == all);
    }
    CHECK(met > 10);
  }
}

TEST_CASE("triangle tree: no ray slips out through an edge or a corner", "[tracer][mesh]") {
  const MeshPtr mesh = ball(12);
  const TriangleTree tree(*mesh);
  for (const vec3 v : mesh->vertices) {
    CHECK(tree.nearest({dvec3(0.0), dvec3(v)}, 1e-6, 10));
    CHECK(tree.nearest({{0.01, 0.02, -0.015}, dvec3(v) - dvec3(0.01, 0.02, -0.015)}, 1e-6, 10));
  }
  Random random(3);
  for (const scene::Triple& face : mesh->faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double s = uniform(random, 0, 1);
      const dvec3 on_edge =
          glm::mix(dvec3(mesh->vertices[face[i]]), dvec3(mesh->vertices[face[(i + 1) % 3]]), s);
      CHECK(tree.nearest({dvec3(0.0), on_edge}, 1e-6, 10));
    }
  }
}

TEST_CASE("triangle tree: triangles without area are never hit", "[tracer][mesh]") {
  scene::Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  mesh.faces = {{0, 1, 2}, {0, 0, 1}, {2, 2, 2}};
  const TriangleTree tree(mesh);
  CHECK_FALSE(tree.nearest({{1, 1, -5}, {0, 0, 1}}, 0, 100));
  CHECK(tree.bounds().empty());
  constexpr float infinity = std::numeric_limits<float>::infinity();
  mesh.vertices = {{0, 0, 0}, {infinity, 1, 1}, {2, -infinity, std::nanf("")}, {0, 1e30F, 0}};
  mesh.faces = {{0, 1, 2}, {0, 0, 1}, {2, 1, 0}, {0, 1, 3}};
  CHECK_FALSE(TriangleTree(mesh).nearest({{1, 1, -5}, {0, 0, 1}}, 0, 100));
  CHECK_FALSE(TriangleTree(scene::Mesh{}).nearest({{1, 1, -5}, {0, 0, 1}}, 0, 100));
}

TEST_CASE("mesh: its inside is what its faces enclose, whatever moves it", "[tracer][mesh]") {
  const MeshPtr mesh = ball(16);
  const Transform move = Transform::scale({2, 1, 0.5})
                             .then(Transform::rotate_deg({20, 30, 40}))
                             .then(Transform::translate({3, -1, 2}));
  const MeshShape shape(shared_mesh_data(mesh), move);
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const dvec3 p = point_in_cube(random, 1.1);
    const double r = glm::length(p);
    if (r > 0.96 && r < 1.01) continue;  // between the ball and its faces
    CHECK(shape.contains(p) == (r < 1));
    Crossings crossings;
    shape.crossings({p, direction(random)}, crossings);
    int depth = 0;
    for (const Crossing& c : crossings) {
      depth += c.side == Side::enter ? 1 : -1;
      CHECK((depth == 0 || depth == 1));
    }
    CHECK(depth == 0);
  }
}

TEST_CASE("mesh: without inside_vector it is a sheet", "[tracer][mesh]") {
  const MeshPtr mesh = ball(4);
  mesh->inside_vector = dvec3(0.0);
  const MeshShape shape(shared_mesh_data(mesh), {});
  Crossings crossings;
  shape.crossings({{0.1, 0.2, -5}, {0, 0, 1}}, crossings);
  REQUIRE(crossings.size() == 2);
  for (const Crossing& c : crossings) CHECK(c.side == Side::sheet);
  CHECK_FALSE(shape.contains(dvec3(0.0)));
}

TEST_CASE("mesh: the inside of one with a hole goes on along inside_vector", "[tracer][mesh]") {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->vertices = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
  mesh->faces = {{0, 1, 2}};
  mesh->inside_vector = {0, 1, 0};
  const MeshShape shape(shared_mesh_data(mesh), {});
  CHECK(shape.contains({0, -50, 0}));
  CHECK_FALSE(shape.contains({0, 0.1, 0}));
  CHECK(shape.inside_bounds().infinite());
  CHECK(shape.begins_inside({{0, 5, 0}, {0, 1, 0}}));
  CHECK_FALSE(shape.begins_inside({{0, 5, 0}, {0, -1, 0}}));
}

TEST_CASE("mesh: objects of one mesh share its tree as long as one lives", "[tracer][mesh]") {
  const MeshPtr mesh = ball(4);
  auto first = shared_mesh_data(mesh);
  CHECK(shared_mesh_data(mesh) == first);
  const std::weak_ptr<const MeshData> watch = first;
  first.reset();
  CHECK(watch.expired());
}

TEST_CASE("mesh: hits beyond the reach of its own units do not count", "[tracer][mesh]") {
  // One thousandth as large: 1e7 units of the mesh are 1e4 of the world (objects §3).
  const Geometry small = only(object_of(ball(4), Transform::scale(dvec3(1e-3))));
  const auto scratch = small.make_scratch();
  Hit hit;
  CHECK(small.closest({{1e-5, 2e-5, -9e3}, {0, 0, 1}}, t_min, no_hit_depth, RayKind::image, hit,
                      *scratch));
  CHECK_FALSE(small.closest({{1e-5, 2e-5, -1.1e4}, {0, 0, 1}}, t_min, no_hit_depth, RayKind::image,
                            hit, *scratch));
}

TEST_CASE("mesh: normals are mixed, then moved", "[tracer][mesh]") {
  // Oracle: trace(), objects §15.
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->vertices = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  for (const dvec3 n : {dvec3(-1, 0, -2), dvec3(1, 0, -2), dvec3(0, 1, -2)}) {
    mesh->normals.push_back(vec3(glm::normalize(n)));
  }
  mesh->faces = {{0, 1, 2}};
  mesh->normals_by_vertex = true;
  const auto hit_of = [](const scene::Object& o) {
    const Geometry g = only(o);
    const auto scratch = g.make_scratch();
    Hit hit;
    REQUIRE(g.closest({{0.1, 0.1, -5}, {0, 0, 1}}, t_min, no_hit_depth, RayKind::image, hit,
                      *scratch));
    return hit;
  };
  const Hit hit = hit_of(object_of(mesh, Transform::rotate_deg({0, 20, 0})));
  CHECK(hit.p.z == Approx(-0.0363970).margin(1e-7));
  CHECK(glm::length(hit.n - dvec3(-0.281198, 0.264808, -0.922391)) < 2e-6);
  // The same normal three times means a flat face.
  mesh->normals.assign(3, vec3(glm::normalize(dvec3(0.3, 0, -1))));
  CHECK(hit_of(object_of(mesh)).n == dvec3(0, 0, -1));
}

TEST_CASE("mesh: uv and textures follow the corners", "[tracer][mesh]") {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->uvs = {{0, 0}, {2, 0}, {0, 4}};
  mesh->faces = {{0, 1, 2}};
  mesh->uvs_by_vertex = true;
  mesh->textures = {5, 6, 7};
  mesh->face_textures = {{2, 1, 0}};
  const MeshShape shape(shared_mesh_data(mesh), {});
  const dvec2 uv = shape.uv({0.25, 0.5, 0}, 0);
  CHECK(uv.x == Approx(0.5));
  CHECK(uv.y == Approx(2));
  const TextureBlend blend = shape.textures({0.25, 0.5, 0}, 0);
  REQUIRE(blend.count == 3);
  CHECK(blend.parts[0].texture == 2);
  CHECK(blend.parts[0].weight == Approx(0.25));
  CHECK(blend.parts[2].texture == 0);
  CHECK(blend.parts[2].weight == Approx(0.5));
}

TEST_CASE("triangle: once moved, it faces the way the oracle turns it", "[tracer][triangle]") {
  // Oracle: trace() of a triangle before and after `translate 0.5*z`.
  const auto normal_of = [](const Transform& t) {
    const Geometry g = only(primitive("triangle", {1, -1, 0, -1, -1, 0, 0, 1, 0}, t));
    const auto scratch = g.make_scratch();
    Hit hit;
    REQUIRE(g.closest({{0.1, 0.1, -5}, {0, 0, 1}}, t_min, no_hit_depth, RayKind::image, hit,
                      *scratch));
    return hit.n;
  };
  CHECK(normal_of({}) == dvec3(0, 0, 1));
  CHECK(normal_of(Transform::translate({0, 0, 0.5})) == dvec3(0, 0, -1));
  CHECK(normal_of(Transform::scale({-1, 1, 1})) == dvec3(0, 0, 1));
}

}  // namespace durer::tracer::test

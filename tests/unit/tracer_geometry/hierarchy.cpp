// Embree with its single-precision boxes against a loop over all objects: the same hits, bit for
// bit.
#include "tests/unit/tracer_geometry/scenes.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer::test {
namespace {

/// Primitives of every kind and some solids, spread over `half`, around `middle`.
SceneBuilder jumble(std::uint64_t seed, int count, double half, dvec3 middle) {
  Random random(seed);
  SceneBuilder b;
  for (int i = 0; i < count; ++i) {
    const auto types = types_with_samples();
    const auto random_primitive = [&] {
      const auto& type = *types[random() % types.size()];
      const auto samples = type.samples();
      scene::Object o = primitive(type.name, samples[random() % samples.size()]);
      o.origin = o.type;  // tells which sort was hit
      o.transform = Transform::scale(dvec3(std::exp(uniform(random, -3, 1))))
                        .then(Transform::rotate_deg(point_in_cube(random, 180)))
                        .then(Transform::translate(middle + point_in_cube(random, half)));
      if (type.name == "plane") o.no_image = true;  // nothing could be seen behind all the planes
      return o;
    };
    if (i % 5 != 0) {
      b.show(random_primitive());
      continue;
    }
    const auto first = b.add(random_primitive());
    const auto second = b.add(random_primitive());
    b.show(
        b.csg(i % 2 == 0 ? scene::NodeKind::difference : scene::NodeKind::merge, {first, second}));
  }
  return b;
}

dvec3 axis_or_direction(Random& random) {
  if (random() % 4 != 0) return direction(random);
  dvec3 axis(0.0);
  axis[static_cast<int>(random() % 3)] = random() % 2 == 0 ? 1 : -1;
  return axis;
}

}  // namespace

TEST_CASE("hierarchy: Embree finds the hits of the linear scan", "[tracer][accel]") {
  struct Case {
    double half;
    dvec3 middle;
    double eye;  // distance of the rays' origins
  };
  const Case c = GENERATE(Case{10, {0, 0, 0}, 10}, Case{10, {5000, 0, -300}, 10},
                          Case{200, {0, 0, 0}, 1e5}, Case{0.05, {1, 2, 3}, 100});
  CAPTURE(c.half, c.eye);
  SceneBuilder b = jumble(static_cast<std::uint64_t>(c.eye), 300, c.half, c.middle);
  b.show(primitive("sphere", {0, 0, 0, 1e6}));  // a sky
  Geometry embree = b.build(Hierarchy::embree);
  Geometry linear = b.build(Hierarchy::linear);
  embree.set_opaque(std::vector<bool>(embree.surfaces().size(), true));
  linear.set_opaque(std::vector<bool>(linear.surfaces().size(), true));
  const auto embree_scratch = embree.make_scratch();
  const auto linear_scratch = linear.make_scratch();
  Random random(99);
  int hits = 0;
  int shadows = 0;
  for (int i = 0; i < 5000; ++i) {
    const dvec3 d = axis_or_direction(random);
    const Ray ray{c.middle + point_in_cube(random, c.half) - c.eye * d, d};
    Hit a;
    Hit e;
    const bool found = linear.closest(ray, t_min, no_hit_depth, RayKind::image, a, *linear_scratch);
    REQUIRE(embree.closest(ray, t_min, no_hit_depth, RayKind::image, e, *embree_scratch) == found);
    if (found) {
      ++hits;
      const auto type_of = [](const Geometry& g, const Hit& hit) {
        return primitive_types()[g.leaves()[hit.leaf].origin]->name;
      };
      CAPTURE(type_of(linear, a), type_of(embree, e), e.t - a.t);
      REQUIRE(e.t == a.t);
      REQUIRE(e.leaf == a.leaf);
      REQUIRE(e.n == a.n);
    }
    const double reach = c.eye + uniform(random, -1, 1) * c.half;
    const bool dark = linear.occluded(ray, t_shadow, reach, *linear_scratch);
    REQUIRE(embree.occluded(ray, t_shadow, reach, *embree_scratch) == dark);
    if (dark) ++shadows;
  }
  CHECK(hits > 1000);
  CHECK(shadows > 1000);
}

}  // namespace durer::tracer::test

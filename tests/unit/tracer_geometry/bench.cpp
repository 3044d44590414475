// Rays per second. Run with: test_tracer_geometry "[!benchmark]".
#include <ctime>

#include "tests/unit/tracer_geometry/scenes.h"

namespace durer::tracer::test {
namespace {

/// 60,000 spheres in a cube, as far apart as their size.
Geometry many_spheres() {
  Random random(7);
  SceneBuilder b;
  for (int i = 0; i < 60000; ++i) {
    const dvec3 c = point_in_cube(random, 40);
    b.show(primitive("sphere", {c.x, c.y, c.z, uniform(random, 0.2, 0.5)}));
  }
  Geometry geometry = b.build();
  geometry.set_opaque(std::vector<bool>(geometry.surfaces().size(), true));
  return geometry;
}

/// Camera rays of a 512 x 512 picture and one shadow ray from each hit. Returns hits.
int primary_and_shadow(const Geometry& geometry, dvec3 eye, dvec3 light, int& rays) {
  const dvec3 ahead = eye / -std::sqrt(eye.x * eye.x + eye.y * eye.y + eye.z * eye.z);
  const dvec3 up(0, -ahead.z, ahead.y);  // eyes lie in x = 0
  const auto look = [&](double x, double y) { return dvec3(x, 0, 0) - y * up + 0.8 * ahead; };
  const auto scratch = geometry.make_scratch();
  int lit = 0;
  constexpr int side = 512;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const dvec3 d = look((x + 0.5) / side - 0.5, 0.5 - (y + 0.5) / side);
      Hit hit;
      ++rays;
      if (!geometry.closest({eye, d / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z)}, t_min,
                            no_hit_depth, RayKind::image, hit, *scratch)) {
        continue;
      }
      const dvec3 to_light = light - hit.p;
      const double distance =
          std::sqrt(to_light.x * to_light.x + to_light.y * to_light.y + to_light.z * to_light.z);
      ++rays;
      if (!geometry.occluded({hit.p, to_light / distance}, t_shadow, distance - t_shadow,
                             *scratch)) {
        ++lit;
      }
    }
  }
  return lit;
}

void measure(const char* what, const Geometry& geometry, dvec3 eye, dvec3 light) {
  double best = 0;
  int lit = 0;
  for (int run = 0; run < 5; ++run) {
    int rays = 0;
    const std::clock_t start = std::clock();
    lit = primary_and_shadow(geometry, eye, light, rays);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    best = std::max(best, rays / seconds);
  }
  WARN(what << ": " << best / 1e6 << " million rays per second of CPU time, " << lit
            << " lit pixels");
  CHECK(lit > 0);
}

/// A slab with 1,800 holes: cylinders and cones by turns, on a grid.
Geometry drilled_slab() {
  SceneBuilder b;
  std::vector<scene::ObjectId> operands{b.add(primitive("box", {-30, -1, -15, 30, 0, 15}))};
  for (int x = 0; x < 60; ++x) {
    for (int z = 0; z < 30; ++z) {
      const double cx = x - 29.5;
      const double cz = z - 14.5;
      operands.push_back(b.add((x + z) % 2 == 0
                                   ? primitive("cylinder", {cx, -2, cz, cx, 1, cz, 0.35, 0})
                                   : primitive("cone", {cx, -2, cz, 0.1, cx, 1, cz, 0.45, 0})));
    }
  }
  b.show(b.csg(scene::NodeKind::difference, std::move(operands)));
  Geometry geometry = b.build();
  geometry.set_opaque(std::vector<bool>(geometry.surfaces().size(), true));
  return geometry;
}

}  // namespace

TEST_CASE("bench: a slab with 1800 holes", "[.][!benchmark][slab]") {
  measure("slab with 1,800 holes", drilled_slab(), {0, 20, -40}, {20, 40, -20});
}

TEST_CASE("bench: 60000 spheres", "[.][!benchmark][spheres]") {
  measure("60,000 spheres", many_spheres(), {0, 0, -100}, {200, 300, -200});
}

}  // namespace durer::tracer::test

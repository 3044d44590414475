// Sheets never lose what a line in them would meet, and few casters answer as the whole scene does.
#include "tracer/accel/sheet.h"

#include "tests/unit/tracer_geometry/scenes.h"
#include "tracer/accel/box_tree.h"

namespace durer::tracer::test {

TEST_CASE("sheet: holds every line in it", "[accel][sheet]") {
  Random random(11);
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const dvec3 tip = point_in_cube(random, 3);
    const dvec3 a = point_in_cube(random, 3);
    const dvec3 b = i % 7 == 0 ? a : i % 5 == 0 ? (a + tip) * 0.5 : point_in_cube(random, 3);
    const Sheet sheet({tip, a, b});
    const dvec3 lo = point_in_cube(random, 4);
    const Bounds3 box = BoxTree::grown({lo, lo + point_in_cube(random, 0.5) + 0.5});
    for (int k = 0; k < 20; ++k) {
      const dvec3 o = a + uniform(random, 0, 1) * (b - a);
      double from = 0;
      double to = 1;
      if (!BoxTree::clip(box, o, 1.0 / (tip - o), from, to)) continue;
      ++met;
      REQUIRE(sheet.meets(box));
    }
  }
  CHECK(met > 200);  // the test is about something
}

TEST_CASE("sheet: leaves out what is aside", "[accel][sheet]") {
  const Sheet sheet({dvec3(0, 10, 0), dvec3(0, 0, 0), dvec3(10, 0, 0)});
  CHECK(sheet.meets({{1, 1, -1}, {2, 2, 1}}));
  CHECK_FALSE(sheet.meets({{1, 1, 0.1}, {2, 2, 1}}));
  CHECK_FALSE(sheet.meets({{7, 7, -1}, {8, 8, 1}}));
  CHECK_FALSE(sheet.meets({{-2, 1, -1}, {-0.1, 2, 1}}));
}

TEST_CASE("casters: those of a sheet answer as the whole scene does", "[accel][sheet]") {
  Random random(12);
  SceneBuilder b;
  for (int i = 0; i < 12; ++i) {
    const dvec3 p = point_in_cube(random, 4);
    const char* const names[] = {"sphere", "box", "torus"};
    const std::vector<double> args[] = {
        {0, 0, 0, 0.8}, {-0.5, -0.5, -0.5, 0.5, 0.7, 0.9}, {0.7, 0.2}};
    const auto k = static_cast<std::size_t>(i % 3);
    b.show(primitive(names[k], args[k], Transform::translate(p)));
  }
  b.show(primitive("plane", {0, 1, 0, -4}));
  b.show(primitive("box", {-9, -9, -9, 9, 9, 9}));  // around everything
  Geometry geometry = b.build();
  geometry.set_opaque(std::vector<bool>(geometry.surfaces().size(), true));
  const auto scratch = geometry.make_scratch();
  std::vector<Caster> casters;
  int blocked = 0;
  int none = 0;
  for (int i = 0; i < 2000; ++i) {
    const dvec3 lamp = point_in_cube(random, 5);
    const dvec3 from = point_in_cube(random, 5);
    const dvec3 to = point_in_cube(random, 5);
    if (!geometry.casters(Sheet({lamp, from, to}), casters)) continue;
    if (casters.empty()) ++none;
    for (int k = 0; k < 8; ++k) {
      const dvec3 p = from + uniform(random, 0, 1) * (to - from);
      const double way = glm::length(lamp - p);
      const Ray ray{p, (lamp - p) / way};
      const bool dark = geometry.occluded(ray, t_shadow, way - t_shadow, *scratch);
      const auto found = geometry.way_between(casters, ray, t_shadow, way - t_shadow, *scratch);
      REQUIRE((found == Geometry::Way::blocked) == dark);
      if (dark) ++blocked;
    }
  }
  CHECK(blocked > 500);
  CHECK(none > 50);
}

}  // namespace durer::tracer::test

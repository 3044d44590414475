// `isosurface`, `parametric` and cameras of functions → the scene.
#include "functions/evaluate.h"
#include "support.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::interpreter::test;
using Kind = scene::Container::Kind;

namespace {

const scene::ObjectExtras& extras_of(const Run& r) {
  REQUIRE(r.errors == std::vector<std::string>{});
  REQUIRE(r.scene);
  return *r.scene->objects[r.scene->roots[0].object].extras;
}
const scene::Isosurface& isosurface_of(const Run& r) {
  REQUIRE(extras_of(r).isosurface != nullptr);
  return *extras_of(r).isosurface;
}
double value(const functions::FunctionRef& f, std::vector<double> arguments) {
  functions::Workspace w;
  return functions::evaluate(*f, arguments, w);
}

}  // namespace

TEST_CASE("isosurface: what is not said has the oracle's defaults", "[interpreter][isosurface]") {
  const Run r = run("isosurface { function { x + 2*y } }");
  const scene::Isosurface& s = isosurface_of(r);
  CHECK(value(s.function, {1, 2, 5}) == 5);
  CHECK(s.container.kind == Kind::box);
  CHECK(s.container.lo == dvec3(-1));
  CHECK(s.container.hi == dvec3(1));
  CHECK(s.threshold == 0);
  CHECK(s.accuracy == 0.001);
  CHECK(s.max_gradient == 1.1);
  CHECK(s.max_trace == 1);
  CHECK_FALSE(s.open);
}

TEST_CASE("isosurface: settings in any order, then modifiers", "[interpreter][isosurface]") {
  const Run r = run(
      "#declare F = function(x, y) { x*y }\n"
      "isosurface { function { F(x, z) } open accuracy 0.1 evaluate 5, 1.2, 0.9 threshold 1/4\n"
      "max_gradient 3 max_trace 4 contained_by { box { <1, 2, 3>, <-1, 5, 0> } } translate x }");
  const scene::Isosurface& s = isosurface_of(r);
  CHECK(value(s.function, {3, 0, 4}) == 12);
  CHECK(s.open);
  CHECK(s.accuracy == 0.1);
  CHECK(s.evaluate == dvec3(5, 1.2, 0.9));
  CHECK(s.threshold == 0.25);
  CHECK(s.max_gradient == 3);
  CHECK(s.max_trace == 4);
  CHECK(s.container.lo == dvec3(-1, 2, 0));
  CHECK(s.container.hi == dvec3(1, 5, 3));
  CHECK_FALSE(r.scene->objects[r.scene->roots[0].object].transform.is_identity());
}

TEST_CASE("isosurface: a sphere around it, and all its crossings", "[interpreter][isosurface]") {
  const Run r = run(
      "isosurface { function { x } contained_by { sphere { y, -2 } } all_intersections }");
  const scene::Isosurface& s = isosurface_of(r);
  CHECK(s.container.kind == Kind::sphere);
  CHECK(s.container.centre == dvec3(0, 1, 0));
  CHECK(s.container.radius == 2);
  CHECK(s.max_trace == 10);
}

TEST_CASE("isosurface: doubtful numbers are corrected with a warning", "[interpreter][isosurface]") {
  const Run r = run("isosurface { function { x } accuracy 0 max_gradient -1 max_trace 20 }");
  const scene::Isosurface& s = isosurface_of(r);
  CHECK(s.accuracy == 0.001);
  CHECK(s.max_gradient == 1.1);
  CHECK(s.max_trace == 10);
  CHECK(r.warnings.size() == 3);
}

TEST_CASE("isosurface: what cannot be meant is an error", "[interpreter][isosurface]") {
  CHECK(error_of("isosurface { contained_by { box { 0, 1 } } function { x } }") ==
        "D0201 at 1:14: expected `function` and its formula, found `contained_by`");
  CHECK(error_of("isosurface { function { x } contained_by { plane { y, 0 } } }") ==
        "D0201 at 1:44: expected `box` or `sphere`, found `plane`");
  CHECK(error_of("isosurface { function { x } no_shadow accuracy 1 }") ==
        "D0214 at 1:39: `isosurface` takes no `accuracy` here");
}

TEST_CASE("parametric: three functions of u and v, sorted ranges", "[interpreter][parametric]") {
  const Run r = run(
      "parametric { function { u } function { v }, function { u*v } <1, 0>, <0, 2>\n"
      "contained_by { sphere { 0, 3 } } max_gradient 2 accuracy 0.01 precompute 10 x, y, z }");
  const scene::ObjectExtras& e = extras_of(r);
  REQUIRE(e.parametric != nullptr);
  const scene::Parametric& s = *e.parametric;
  CHECK(value(s.functions[2], {3, 4}) == 12);
  CHECK(s.from == dvec2(0, 0));
  CHECK(s.to == dvec2(1, 2));
  CHECK(s.container.radius == 3);
  CHECK(s.accuracy == 0.01);
  CHECK(s.max_gradient == 2);
  CHECK(error_of("parametric { function { u } function { v } <0,0> <1,1> }") ==
        "D0201 at 1:44: expected three functions of u and v, for x, y and z, found a vector");
  CHECK(error_of("parametric { function{u} function{v} function{u} <0,0> <1,1> precompute 21 x }")
            .starts_with("D0302"));
}

TEST_CASE("camera: user_defined takes functions since 3.8", "[interpreter][camera]") {
  const Run r = run(
      "#version 3.8; global_settings { assumed_gamma 1 }\n"
      "camera { user_defined location { function { u } function { v } function { -5 } }\n"
      "direction { function { 0 } function { 0 } function { 1 } } translate x }",
      false);
  REQUIRE(r.errors == std::vector<std::string>{});
  const scene::Camera& c = r.scene->camera;
  CHECK(c.kind == scene::Camera::Kind::user_defined);
  CHECK(value(c.location_functions[1], {0.25, 0.5}) == 0.5);
  CHECK(value(c.direction_functions[2], {0, 0}) == 1);
  CHECK(c.transform->point({0, 0, 0}) == dvec3(1, 0, 0));
  CHECK(error_of("camera { user_defined }") != "no error");
}

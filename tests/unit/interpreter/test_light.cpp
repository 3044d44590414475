// Lamps, cameras, fog and rainbows → plain scene data.
#include "support.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::interpreter::test;

namespace {

std::string code_of(const std::string& text) { return error_of(text).substr(0, 5); }

scene::Light lamp(const std::string& items) {
  const Run r = run("light_source { <1, 2, 3> rgb 1 " + items + " }");
  CAPTURE(r.errors);
  REQUIRE(r.scene);
  return r.scene->lights.at(0);
}

scene::Camera camera(const std::string& items) {
  const Run r = run("camera { " + items + " }");
  CAPTURE(r.errors);
  REQUIRE(r.scene);
  return r.scene->camera;
}

}  // namespace

TEST_CASE("fog: settings in any order, colours and identifiers", "[interpreter][fog]") {
  const Run r = run(
      "#declare F = fog { rgbft <.1, .2, .3, .4, .5> distance 3 }\n"
      "fog { F fog_type 2 fog_offset 1 fog_alt .5 up 2*y rotate z*90 }\n"
      "fog { distance 5 color rgb 1 octaves 3 turb_depth .2 }");
  REQUIRE(r.scene);
  REQUIRE(r.scene->fogs.size() == 2);
  const scene::Fog& f = r.scene->fogs[0];
  CHECK(f.kind == scene::Fog::Kind::ground);
  CHECK(f.distance == 3);
  CHECK(f.colour.transmit == 0.5F);
  CHECK(f.offset == 1);
  CHECK(f.alt == 0.5);
  CHECK(f.up.x == Approx(-1));
  CHECK_FALSE(f.turbulent);
  CHECK(r.scene->fogs[1].turbulent);
  CHECK(r.scene->fogs[1].octaves == 3);
}

TEST_CASE("fog: what is wrong is said", "[interpreter][fog]") {
  CHECK(code_of("fog { distance 1 <1, 1, 1> }") == "D0204");
  CHECK(code_of("fog { distanse 1 }") == "D0214");
  CHECK(run("fog { 5 rgb 1 }").warnings.size() == 2);  // and that the scene is empty
  CHECK(run("fog { distance 5 rgb 1 translate y }").warnings.size() == 2);
  CHECK(run("fog { distance 5 rgb 1 fog_type 3 }").warnings.size() == 2);
}

TEST_CASE("rainbow: arcs, and what must be there", "[interpreter][rainbow]") {
  const Run r = run(
      "rainbow { direction 2*z angle 40 width 5 distance 100 arc_angle 120\n"
      "  color_map { [0 rgb x] [1 rgbt <0, 0, 1, 1>] } }");
  REQUIRE(r.scene);
  const scene::Rainbow& bow = r.scene->rainbows.at(0);
  CHECK(bow.direction == dvec3(0, 0, 1));
  CHECK(bow.arc_angle_deg == 120);
  CHECK(bow.falloff_angle_deg == 120);
  CHECK(bow.colours.size() == 2);
  CHECK(code_of("rainbow { angle 40 }") == "D0202");
  CHECK(code_of("rainbow { direction z up z }") == "D0401");
  CHECK(code_of("rainbow { direction z arc_angle 400 }") == "D0302");
  CHECK(code_of("rainbow { direction z arc_angle 40 falloff_angle 50 }") == "D0302");
}

TEST_CASE("lights: areas", "[interpreter][lights]") {
  const scene::Light l =
      lamp("area_light 2*x, 3*z, 4, 5.9 adaptive 1 jitter circular area_illumination");
  CHECK(l.has_area);
  CHECK(l.area.u == dvec3(2, 0, 0));
  CHECK(l.area.n2 == 5);
  CHECK(l.area.adaptive == 1);
  CHECK(l.area.jitter);
  CHECK(l.area.circular);
  CHECK(l.area.illumination);
  CHECK(lamp("area_light x, z, 3, 3 orient").area.circular);
  CHECK(code_of("light_source { 0 rgb 1 area_light x, z, 0, 3 }") == "D0302");
  CHECK(code_of("light_source { 0 rgb 1 area_light x, z, 1, 3 circular }") == "D0302");
}

TEST_CASE("lights: cylinders are parallel; their lengths have defaults", "[interpreter][lights]") {
  const scene::Light l = lamp("cylinder point_at y");
  CHECK(l.kind == scene::Light::Kind::cylinder);
  CHECK(l.parallel);
  CHECK(l.radius_deg == 0.75);
  CHECK(l.falloff_deg == 1);
}

TEST_CASE("lights: what they look like stands where they are by then", "[interpreter][lights]") {
  const Run r = run(
      "light_source { x rgb 1 translate y looks_like { sphere { 0, 1 } translate z } scale 2 }");
  REQUIRE(r.scene);
  const scene::Object& light = r.scene->objects[r.scene->roots[0].object];
  REQUIRE(light.children.size() == 1);
  const scene::Object& ball = r.scene->objects[light.children[0]];
  CHECK(ball.no_shadow);
  CHECK(ball.transform.then(light.transform)->point({0, 0, 0}) == dvec3(2, 2, 2));
  CHECK(code_of("light_source { 0 rgb 1 looks_like { sphere { 0, 1 } } looks_like { sphere { 0, 1 } } }") ==
        "D0402");
}

TEST_CASE("lights: groups", "[interpreter][lights]") {
  const Run r = run(
      "light_group { light_source { 0 rgb 1 } sphere { y, 1 } global_lights on translate x }");
  REQUIRE(r.scene);
  const scene::Object& group = r.scene->objects[r.scene->roots[0].object];
  CHECK(group.kind == scene::NodeKind::light_group);
  CHECK(group.children.size() == 2);
  CHECK(group.global_lights);
  CHECK(code_of("light_group { sphere { 0, 1 } pigment { rgb 1 } }") == "D0214");
}

TEST_CASE("cameras: kinds and their angles", "[interpreter][camera]") {
  using Kind = scene::Camera::Kind;
  CHECK(camera("fisheye angle 170").kind == Kind::fisheye);
  CHECK(camera("fisheye angle 170").angle_deg == 170);
  CHECK(camera("fisheye").angle_deg == 90);
  CHECK(camera("fisheye angle 170").direction == dvec3(0, 0, 1));
  CHECK(camera("cylinder 3").cylinder_type == 3);
  CHECK(camera("spherical").angle_deg == 360);
  CHECK(camera("spherical").vertical_angle_deg == 180);
  CHECK(camera("spherical angle 200").vertical_angle_deg == 100);
  CHECK(camera("spherical angle 200, 50").vertical_angle_deg == 50);
  CHECK(code_of("camera { cylinder 5 }") == "D0302");
}

TEST_CASE("cameras: lenses", "[interpreter][camera]") {
  const scene::Camera c =
      camera("location -5*z aperture 2 blur_samples 5, 20 focal_point 0 confidence .8 variance .1");
  CHECK(c.lens->aperture == 2);
  CHECK(c.lens->least_samples == 5);
  CHECK(c.lens->most_samples == 20);
  CHECK(c.lens->focal_distance == 5);
  CHECK(c.lens->confidence == 0.8);
  CHECK(camera("aperture 1 blur_samples 7").lens->focal_distance == 1);
  CHECK(camera("aperture 1 blur_samples 7 direction 2*z look_at 9*z").lens->focal_distance == 2);
  CHECK(code_of("camera { aperture 1 blur_samples 0 }") == "D0302");
  CHECK(code_of("camera { aperture 1 blur_samples 5, 4 }") == "D0302");
}

// Blocks → plain scene data.
#include "support.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::interpreter::test;

namespace {
const scene::Object& root(const Run& r, std::size_t i = 0) {
  return r.scene->objects[r.scene->roots[i].object];
}
const scene::Layer& top_layer(const Run& r, std::size_t i = 0) {
  return r.scene->textures[root(r, i).texture.texture].layers.back();
}
}  // namespace

TEST_CASE("scene: operands with and without commas", "[interpreter][objects]") {
  for (const char* text :
       {"sphere { <1,2,3>, 4 }", "sphere { <1,2,3> 4 }", "sphere { <1 2 3> 4 }"}) {
    const Run r = run(text);
    REQUIRE(r.scene);
    CHECK(root(r).args == SharedList<double>{1, 2, 3, 4});
  }
  CHECK(error_of("sphere { 0, 1, }").substr(0, 2) == "D0");
  CHECK(error_of("box { -1 -2 }").substr(0, 5) == "D0202");
  CHECK(root(run("cylinder { 0, y, 1 open }")).args.back() == 1);
  CHECK(error_of("cylinder { y, y, 1 }").substr(0, 5) == "D0401");
}

TEST_CASE("scene: a copy takes its own transforms and textures", "[interpreter][objects]") {
  const Run r =
      run("#declare S = sphere { 0, 1 pigment { rgb 1 } translate x }\n"
          "object { S translate y }\nobject { S texture { pigment { rgbt .5 } } }");
  REQUIRE(r.scene);
  CHECK(root(r, 0).transform->forward.t == dvec3(1, 1, 0));
  CHECK(root(r, 0).texture.transform->forward.t == dvec3(1, 1, 0));
  CHECK(r.scene->textures[root(r, 1).texture.texture].layers.size() == 2);
}

TEST_CASE("scene: a texture attached later is not moved", "[interpreter][textures]") {
  const Run r = run("sphere { 0, 1 translate x pigment { rgb 1 } translate y }");
  REQUIRE(r.scene);
  CHECK(root(r).texture.transform->forward.t == dvec3(0, 1, 0));
}

TEST_CASE("scene: pigments, lists and maps", "[interpreter][textures]") {
  Run r = run("sphere { 0, 1 pigment { checker rgb 1 scale 2 } }");
  REQUIRE(r.scene);
  CHECK(top_layer(r).pigment->entries.size() == 2);
  CHECK(top_layer(r).pigment->entries[0].colour.rgb == glm::vec3(1));
  CHECK(top_layer(r).pigment->entries[1].colour.rgb == glm::vec3(0, 1, 0));
  CHECK(top_layer(r).pigment->pattern->frequency == 0);
  r =
      run("sphere { 0, 1 pigment { gradient y color_map { [0, .5 color rgb 0 color rgb 1] [.5 rgb "
          "x filter .2] } frequency 2 sine_wave } }");
  REQUIRE(r.scene);
  const auto& p = *top_layer(r).pigment;
  REQUIRE(p.entries.size() == 3);
  CHECK(p.entries[2].colour.filter == 0.2F);
  CHECK(p.pattern->frequency == 2);
  CHECK(p.pattern->wave == scene::Wave::sine);
  CHECK(p.pattern->args == std::vector<double>{0, 1, 0});
}

TEST_CASE("scene: finishes", "[interpreter][textures]") {
  const Run r =
      run("#declare F = finish { phong .5 }\nsphere { 0, 1 finish { F diffuse .7, .2 reflection { "
          ".1, .9 fresnel } metallic } }");
  REQUIRE(r.scene);
  const auto& f = *top_layer(r).finish;
  CHECK(f.phong == 0.5F);
  CHECK(f.diffuse == 0.7F);
  CHECK(f.diffuse_back == 0.2F);
  CHECK(f.reflection_min.x == 0.1F);
  CHECK(f.reflection_max.x == 0.9F);
  CHECK(f.fresnel);
  CHECK(f.metallic == 1);
}

TEST_CASE("scene: #default acts from there on", "[interpreter][textures]") {
  const Run r =
      run("#default { finish { ambient 1 } pigment { rgb x } }\nsphere { 0, 1 }\nsphere { 0, 1 "
          "finish { phong 1 } }");
  REQUIRE(r.scene);
  CHECK(r.scene->textures[r.scene->roots[0].default_texture].layers[0].finish->ambient.x == 1);
  CHECK(top_layer(r, 1).finish->ambient.x == 1);
  CHECK(top_layer(r, 1).pigment->colour.rgb == glm::vec3(1, 0, 0));
}

TEST_CASE("scene: lights and their transforms", "[interpreter][lights]") {
  const Run r =
      run("light_source { <1,2,3> rgb .5 spotlight radius 10 falloff 20 tightness 2 point_at y "
          "fade_distance 4 fade_power 2 shadowless translate z }");
  REQUIRE(r.scene);
  const auto& l = r.scene->lights.at(0);
  CHECK(l.position == dvec3(1, 2, 3));
  CHECK(root(r).transform->forward.t == dvec3(0, 0, 1));
  CHECK(l.kind == scene::Light::Kind::spotlight);
  CHECK(l.falloff_deg == 20);
  CHECK(l.shadowless);
  CHECK(error_of("light_source { 0 rgb 1 radius 5 }").substr(0, 5) == "D0201");
}

TEST_CASE("scene: camera vectors after angle and look_at", "[interpreter][camera]") {
  const Run r = run("camera { location <0,0,-5> look_at 0 right x up y angle 90 }");
  REQUIRE(r.scene);
  const auto& c = r.scene->camera;
  CHECK(c.direction.z == Approx(0.5));
  CHECK(c.right.x == Approx(1));
  const Run o = run("camera { orthographic location <0,0,-6> look_at 0 angle 40 right x up y }");
  CHECK(o.scene->camera.right.x == Approx(2 * 6 * std::tan(20 * 3.14159265358979 / 180)));
}

TEST_CASE("scene: what is not supported fails only when it is used", "[interpreter][unsupported]") {
  const Run declared =
      run("#declare O = isosurface { function { x } contained_by { sphere { 0, 1 } } }\n"
          "#declare P = pigment { bozo turbulence 1 color_map { [0 rgb 1] [1 rgb 0] } }\nsphere { "
          "0, 1 }");
  CHECK(declared.scene);
  const Run used = run("sphere { 0, 1 pigment { bozo turbulence 1 } }");
  REQUIRE(used.scene);  // the tracer reports it, with its origin
  CHECK(top_layer(used).pigment->unsupported == "`bozo`");
}

TEST_CASE("scene: messages name the block and the place", "[interpreter][diagnostics]") {
  CHECK(error_of("sphere { 0, 1 finish { difuse 1 } }") ==
        "D0214 at 1:24: `finish` has no setting `difuse`");
  CHECK(error_of("camera { locaton 5 }") == "D0214 at 1:10: `camera` has no setting `locaton`");
  CHECK(error_of("sphere { 0, 1 pigment { chekcer } }") ==
        "D0214 at 1:25: `pigment` has no setting `chekcer`");
  CHECK(error_of("sphere { 0, 1 radius }") == "D0214 at 1:15: `sphere` takes no `radius` here");
  CHECK(error_of("sphere { 0, 1").substr(0, 5) == "D0102");
}

TEST_CASE("scene: background depends on the version", "[interpreter][background]") {
  CHECK(run("background { rgbt <.5,.25,.8,.3> }").scene->background.rgb.x == Approx(0.35));
  CHECK(run("#version 3.6; background { rgbt <.5,.25,.8,.3> }").scene->background.rgb.x == 0.5F);
}

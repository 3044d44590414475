// The oracle's values for lamps and shadows (shading §10.4).
#include "tests/unit/tracer_shading/shading_test.h"

using namespace durer;
using namespace durer::test;

namespace {

struct White : Wall {
  White() {
    scene::Finish f = dull();
    f.diffuse = 1;
    wall(plain(rgbft(1, 1, 1)), f);
  }
  scene::Light& lamp() { return scene.lights[0]; }
  // A body half-way to the lamp.
  scene::Object& blocker(std::string_view type, const Colour& c, const scene::Interior& i = {}) {
    const std::vector<double> args = type == "sphere"
                                         ? std::vector<double>{-15, 20, -25, 1}
                                         : std::vector<double>{-15, 20, -25, 0, 0, 1, 1, 0};
    return add(type, args, texture(plain(c), dull()), interior(i));
  }
};

}  // namespace

TEST_CASE("lights: fading with distance", "[tracer][lights]") {
  White s;
  s.lamp().fade_distance = 20;
  s.lamp().fade_power = 2;
  check_pixel(s.scene, vec3(0.104753F));
}

TEST_CASE("lights: the cone of a spotlight", "[tracer][lights]") {
  White s;
  s.lamp().kind = scene::Light::Kind::spotlight;
  s.lamp().radius_deg = 10;
  s.lamp().falloff_deg = 40;
  s.lamp().tightness = 3;
  s.lamp().point_at = {30, 0, 0};
  SECTION("cone") { check_pixel(s.scene, vec3(0.568582F)); }
  SECTION("parallel makes it shine everywhere") {
    s.lamp().parallel = true;
    check_pixel(s.scene, vec3(0.569802F));
  }
}

TEST_CASE("lights: a cylinder of light", "[tracer][lights]") {
  White s;
  s.lamp().kind = scene::Light::Kind::cylinder;
  s.lamp().position = {0, 0, -50};
  s.lamp().parallel = true;
  s.lamp().radius_deg = 3;
  s.lamp().falloff_deg = 10;
  s.lamp().tightness = 2;
  s.lamp().point_at = {6, 0, 0};
  check_pixel(s.scene, vec3(0.099855F));
}

TEST_CASE("lights: groups keep their lamps to themselves", "[tracer][lights]") {
  // The wall is outside; the body before it, which the camera sees, is in the group.
  White s;
  s.lamp().position = {0, 0, -50};
  s.lamp().colour = vec3(0.5F);
  const bool global = GENERATE(true, false);
  CAPTURE(global);
  scene::Object group;
  group.kind = scene::NodeKind::light_group;
  group.global_lights = global;
  scene::Light own;
  own.position = {0, 0, -20};
  own.colour = vec3(0.25F);
  s.scene.lights.push_back(own);
  scene::Object lamp;
  lamp.kind = scene::NodeKind::light;
  lamp.light = 1;
  scene::Object disc = s.blocker("disc", rgbft(1, 1, 1));
  disc.args = {0, 0, -1, 0, 0, 1, 1, 0};
  disc.texture = s.scene.objects[1].texture;  // the wall's
  s.scene.roots.pop_back();
  std::vector<scene::ObjectId> children;
  for (const scene::Object& o : {lamp, disc}) {
    s.scene.objects.push_back(o);
    children.push_back(static_cast<scene::ObjectId>(s.scene.objects.size() - 1));
  }
  group.children = children;
  s.root(group);
  SECTION("inside") { check_pixel(s.scene, vec3(global ? 0.75F : 0.25F)); }
  SECTION("outside, in the shadow of the group") {
    s.look_straight({3, 0, -5}, {0, 0, 1});
    const float cosine = 50 / std::sqrt(2509.0F);
    check_pixel(s.scene, vec3(0.5F * cosine), 1e-4);
  }
}

TEST_CASE("lights: shining through an object", "[tracer][lights]") {
  White s;
  s.lamp().position = {0, 0, -10};
  const double x = GENERATE(0.0, 3.0);
  scene::Object window;
  window.type = s.primitive("disc");
  window.args = {x, 0, -5, 0, 0, 1, 1, 0};
  s.scene.objects.push_back(window);
  s.lamp().projected_through = static_cast<scene::ObjectId>(s.scene.objects.size() - 1);
  SECTION("alone") {}
  SECTION("what is behind it casts no shadow") {
    s.add("disc", {0, 0, -7, 0, 0, 1, 1, 0}, s.texture(plain(rgbft(1, 1, 1)), dull())).no_image = true;
  }
  check_pixel(s.scene, vec3(x == 0 ? 1.0F : 0.0F));
}

TEST_CASE("lights: parallel light", "[tracer][lights]") {
  White s;
  s.lamp().parallel = true;
  s.lamp().point_at = {1, 2, 3};
  SECTION("plain") { check_pixel(s.scene, vec3(0.733989F)); }
  SECTION("faded") {
    s.lamp().fade_distance = 20;
    s.lamp().fade_power = 2;
    check_pixel(s.scene, vec3(0.108965F));
  }
}

TEST_CASE("lights: points behind a parallel lamp are lit without shadows", "[tracer][lights]") {
  White s;
  s.lamp().parallel = true;
  s.lamp().position = {0, 0, 50};
  s.lamp().point_at = {0, 0, 60};
  s.add("sphere", {0, 0, -20, 1}, s.texture(plain(rgbft(1, 1, 1)), dull()));
  check_pixel(s.scene, vec3(1.0F));
}

TEST_CASE("lights: negative light takes away", "[tracer][lights]") {
  White s;
  s.light({0, 0, -50}, vec3(-0.4F));
  check_pixel(s.scene, vec3(0.307103F));
}

TEST_CASE("lights: shadows of bodies", "[tracer][lights][shadow]") {
  White s;
  SECTION("opaque") {
    s.blocker("sphere", rgbft(1, 1, 1));
    check_pixel(s.scene, vec3(0.0F));
  }
  SECTION("of a shadowless lamp") {
    s.lamp().shadowless = true;
    s.blocker("sphere", rgbft(1, 1, 1));
    check_pixel(s.scene, vec3(0.707107F));
  }
  SECTION("of a body without shadow") {
    s.blocker("sphere", rgbft(1, 1, 1)).no_shadow = true;
    check_pixel(s.scene, vec3(0.707107F));
  }
  SECTION("filtering sphere, two surfaces") {
    s.blocker("sphere", rgbft(0.5F, 0.8F, 0.2F, 0.7F));
    check_pixel(s.scene, {0.086625F, 0.221744F, 0.013855F});
  }
  SECTION("filtering disc") {
    s.blocker("disc", rgbft(0.5F, 0.8F, 0.2F, 0.7F, 0.2F));
    check_pixel(s.scene, {0.388907F, 0.537407F, 0.240421F});
  }
  SECTION("caustics") {
    scene::Interior i;
    i.caustics = 0.1F;
    s.blocker("disc", rgbft(0.5F, 0.8F, 0.2F, 0.3F, 0.1F), i);
    check_pixel(s.scene, {0.213947F, 0.290959F, 0.136919F});
  }
}

TEST_CASE("lights: shadows fade with the depth inside", "[tracer][lights][shadow]") {
  White s;
  scene::Interior i;
  i.fade_distance = 1;
  i.fade_power = GENERATE(2.0, 1001.0);
  i.fade_colour = {0.5F, 0.2F, 0.1F};
  s.blocker("sphere", rgbft(1, 1, 1, 0, 1), i);
  check_pixel(s.scene, i.fade_power == 2 ? vec3(0.424262F, 0.254551F, 0.197986F)
                                         : vec3(0.260136F, 0.142763F, 0.116884F));
}

TEST_CASE("lights: a blocker nearer than a thousandth casts no shadow", "[tracer][shadow]") {
  White s;
  const double gap = GENERATE(0.0005, 0.002);
  CAPTURE(gap);
  // The lamp is frontal and the blocker seen edge-on from the camera's side: it is hidden.
  s.scene.lights[0].position = {0, 0, -50};
  scene::Object& o =
      s.add("disc", {0, 0, -gap, 0, 0, 1, 1, 0}, s.texture(plain(rgbft(1, 1, 1)), dull()));
  o.no_image = true;
  check_pixel(s.scene, vec3(gap < 0.001 ? 1.0F : 0.0F));
}

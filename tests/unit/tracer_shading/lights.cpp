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

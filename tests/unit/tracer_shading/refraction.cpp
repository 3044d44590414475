// The oracle's values for refraction, dispersion and fading (shading §10.2, §10.3, §10.7).
#include "tests/unit/tracer_shading/shading_test.h"

using namespace durer;
using namespace durer::test;

namespace {

// A plane below everything whose colour tells its z: (z + 50) / 100.
struct Ruler : Floor {
  Ruler() {
    scene::Pigment p;
    p.pattern.edit().type = pattern("gradient");
    p.pattern.edit().args = {0, 0, 1};
    p.entries = {{0, rgbft(0, 0, 0), scene::none}, {1, rgbft(1, 1, 1), scene::none}};
    p.pattern.edit().transform = Transform::scale({100, 100, 100}).then(Transform::translate({0, 0, -50}));
    add("plane", {0, 1, 0, -4}, texture(p, luminous()));
  }
  scene::InteriorId glass(double ior) {
    scene::Interior i;
    i.ior = ior;
    return interior(i);
  }
  const Colour clear = rgbft(1, 1, 1, 0, 1);
};

}  // namespace

TEST_CASE("refraction: a surface of water bends by Snell's law", "[tracer][refraction]") {
  Ruler s;
  s.floor(plain(s.clear), dull(), s.glass(1.5));
  check_pixel(s.scene, vec3(0.521386F));
}

TEST_CASE("refraction: beyond the critical angle all light returns", "[tracer][refraction]") {
  Ruler s;
  s.look({0, -3, -3}, {0, -2, -2}, 0.01);
  s.floor(plain(rgbft(1, 1, 1, 0, GENERATE(1.0F, 0.5F))), dull(), s.glass(1.5));
  check_pixel(s.scene, vec3(0.540002F));
}

TEST_CASE("refraction: dispersion splits light into bands", "[tracer][refraction][dispersion]") {
  Ruler s;
  scene::Interior i;
  i.ior = 1.5;
  i.dispersion = 1.2;
  i.dispersion_samples = 3;
  s.floor(plain(s.clear), dull(), s.interior(i));
  check_pixel(s.scene, {0.519493F, 0.521843F, 0.518303F});
}

TEST_CASE("refraction: fading follows the depth inside", "[tracer][refraction][fade]") {
  Floor s;
  scene::Interior i;
  i.fade_distance = 2;
  i.fade_power = GENERATE(1.0, 0.0);
  i.fade_colour = {0.5F, 0.2F, 0.1F};
  const auto glass = s.texture(plain(rgbft(1, 1, 1, 0, 1)), dull());
  s.add("box", {-10, -2, -10, 10, 0, 10}, glass, s.interior(i));
  check_pixel(s.scene, i.fade_power == 1 ? vec3(0.353552F, 0.132845F, 0.378241F)
                                         : vec3(0.375006F, 0.149996F, 0.439994F));
}

TEST_CASE("refraction: great fade powers mean Beer's law", "[tracer][refraction][fade]") {
  Floor s;
  scene::Interior i;
  i.fade_distance = 2;
  i.fade_power = 1001;
  i.fade_colour = {0.5F, 0.2F, 0.1F};
  scene::Finish f = dull();
  f.ambient = vec3(1.0F);
  const auto glass = s.texture(plain(rgbft(0.9F, 0.8F, 0.7F, 0.5F)), f);
  s.add("box", {-10, -2, -10, 10, 0, 10}, glass, s.interior(i));
  check_pixel(s.scene, {0.702419F, 0.572900F, 0.499947F});
}

TEST_CASE("refraction: bodies nest and overlap", "[tracer][refraction][containment]") {
  Ruler s;
  s.scene.settings.max_trace_level = 9;
  const auto clear = s.texture(plain(s.clear), dull());
  SECTION("nested") {
    s.add("box", {-20, -2, -20, 20, 0, 20}, clear, s.glass(1.3));
    s.add("box", {-20, -1.5, -20, 20, -0.5, 20}, clear, s.glass(1.6));
    check_pixel(s.scene, vec3(0.531411F));
  }
  SECTION("overlapping") {
    s.add("box", {-20, -2, -20, 20, 0, 20}, clear, s.glass(1.3));
    s.add("box", {-20, -3, -20, 20, -1, 20}, clear, s.glass(1.6));
    check_pixel(s.scene, vec3(0.526329F));
  }
}

TEST_CASE("refraction: eight bends need nine levels", "[tracer][refraction]") {
  Floor s;
  s.scene.settings.max_trace_level = GENERATE(8, 9);
  scene::Interior i;
  i.ior = 1.2;
  const auto clear = s.texture(plain(rgbft(1, 1, 1, 0, 1)), dull());
  for (int k = 0; k < 4; ++k) {
    s.add("box", {-50, -2.0 * k - 1, -50, 50, -2.0 * k, 50}, clear, s.interior(i));
  }
  check_pixel(s.scene, s.scene.settings.max_trace_level == 8 ? vec3(0.0F) : s.scene.background.rgb);
}

TEST_CASE("refraction: finish words speak for the interior", "[tracer][refraction]") {
  Ruler s;
  scene::Finish f = dull();
  f.ior = 1.5F;
  s.floor(plain(s.clear), f, s.glass(1.1));
  check_pixel(s.scene, vec3(0.521386F));
}

// The oracle's values for reflection and the trace limits (shading §10.2).
#include "tests/unit/tracer_shading/shading_test.h"

using namespace durer;
using namespace durer::test;

namespace {

struct Row {
  const char* name;
  void (*change)(scene::Finish&);
  float ior;
  vec3 expected;
};

scene::Finish mirror(float amount) {
  scene::Finish f = dull();
  f.reflection_min = f.reflection_max = vec3(amount);
  return f;
}

}  // namespace

TEST_CASE("reflection: each form gives the oracle's value", "[tracer][reflection]") {
  const auto row = GENERATE(values<Row>({
      {"constant",
       [](scene::Finish& f) { f = mirror(0.3F); },
       1,
       {0.149996F, 0.074998F, 0.239994F}},
      {"falloff",
       [](scene::Finish& f) {
         f.reflection_min = vec3(0.1F), f.reflection_max = vec3(0.9F), f.reflection_falloff = 2;
       },
       1,
       {0.084321F, 0.042161F, 0.134905F}},
      {"exponent",
       [](scene::Finish& f) { f = mirror(0.5F), f.reflection_exponent = 2; },
       1,
       {0.353552F, 0.250004F, 0.447211F}},
      {"metallic",
       [](scene::Finish& f) { f = mirror(0.5F), f.reflection_metallic = 0.8F; },
       1,
       {0.230518F, 0.086046F, 0.181888F}},
      {"fresnel between two colours",
       [](scene::Finish& f) {
         f.reflection_min = vec3(0.1F), f.reflection_max = vec3(0.9F), f.fresnel = true;
       },
       1.5F,
       {0.070100F, 0.035050F, 0.112154F}},
      {"fresnel from nothing",
       [](scene::Finish& f) { f.reflection_max = vec3(0.9F), f.fresnel = true; },
       1.5F,
       {0.022614F, 0.011307F, 0.036179F}},
  }));
  CAPTURE(row.name);
  Floor s;
  scene::Finish f = dull();
  row.change(f);
  scene::Interior glass;
  glass.ior = row.ior;
  s.floor(plain(rgbft(0.9F, 0.6F, 0.3F)), f, s.interior(glass));
  check_pixel(s.scene, row.expected, 2 * oracle_step);
}

TEST_CASE("reflection: conserve_energy takes from what shines through", "[tracer][reflection]") {
  Floor s;
  scene::Finish f = mirror(0.3F);
  f.conserve_energy = GENERATE(true, false);
  s.floor(plain(rgbft(0, 0, 0, 0, 1)), f);
  s.add("plane", {0, 1, 0, -5}, s.texture(plain(rgbft(0.2F, 0.4F, 0.6F)), luminous()));
  check_pixel(s.scene, f.conserve_energy ? vec3(0.289998F, 0.355001F, 0.659998F)
                                         : vec3(0.349996F, 0.474998F, 0.839994F));
}

TEST_CASE("reflection: rays below adc_bailout are not traced", "[tracer][reflection]") {
  const float amount = GENERATE(0.19F, 0.2F, 0.21F);
  CAPTURE(amount);
  Floor s;
  s.scene.settings.adc_bailout = 0.2F;
  s.floor(plain(rgbft(0, 0, 0)), mirror(amount));
  check_pixel(s.scene, (amount < 0.2F ? 0.0F : amount) * s.scene.background.rgb);
}

TEST_CASE("reflection: facing mirrors stop at the trace level", "[tracer][reflection]") {
  const std::vector<float> expected{0.100008F, 0.149996F, 0.175006F, 0.187503F,
                                    0.193744F, 0.196872F, 0.198444F};
  const int level = GENERATE(range(1, 8));
  CAPTURE(level);
  SceneBuilder s(tracer::registry());
  s.look_straight({0, 0, 0}, {0, 0, 1});
  s.scene.settings.max_trace_level = level;
  s.scene.settings.adc_bailout = 0;
  scene::Finish f = mirror(0.5F);
  f.emission = vec3(0.1F);
  const auto t = s.texture(plain(rgbft(1, 1, 1)), f);
  s.add("plane", {0, 0, 1, 5}, t);
  s.add("plane", {0, 0, 1, -5}, t);
  check_pixel(s.scene, vec3(expected[level - 1]));
}

TEST_CASE("reflection: a mirror needs a second level", "[tracer][reflection]") {
  const int level = GENERATE(1, 2);
  Floor s;
  s.scene.settings.max_trace_level = level;
  s.floor(plain(rgbft(0, 0, 0)), mirror(1));
  check_pixel(s.scene, level == 1 ? vec3(0.0F) : s.scene.background.rgb);
}

TEST_CASE("reflection: straight transmission costs no level", "[tracer][transmission]") {
  Floor s;
  s.scene.settings.max_trace_level = 2;
  const auto glass = s.texture(plain(rgbft(1, 1, 1, 0, 1)), dull());
  for (int i = 0; i < 8; ++i) s.add("plane", {0, 1, 0, -1.0 * i}, glass);
  check_pixel(s.scene, s.scene.background.rgb);
}

TEST_CASE("reflection: a mirrored background is opaque", "[tracer][reflection][alpha]") {
  Floor s;
  s.scene.background = rgbft(0.5F, 0.25F, 0.8F, 0, 0.3F);
  SECTION("in a mirror") {
    s.floor(plain(rgbft(0, 0, 0)), mirror(1));
    const glm::vec4 p = pixel(s.scene, true);
    CHECK(p.y == Approx(0.25));
    CHECK(p.w == 1);
  }
  SECTION("without alpha, transmit does not count") {
    const glm::vec4 p = pixel(s.scene, false);
    CHECK(p.y == Approx(0.25));
    CHECK(p.w == 1);
  }
  SECTION("seen directly") {
    const glm::vec4 p = pixel(s.scene, true);
    CHECK(p.y == Approx(0.25 * 0.7));
    CHECK(p.w == Approx(0.7));
  }
  SECTION("through a luminous film") {
    s.scene.background = rgbft(0, 0, 0, 0, 1);
    s.floor(plain(rgbft(0.9F, 0.6F, 0.3F, 0, 0.4F)), luminous());
    const glm::vec4 p = pixel(s.scene, true);
    CHECK(p.x == Approx(0.9 * 0.6));
    CHECK(p.w == Approx(0.6));
  }
}

// The oracle's values for the surface model (shading §10.1).
#include <cmath>

#include "tests/unit/tracer_shading/shading_test.h"
#include "tracer/shading/power.h"

using namespace durer;
using namespace durer::test;

namespace {

const Colour ochre = rgbft(0.8F, 0.4F, 0.2F);

struct Row {
  const char* name;
  void (*change)(scene::Finish&);
  vec3 expected;
};

scene::Finish diffuse(float k) {
  scene::Finish f = dull();
  f.diffuse = k;
  return f;
}

}  // namespace

TEST_CASE("finish: each term gives the oracle's value", "[tracer][finish]") {
  const auto row = GENERATE(values<Row>({
      {"diffuse", [](scene::Finish& f) { f.diffuse = 0.6F; }, {0.339406F, 0.169711F, 0.084855F}},
      {"brilliance",
       [](scene::Finish& f) { f.diffuse = 0.6F, f.brilliance = 2.5F; },
       {0.201816F, 0.100908F, 0.050446F}},
      {"default", [](scene::Finish& f) { f = {}; }, {0.419409F, 0.209705F, 0.104860F}},
      {"phong", [](scene::Finish& f) { f.phong = 0.7F, f.phong_size = 5; }, vec3(0.123751F)},
      {"specular", [](scene::Finish& f) { f.specular = 0.7F, f.roughness = 0.1F; },
       vec3(0.317144F)},
      {"metallic specular",
       [](scene::Finish& f) { f.specular = 0.7F, f.roughness = 0.1F, f.metallic = 0.6F; },
       {0.280079F, 0.205966F, 0.168917F}},
      {"emission",
       [](scene::Finish& f) {
         f.emission = {0.3F, 0.2F, 0.1F};
       },
       {0.239994F, 0.080003F, 0.020005F}},
      {"irid",
       [](scene::Finish& f) { f.diffuse = 0.6F, f.irid = 0.35F, f.irid_thickness = 0.5F; },
       {0.362142F, 0.132265F, 0.090089F}},
  }));
  CAPTURE(row.name);
  scene::Finish f = dull();
  row.change(f);
  Wall s;
  s.wall(plain(ochre), f);
  check_pixel(s.scene, row.expected);
}

TEST_CASE("finish: ambient light multiplies ambient", "[tracer][finish]") {
  Wall s;
  scene::Finish f = dull();
  f.ambient = vec3(0.5F);
  s.scene.settings.ambient_light = {0.5F, 1, 2};
  s.wall(plain(ochre), f);
  check_pixel(s.scene, vec3(0.2F));
}

TEST_CASE("finish: opacity of a filtering pigment follows the version", "[tracer][finish]") {
  Wall s;
  s.scene.background = rgbft(0, 0, 0);
  s.wall(plain(rgbft(0.8F, 0.4F, 0.2F, 0.3F)), diffuse(0.6F));
  SECTION("3.7") { check_pixel(s.scene, {0.237583F, 0.118791F, 0.059403F}); }
  SECTION("3.6") {
    s.scene.settings.effective_version = 360;
    check_pixel(s.scene, {0.257954F, 0.128969F, 0.064485F});
  }
}

TEST_CASE("finish: a layer filters everything below it", "[tracer][finish][layers]") {
  Wall s;
  const scene::Layer below{plain(rgbft(0.1F, 0.2F, 0.9F)), diffuse(1), {}};
  const scene::Layer above{plain(rgbft(0.8F, 0.4F, 0.2F, 0, 0.5F)), diffuse(0.6F), {}};
  s.add("plane", {0, 0, 1, 0}, s.layers({below, above}));
  check_pixel(s.scene, {0.205066F, 0.155566F, 0.360632F});
}

TEST_CASE("finish: a lamp behind lights the back only where asked to", "[tracer][finish]") {
  Wall s;
  s.scene.lights[0].position = {-30, 40, 50};
  scene::Finish f = diffuse(0.6F);
  scene::Object& disc =
      s.add("disc", {0, 0, 0, 0, 0, -1, 5, 0}, s.texture(plain(rgbft(1, 1, 1)), f));
  SECTION("plain") { check_pixel(s.scene, vec3(0.0F)); }
  SECTION("diffuse back") {
    s.scene.textures[0].layers[0].finish.edit().diffuse_back = 0.3F;
    check_pixel(s.scene, vec3(0.212131F));
  }
  SECTION("double_illuminate") {
    disc.double_illuminate = true;
    check_pixel(s.scene, vec3(0.424262F));
  }
}

TEST_CASE("finish: crand darkens by up to its amount, the same in every run", "[tracer][finish]") {
  Wall s;
  s.scene.lights[0].position = {0, 0, -1000};
  scene::Finish f = diffuse(0.5F);
  f.crand = 0.2F;
  s.wall(plain(rgbft(1, 1, 1)), f);
  const float first = pixel(s.scene).x;
  CHECK(first <= 0.5F);
  CHECK(first >= 0.3F);
  CHECK(pixel(s.scene).x == first);
}

TEST_CASE("finish: a lit sphere matches the oracle's 16-bit pixels", "[tracer][finish]") {
  SceneBuilder s(tracer::registry());
  s.look({0, 0, -5}, {0, 0, 0}, 40);
  s.light({10, 20, -30}, {1, 0.9F, 0.8F});
  scene::Finish f = dull();
  f.ambient = vec3(0.1F);
  f.diffuse = 0.65F;
  f.phong = 0.8F;
  f.phong_size = 30;
  s.add("sphere", {0, 0, 0, 1}, s.texture(plain(rgbft(0.7F, 0.3F, 0.2F)), f));
  const auto c = compiled(s.scene);
  tracer::RenderOptions options;
  options.width = options.height = 8;
  const auto r = tracer::render(*c, options);
  struct Known {
    int x, y;
    vec3 code;
  };
  for (const Known& k : {Known{3, 3, {28889, 11348, 6874}}, Known{4, 3, {60914, 38593, 30742}},
                         Known{4, 2, {34291, 13424, 8101}}, Known{5, 4, {24722, 9732, 5913}}}) {
    CAPTURE(k.x, k.y);
    for (int i = 0; i < 3; ++i) {
      CHECK(r.image.at(k.x, k.y)[i] * 65535 == Approx(k.code[i]).margin(1.1).epsilon(0));
    }
  }
}

TEST_CASE("finish: powers of whole exponents are the C library's in single precision",
          "[tracer][finish]") {
  const float exponent = GENERATE(1.0F, 2.0F, 3.0F, 5.0F, 40.0F, 50.0F, 100.0F, 255.0F, 256.0F,
                                  257.0F, 0.5F, 2.5F, 0.0F);
  const tracer::Exponent e(exponent);
  CAPTURE(exponent);
  for (int i = 0; i <= 1000; ++i) {
    const double x = i / 1000.0;
    const double expected = std::pow(x, double{exponent});
    REQUIRE(e.of(x) == Approx(expected).margin(1e-300).epsilon(1.2e-16 * (exponent + 2)));
    // One place in some ten million may be rounded the other way; none of these is.
    if (expected > 1e-30) REQUIRE(static_cast<float>(e.of(x)) == static_cast<float>(expected));
  }
}

// The oracle's values for lamps of some extent (shading §10.4).
#include "tests/unit/tracer_shading/shading_test.h"
#include "tracer/lights/light.h"

using namespace durer;
using namespace durer::test;

namespace {

// A lamp of 4 x 4 at z = -10; a disc half-way, to which one sample is open if
// (x/2 - 0.3)² + (y/2 - 0.2)² >= 0.64.
struct Lit : Wall {
  Lit() {
    scene::Finish f = dull();
    f.diffuse = 1;
    wall(plain(rgbft(1, 1, 1)), f);
    add("disc", {0.3, 0.2, -5, 0, 0, 1, 0.8, 0}, texture(plain(rgbft(1, 1, 1)), dull())).no_image = true;
    scene::Light& lamp = scene.lights[0];
    lamp.position = {0, 0, -10};
    lamp.has_area = true;
    lamp.area.u = {4, 0, 0};
    lamp.area.v = {0, 4, 0};
  }
  scene::LightArea& area(int n1, int n2) {
    scene.lights[0].area.n1 = n1;
    scene.lights[0].area.n2 = n2;
    return scene.lights[0].area;
  }
};

}  // namespace

TEST_CASE("area lights: grids", "[tracer][lights][area]") {
  Lit s;
  SECTION("5 x 5") {
    s.area(5, 5);
    check_pixel(s.scene, vec3(0.56249F));
  }
  SECTION("4 x 4") {
    s.area(4, 4);
    check_pixel(s.scene, vec3(0.75F));
  }
  SECTION("5 x 1") {
    s.area(5, 1);
    check_pixel(s.scene, vec3(0.37501F));
  }
  SECTION("8 x 6") {
    s.area(8, 6);
    check_pixel(s.scene, vec3(0.71875F));
  }
}

TEST_CASE("area lights: adaptive sampling stops where corners agree", "[tracer][lights][area]") {
  Lit s;
  SECTION("only corners") {
    s.area(5, 5).adaptive = 0;
    check_pixel(s.scene, vec3(1.0F));
  }
  SECTION("one level") {
    s.area(9, 9).adaptive = 1;
    check_pixel(s.scene, vec3(0.53906F));
  }
}

TEST_CASE("area lights: round", "[tracer][lights][area]") {
  Lit s;
  s.area(5, 5).circular = true;
  check_pixel(s.scene, vec3(0.45313F));
}

TEST_CASE("area lights: the whole area shines", "[tracer][lights][area]") {
  Lit s;
  s.area(5, 5).illumination = true;
  check_pixel(s.scene, vec3(0.55169F));
}

TEST_CASE("area lights: jitter agrees with the oracle in the mean", "[tracer][lights][area]") {
  // 0.5391 is the mean of the oracle's four pixels that the document has; each varies by about 0.07.
  Lit s;
  s.area(5, 5).jitter = true;
  const tracer::CompiledScenePtr c = compiled(s.scene);
  tracer::RenderOptions options;
  options.width = options.height = 16;
  options.threads = 1;
  const tracer::RenderResult r = tracer::render(*c, options);
  double sum = 0;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) sum += static_cast<double>(r.image.at(x, y)[0]);
  }
  CHECK(sum / 256 == Approx(0.5391).margin(0.04));
}

TEST_CASE("area lights: oriented ones face the lit point", "[tracer][lights][area]") {
  scene::LightArea a;
  a.u = {4, 0, 0};
  a.v = {0, 4, 0};
  a.n1 = a.n2 = 5;
  a.circular = a.orient = true;
  const dvec3 l = glm::normalize(dvec3(1, 2, GENERATE(-3.0, 900.0)));
  for (const double u : {0.0, 1.0, 4.0}) {
    const dvec3 offset = tracer::area_offset(a, u, 1, l);
    CHECK(std::abs(glm::dot(offset, l)) < 1e-12);
    CHECK(glm::length(offset) <= 2.01);
  }
}

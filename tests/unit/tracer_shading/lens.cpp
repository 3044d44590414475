// Focal blur (shading §2.7, §10.7).
#include "tracer/film/lens.h"

#include "tests/unit/tracer_shading/shading_test.h"
#include "tracer/chi_square.h"
#include "tracer/film/lens_points.h"

using namespace durer;
using namespace durer::test;

TEST_CASE("lens: chi-square quantiles are those of tables", "[tracer][lens]") {
  // Abramowitz and Stegun, table 26.8.
  CHECK(tracer::chi_square_exceeded(0.9, 1) == Approx(0.0157908).epsilon(1e-5));
  CHECK(tracer::chi_square_exceeded(0.9, 10) == Approx(4.86518).epsilon(1e-6));
  CHECK(tracer::chi_square_exceeded(0.05, 3) == Approx(7.81473).epsilon(1e-6));
  CHECK(tracer::chi_square_exceeded(0.5, 100) == Approx(99.3341).epsilon(1e-6));
}

TEST_CASE("lens: points fill a disc evenly", "[tracer][lens]") {
  const int count = GENERATE(1, 3, 7, 12, 19, 37, 100, 500);
  CAPTURE(count);
  const tracer::LensPoints made = tracer::round_lens(count);
  REQUIRE(static_cast<int>(made.points.size()) == count);
  dvec2 mean(0.0);
  for (const dvec2 p : made.points) {
    CHECK(glm::dot(p, p) <= 0.2501);
    mean += p / static_cast<double>(count);
  }
  if (count >= 7) CHECK(glm::length(mean) < 0.06);
}

TEST_CASE("lens: bokeh leaves dark parts of the lens out", "[tracer][lens]") {
  scene::Pigment p;
  const SceneBuilder b(tracer::registry());
  p.pattern.edit().type = b.pattern("gradient");
  p.pattern.edit().args = {1, 0, 0};
  p.entries = {{0.5F, rgbft(0, 0, 0)}, {0.5F, rgbft(1, 1, 1)}};
  const tracer::LensPoints made = tracer::bokeh_lens(40, p, {});
  REQUIRE(made.points.size() == 40);
  int dark = 0;
  for (const dvec2 q : made.points) dark += q.x < 0 ? 1 : 0;
  CHECK(dark <= 3);
}

TEST_CASE("lens: what is in focus stays sharp", "[tracer][lens]") {
  // A wall of stripes at the focal distance; a stripe is wider than a pixel's samples reach.
  SceneBuilder s(tracer::registry());
  scene::Pigment p;
  p.pattern.edit().type = s.pattern("gradient");
  p.pattern.edit().args = {1, 0, 0};
  p.entries = {{0.5F, rgbft(0, 0, 0)}, {0.5F, rgbft(1, 1, 1)}};
  s.add("plane", {0, 0, -1, -10}, s.texture(p, luminous()));
  s.look({0.75, 0, 0}, {0.75, 0, 1}, 0.1);
  scene::Lens l;
  l.aperture = 2;
  l.most_samples = 19;
  l.variance = 0;
  SECTION("in focus") {
    l.focal_distance = 10;
    s.scene.camera.lens = scene::Lens(l);
    check_pixel(s.scene, vec3(1.0F));
  }
  SECTION("out of focus") {
    l.focal_distance = 3;
    s.scene.camera.lens = scene::Lens(l);
    const float seen = pixel(s.scene).x;
    CHECK(seen > 0.3F);
    CHECK(seen < 0.7F);
  }
}

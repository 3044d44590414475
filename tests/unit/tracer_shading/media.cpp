// Media along a ray: the oracle's values for slabs, and the parts the walk is made of
// (participating-and-global §1.16).
#include <cmath>
#include <numeric>

#include "tests/unit/tracer_shading/shading_test.h"
#include "tracer/chi_square.h"
#include "tracer/transport/media.h"

using namespace durer;
using namespace durer::test;

namespace {

// A clear slab of thickness 2 in front of a luminous wall, looked at straight.
struct Slab : SceneBuilder {
  explicit Slab(vec3 behind = vec3(1.0F)) : SceneBuilder(tracer::registry()) {
    look_straight({0, 0, -5}, {0, 0, 1});
    add("plane", {0, 0, 1, 3}, texture(plain({behind, 0, 0}), luminous())).inverse = true;
    scene.objects.back().hollow = true;
  }
  void fill(std::vector<scene::Media> media) {
    scene::Interior inside;
    inside.media = std::move(media);
    scene::Object& slab = add("box", {-3, -3, -1, 3, 3, 1},
                              texture(plain(rgbft(1, 1, 1, 0, 1)), dull()), interior(inside));
    slab.hollow = true;
  }
  // A lamp behind the camera; light falls straight on.
  void lamp() {
    scene::Light& l = light({0, 0, -10});
    l.parallel = true;
    l.point_at = dvec3(0.0);
  }
};

scene::Media scattering() {
  scene::Media m;
  m.scattering = vec3(0.3F);
  return m;
}

scene::Media grey_absorption(float by) {
  scene::Media m;
  m.absorption = vec3(by);
  return m;
}

}  // namespace

TEST_CASE("media: absorption follows Beer's law", "[tracer][media]") {
  Slab s;
  scene::Media m;
  m.absorption = {0.5F, 1, 0.2F};
  s.fill({m});
  check_pixel(s.scene, {0.36788F, 0.13534F, 0.67032F});
}

TEST_CASE("media: densities multiply, media add up", "[tracer][media]") {
  Slab s;
  scene::Media m = grey_absorption(0.5F);
  m.densities = {plain(rgbft(0.5F, 0.5F, 0.5F)), plain(rgbft(1, 0.5F, 0.2F))};
  s.fill({m, grey_absorption(0.25F)});
  check_pixel(s.scene, {0.36788F, 0.47237F, 0.54881F});
}

TEST_CASE("media: emission is a left sum over the steps of method 3", "[tracer][media]") {
  Slab s;
  scene::Media m = grey_absorption(1);
  m.emission = {0.5F, 0.1F, 0.2F};
  s.fill({m});
  check_pixel(s.scene, {0.6437F, 0.2370F, 0.3387F}, 5e-5);
}

TEST_CASE("media: each method and count of samples gives the oracle's value", "[tracer][media]") {
  struct Row {
    const char* name;
    void (*change)(scene::Media&);
    float expected;
  };
  const auto row = GENERATE(values<Row>({
      {"plain", [](scene::Media&) {}, 0.3800F},
      {"ten intervals", [](scene::Media& m) { m.intervals = 10; }, 0.3526F},
      {"a hundred samples", [](scene::Media& m) { m.min_samples = m.max_samples = 100; }, 0.3531F},
      {"stratified",
       [](scene::Media& m) { m.method = 2, m.intervals = 10, m.min_samples = m.max_samples = 5; },
       0.3494F},
  }));
  CAPTURE(row.name);
  Slab s(vec3(0.0F));
  s.lamp();
  scene::Media m = scattering();
  row.change(m);
  s.fill({m});
  check_pixel(s.scene, vec3(row.expected), 5e-5);
}

TEST_CASE("media: random samples agree in the mean", "[tracer][media]") {
  Slab s(vec3(0.0F));
  s.lamp();
  scene::Media m = scattering();
  m.method = 1;
  m.intervals = 10;
  m.min_samples = m.max_samples = 400;
  s.fill({m});
  check_pixel(s.scene, vec3(0.3494F), 3e-4);
}

TEST_CASE("media: a body that is not hollow keeps them out", "[tracer][media]") {
  Slab s;
  s.fill({grey_absorption(1)});
  s.add("sphere", {0, 0, -5, 1}, s.texture(plain(rgbft(1, 1, 1, 0, 1)), dull()));
  check_pixel(s.scene, vec3(std::exp(-2.0F)));  // the camera's ball is left before the slab
  s.add("sphere", {0, 0, 0, 9}, s.texture(plain(rgbft(1, 1, 1, 0, 1)), dull()));
  check_pixel(s.scene, vec3(1.0F));
}

TEST_CASE("media: shadowless lamps do not light them", "[tracer][media]") {
  Slab s(vec3(0.0F));
  s.lamp();
  s.scene.lights.back().shadowless = true;
  s.fill({scattering()});
  check_pixel(s.scene, vec3(0.0F));
}

TEST_CASE("media: below quality 9 there are none", "[tracer][media]") {
  Slab s;
  s.fill({grey_absorption(1)});
  const SourceMap sources;
  Diagnostics diagnostics(sources);
  CHECK(tracer::compile(s.scene, diagnostics, 8)->media.empty());
  CHECK_FALSE(tracer::compile(s.scene, diagnostics, 9)->media.empty());
}

TEST_CASE("media: phase functions keep the light that they turn", "[tracer][media]") {
  // Those that are meant to have a mean of 1 over all directions; the oracle's others are brighter.
  const auto phase = GENERATE(scene::Phase::isotropic, scene::Phase::henyey_greenstein);
  tracer::MediaProgram m;
  m.phase = phase;
  m.eccentricity = 0.6;
  double sum = 0;
  constexpr int n = 2000;
  for (int i = 0; i < n; ++i) sum += tracer::phase_factor(m, (i + 0.5) * 2 / n - 1);
  CHECK(sum / n == Approx(1).margin(1e-5));
}

TEST_CASE("media: phase functions at their ends", "[tracer][media]") {
  tracer::MediaProgram m;
  m.phase = scene::Phase::mie_hazy;
  CHECK(tracer::phase_factor(m, 1) == Approx(5.76655375));
  CHECK(tracer::phase_factor(m, -1) == Approx(0.576655375));
  m.phase = scene::Phase::mie_murky;
  CHECK(tracer::phase_factor(m, 1) == Approx(25.281441897));
  m.phase = scene::Phase::rayleigh;
  CHECK(tracer::phase_factor(m, -1) == Approx(1.598744026));
}

TEST_CASE("media: bounds of the chi-square distribution", "[tracer][media]") {
  // Abramowitz and Stegun, table 26.8.
  CHECK(tracer::chi_square_exceeded(0.05, 1) == Approx(3.84146).epsilon(1e-5));
  CHECK(tracer::chi_square_exceeded(0.9, 9) == Approx(4.16816).epsilon(1e-5));
  CHECK(tracer::chi_square_exceeded(0.005, 30) == Approx(53.6720).epsilon(1e-5));
  CHECK(tracer::chi_square_exceeded(0.99, 100) == Approx(70.0649).epsilon(1e-5));
}

TEST_CASE("media: cones of light cut a ray into parts", "[tracer][media]") {
  tracer::Light down;  // a cone of 45 degrees, pointing down
  down.position = {0, 4, 0};
  down.axis = {0, -1, 0};
  down.kind = scene::Light::Kind::spotlight;
  down.falloff = std::sqrt(0.5);
  std::vector<tracer::LampSpan> spans;
  std::vector<tracer::LitPart> parts;
  const auto find = [&](std::initializer_list<tracer::Light> lights, dvec3 from, dvec3 d) {
    spans.clear();
    parts.clear();
    const std::vector<tracer::Light> all(lights);
    std::vector<std::uint32_t> lamps(all.size());
    std::iota(lamps.begin(), lamps.end(), 0U);
    tracer::find_lit_parts(all, lamps, {from, d}, 20, spans, parts);
    return parts.size();
  };
  SECTION("across") {
    REQUIRE(find({down}, {-10, 0, 0}, {1, 0, 0}) == 3);
    CHECK(parts[1].lit);
    CHECK(parts[1].from == Approx(6));
    CHECK(parts[1].to == Approx(14));
    CHECK(parts[2].to == 20);
  }
  SECTION("across above the lamp") {
    REQUIRE(find({down}, {-10, 8, 0}, {1, 0, 0}) == 1);
    CHECK_FALSE(parts[0].lit);
  }
  SECTION("from inside, downward") {
    REQUIRE(find({down}, {0.1, 2, 0}, {0, -1, 0}) == 1);
    CHECK(parts[0].lit);
  }
  SECTION("from inside, out at the side") {
    REQUIRE(find({down}, {0, 0, 0}, {0, 0, 1}) == 2);
    CHECK(parts[0].to == Approx(4));
  }
  SECTION("two cones overlap") {
    tracer::Light other = down;
    other.position.x = 3;
    REQUIRE(find({other, down}, {-10, 0, 0}, {1, 0, 0}) == 3);
    CHECK(parts[1].from == Approx(6));
    CHECK(parts[1].to == Approx(17));
    CHECK(spans.size() == 2);
  }
  SECTION("two cones apart") {
    tracer::Light other = down;
    other.position = {8, 1, 0};
    REQUIRE(find({down, other}, {-10, 0, 0}, {1, 0, 0}) == 5);
    CHECK_FALSE(parts[2].lit);
    CHECK(parts[3].from == Approx(17));
  }
  SECTION("lamps without a cone shine everywhere") {
    REQUIRE(find({tracer::Light{}, down}, {-10, 0, 0}, {1, 0, 0}) == 1);
    CHECK(parts[0].lit);
  }
}

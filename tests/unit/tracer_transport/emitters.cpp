#include "tracer/transport/emitters.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/catch.h"
#include "tracer/sobol.h"
#include "tracer/transport/directions.h"

using namespace durer;
using namespace durer::tracer;

namespace {

constexpr std::uint32_t count = 1 << 16;

// The integral of the density over all directions.
double total(const Emitters& emitters, dvec3 from) {
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    SobolSampler random(1, i);
    sum += emitters.density(from, sphere_direction(random.next2())) / sphere_density;
  }
  return sum / count;
}

BrightSky sky_with_sun() {
  std::vector<double> cells(32 * 16, 0.1);
  cells[5 * 32 + 7] = 100;
  return BrightSky(std::move(cells), 32, 16);
}

Emitters some_lights() {
  return {{{{{-1, 2, -1}, {1, 2.1, 1}}, 5}, {{{3, -1, 0}, {4, 1, 1}}, 1}}, {}};
}

}  // namespace

TEST_CASE("emitters: densities add up to 1", "[tracer][paths]") {
  const dvec3 from = GENERATE(dvec3(0, 0, 0), dvec3(0, 2.05, 0), dvec3(3.5, 0, 0.5), dvec3(-2, 5, 1));
  CAPTURE(from.x, from.y, from.z);
  CHECK(total(some_lights(), from) == Approx(1).margin(0.02));
}

TEST_CASE("emitters: the sky's densities add up to 1", "[tracer][paths]") {
  CHECK(total({{}, sky_with_sun()}, dvec3(0)) == Approx(1).margin(0.02));
  CHECK(total({some_lights().boxes(), sky_with_sun()}, dvec3(0)) == Approx(1).margin(0.03));
}

TEST_CASE("emitters: directions are as dense as they say", "[tracer][paths]") {
  const Emitters lights(some_lights().boxes(), GENERATE(0, 1) == 0 ? BrightSky() : sky_with_sun());
  const dvec3 from(0.3, -1, 0.2);
  // The solid angle of all that can be proposed, and of the upper half of it, both ways.
  double aimed = 0;
  double counted = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    SobolSampler random(3, i);
    const double pick = random.next();
    const Aim aim = lights.aim(from, pick, random.next2());
    REQUIRE(glm::length(aim.d) == Approx(1));
    REQUIRE(aim.density > 0);
    REQUIRE(aim.density == Approx(lights.density(from, aim.d)));
    if (aim.d.x > 0.1) aimed += 1 / aim.density / count;
    const dvec3 d = sphere_direction(random.next2());
    if (d.x > 0.1 && lights.density(from, d) > 0) counted += 1 / sphere_density / count;
  }
  CHECK(aimed == Approx(counted).epsilon(0.03));
}

TEST_CASE("emitters: many are joined", "[tracer][paths]") {
  std::vector<Emitters::Box> boxes;
  for (int i = 0; i < 1000; ++i) {
    const dvec3 p(i % 10, i / 10 % 10, i / 100);
    boxes.push_back({{p, p + 0.1}, 1});
  }
  const Emitters lights(std::move(boxes), {});
  CHECK(lights.boxes().size() <= 32);
  CHECK(total(lights, {20, 3, 3}) == Approx(1).margin(0.02));
  CHECK(Emitters().empty());
  CHECK(Emitters().aim(dvec3(0), 0.5, dvec2(0.5)).density == 0);
}

TEST_CASE("directions: lobes are as dense as they say", "[tracer][paths]") {
  const dvec3 axis = glm::normalize(dvec3(0.3, GENERATE(0.8, -0.8), GENERATE(0.2, -0.9)));
  const double exponent = GENERATE(1.0, 3.5, 40.0);
  double mean = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    SobolSampler random(9, i);
    const dvec3 d = power_direction(axis, exponent, random.next2());
    REQUIRE(glm::length(d) == Approx(1));
    const double cosine = glm::dot(axis, d);
    REQUIRE(cosine >= 0);
    mean += cosine / count;
  }
  CHECK(mean == Approx((exponent + 1) / (exponent + 2)).epsilon(1e-3));
}

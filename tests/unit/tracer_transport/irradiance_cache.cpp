#include "tracer/transport/irradiance_cache.h"

#include <glm/geometric.hpp>
#include <random>

#include "tests/support/catch.h"
#include "tracer/transport/radiosity.h"

using namespace durer;
using namespace durer::tracer;

namespace {

IrradianceSample sample_at(dvec3 p, double radius) {
  IrradianceSample s;
  s.p = p;
  s.n = {0, 1, 0};
  s.to_nearest = {0, 1, 0};
  s.nearest = radius;
  s.radius = radius;
  s.light = vec3(1, 0.5F, 0.25F);
  s.quality = 1;
  return s;
}

IrradianceQuery query_at(dvec3 p, double error) {
  return {p, {0, 1, 0}, error, 0, false, HUGE_VAL};
}

}  // namespace

TEST_CASE("irradiance: weights fall with distance", "[tracer][radiosity]") {
  const IrradianceSample s = sample_at(dvec3(0.0), 2);
  CHECK(weight_of(s, query_at(dvec3(0.0), 1)) == Approx(1));
  CHECK(weight_of(s, query_at({0.5, 0, 0}, 1)) == Approx(0.75));
  CHECK(weight_of(s, query_at({0.5, 0, 0}, 0.5)) == Approx(0.5));
  CHECK(weight_of(s, query_at({2.01, 0, 0}, 1)) == 0);
}

TEST_CASE("irradiance: what is seen directly is weighted without a kink", "[tracer][radiosity]") {
  const IrradianceSample s = sample_at(dvec3(0.0), 1);
  IrradianceQuery q = query_at({0.25, 0, 0}, 1);
  q.smooth = true;
  CHECK(weight_of(s, q) == Approx(1 - 2 * 0.25 * 0.25));
  q.p.x = 0.75;
  CHECK(weight_of(s, q) == Approx(2 * 0.25 * 0.25));
}

TEST_CASE("irradiance: points in front, turned or near a surface are left out",
          "[tracer][radiosity]") {
  IrradianceSample s = sample_at(dvec3(0.0), 1);
  CHECK(weight_of(s, query_at({0.3, -0.2, 0}, 1)) == 0);
  IrradianceQuery turned = query_at({0.1, 0, 0}, 1);
  turned.n = glm::normalize(dvec3(1, 1, 0));
  CHECK(weight_of(s, turned) == 0);  // 2·sqrt(1 - cos 45°) = 1.08
  s.to_nearest = {1, 0, 0};
  s.nearest = 0.2;
  CHECK(weight_of(s, query_at({0.3, 0, 0}, 1)) == 0);
  CHECK(weight_of(s, query_at({-0.3, 0, 0}, 1)) == Approx(0.7));
}

TEST_CASE("irradiance: the cache finds what a look at all samples finds", "[tracer][radiosity]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-20, 20);
  std::uniform_real_distribution<double> size(-6, 3);
  IrradianceCache cache;
  std::vector<IrradianceSample> all;
  for (int i = 0; i < 3000; ++i) {
    IrradianceSample s = sample_at({place(random), 0.01 * place(random), place(random)},
                                   std::exp2(size(random)));
    s.depth = static_cast<std::uint32_t>(i % 3);
    all.push_back(s);
    cache.add(s, s.radius * 1.5);
  }
  for (int i = 0; i < 500; ++i) {
    IrradianceQuery q = query_at({place(random), 0, place(random)}, 1.5);
    q.depth = static_cast<std::uint32_t>(i % 3);
    IrradianceSum found;
    cache.look_up(q, found);
    double weight = 0;
    for (const IrradianceSample& s : all) {
      if (s.depth == q.depth) weight += weight_of(s, q);
    }
    CHECK(found.weight == Approx(weight));
    CHECK(found.light.y == Approx(weight / 2));
  }
  cache.clear();
  IrradianceSum nothing;
  cache.look_up(query_at(all[0].p, 1.5), nothing);
  CHECK(nothing.weight == 0);
}

// Cells judge roughly first; whoever counts must get through, far from the origin too.
TEST_CASE("irradiance: no sample that counts is lost to the first look", "[tracer][radiosity]") {
  const double far_off = GENERATE(0.0, 1e5);
  const double scale = GENERATE(1e-4, 1.0, 1e4);
  CAPTURE(far_off, scale);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> side(-1, 1);
  const auto direction = [&] {
    return glm::normalize(dvec3(side(random), side(random) + 0.01, side(random)));
  };
  const auto place = [&] {
    return far_off + scale * dvec3(3 * side(random), 0.1 * side(random), 3 * side(random));
  };
  const auto upright = [&] { return glm::normalize(dvec3(0, 4, 0) + direction()); };
  IrradianceCache cache;
  std::vector<IrradianceSample> all;
  for (int i = 0; i < 2000; ++i) {
    IrradianceSample s = sample_at(place(), scale * std::exp2(2 * side(random)));
    s.n = upright();
    s.to_nearest = direction();
    s.nearest = s.radius * std::exp2(3 * side(random) - 1);
    all.push_back(s);
    cache.add(s, s.radius);
  }
  int counting = 0;
  for (int i = 0; i < 500; ++i) {
    IrradianceQuery q = query_at(i % 4 == 0 ? all[static_cast<std::size_t>(i)].p : place(), 1);
    q.n = upright();
    IrradianceSum found;
    cache.look_up(q, found);
    double weight = 0;
    for (const IrradianceSample& s : all) {
      const double w = weight_of(s, q);
      weight += w;
      counting += w > 0 ? 1 : 0;
    }
    CHECK(found.weight == Approx(weight).epsilon(1e-12));
  }
  CHECK(counting > 5000);
}

TEST_CASE("irradiance: enough is enough", "[tracer][radiosity]") {
  IrradianceCache cache;
  for (int i = 0; i < 10; ++i) cache.add(sample_at(dvec3(0.0), 1), 1);
  IrradianceQuery q = query_at(dvec3(0.0), 1);
  q.plenty = 2.5;
  IrradianceSum sum;
  cache.look_up(q, sum);
  CHECK(sum.weight == Approx(3));
}

TEST_CASE("radiosity: directions are spread as the cosine wants", "[tracer][radiosity]") {
  const std::vector<dvec3> all = cosine_directions(1600);
  REQUIRE(all.size() == 1600);
  CHECK(all[0].y == Approx(std::sqrt(0.5)));  // 1/2 in base 2, 1/3 in base 3
  CHECK(all[0].x == Approx(-0.5 * std::sqrt(0.5)));
  dvec3 mean(0.0);
  for (const dvec3& d : all) {
    CHECK(glm::length(d) == Approx(1));
    mean += d / 1600.0;
  }
  CHECK(mean.y == Approx(2.0 / 3).epsilon(0.002));
  CHECK(std::abs(mean.x) < 0.002);
}

TEST_CASE("radiosity: hemispheres stand on their normals", "[tracer][radiosity]") {
  for (const dvec3 n : {dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0, 0, 1), dvec3(1, 0, 0),
                        glm::normalize(dvec3(1, -2, 3))}) {
    const Hemisphere h(n);
    CHECK(glm::distance(h.direction({0, 1, 0}), n) < 1e-12);
    const dvec3 side = h.direction({0.6, 0, 0.8});
    CHECK(glm::length(side) == Approx(1));
    CHECK(std::abs(glm::dot(side, n)) < 1e-12);
  }
}

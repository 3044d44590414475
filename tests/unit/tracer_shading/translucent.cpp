#include "tracer/shading/translucent.h"

#include <cmath>
#include <numbers>

#include "tests/support/catch.h"

using namespace durer;
using namespace durer::tracer;

TEST_CASE("translucent: matter that keeps all light is white, and that which keeps none black",
          "[tracer][subsurface]") {
  const double ior = GENERATE(1.0, 1.3, 1.5, 2.4);
  CAPTURE(ior);
  const AlbedoTable table(ior);
  CHECK(table(0) == 0);
  CHECK(table(1) == 1);
  double last = 0;
  for (int i = 1; i <= 1000; ++i) {
    const double a = table(i / 1000.0);
    CHECK(a > last);
    last = a;
  }
  CHECK(table(2) == 1);
}

TEST_CASE("translucent: what comes out all around is what the colour says", "[tracer][subsurface]") {
  // All light that a flat surface gives back, for matter that bends none: the integral over the
  // plane, times π because lamps of this renderer are irradiance over π.
  const float colour = GENERATE(0.2F, 0.5F, 0.9F);
  CAPTURE(colour);
  const Translucency matter = translucency(vec3(colour), vec3(1.0F), AlbedoTable(1.0), 1.0);
  double sum = 0;
  const double step = 0.002;
  for (double r = step / 2; r < 60; r += step) {
    sum += diffuse_transport(matter, r).x * 2 * std::numbers::pi * r * step;
  }
  CHECK(sum == Approx(colour).epsilon(0.02));
}

TEST_CASE("translucent: depths of light that is scattered once give its mean",
          "[tracer][subsurface]") {
  const Translucency matter =
      translucency({0.8F, 0.4F, 0.1F}, {5, 3, 1}, AlbedoTable(1.3), 1.3);
  const double length = GENERATE(0.05, 2.0, 1e5);
  CAPTURE(length);
  const SingleDepths depths(matter, length);
  // Light that fades with depth, and its integral as the oracle's samples have it.
  const double fading = 0.3;
  constexpr int n = 3000;
  dvec3 mean(0.0);
  for (int i = 0; i < n; ++i) {
    const double depth = depths.at(i % 3, (i / 3 + 0.5) * 3 / n);
    REQUIRE(depth >= 0);
    REQUIRE(depth <= length * (1 + 1e-9));
    mean += std::exp(-fading * depth) * depths.weight(depth) / double(n);
  }
  for (int k = 0; k < 3; ++k) {
    const double rate = 2 * matter.extinction[k] + fading;
    const double expected = matter.extinction[k] / rate * -std::expm1(-rate * length);
    CHECK(mean[k] == Approx(expected).epsilon(1e-3));
  }
}

TEST_CASE("translucent: surfaces let light pass straight, not along them", "[tracer][subsurface]") {
  const Translucency matter = translucency(vec3(0.5F), vec3(1.0F), AlbedoTable(1.5), 1.5);
  CHECK(transmittance(matter, 1) == Approx(0.96));
  CHECK(transmittance(matter, -1) == Approx(0.96));
  CHECK(transmittance(matter, 0) == Approx(0).margin(1e-9));
  CHECK(diffuse_fresnel(1) == Approx(0).margin(1e-12));
}

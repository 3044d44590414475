#include "tracer/film/pretrace.h"

#include "tests/support/catch.h"

using namespace durer;
using namespace durer::tracer;

TEST_CASE("pretrace: spacings halve down to the last", "[tracer][radiosity]") {
  scene::Radiosity r;  // 0.08 … 0.04
  CHECK(pretrace_passes(r, 800) == 2);
  CHECK(pretrace_spacing(r, 800, 0) == Approx(64));
  CHECK(pretrace_spacing(r, 800, 1) == Approx(32));
  r.pretrace_end = 0.001;  // less than a pixel
  CHECK(pretrace_passes(r, 800) == 7);
  CHECK(pretrace_spacing(r, 800, 6) == Approx(1));
  r.pretrace_start = r.pretrace_end = 0.05;
  CHECK(pretrace_passes(r, 800) == 1);
}

TEST_CASE("pretrace: points are near a grid that tiles share, the same in every run",
          "[tracer][radiosity]") {
  std::vector<dvec2> a, b;
  pretrace_points({32, 0, 64, 32}, 8, 5, [&](double x, double y) { a.push_back({x, y}); });
  pretrace_points({32, 0, 64, 32}, 8, 5, [&](double x, double y) { b.push_back({x, y}); });
  REQUIRE(a.size() == 16);
  CHECK(a == b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(std::abs(a[i].x - (32.0 + 8.0 * static_cast<double>(i % 4) + 3.5)) <= 1);
    CHECK(std::abs(a[i].y - (8.0 * static_cast<double>(i / 4) + 3.5)) <= 1);
  }
}

TEST_CASE("pretrace: patches are divided while their parts keep 4x4 points", "[tracer][radiosity]") {
  CHECK(divided({0, 0, 32, 32}, 8).size() == 1);
  CHECK(divided({0, 0, 32, 32}, 4).size() == 4);
  CHECK(divided({0, 0, 32, 32}, 2).size() == 16);
}

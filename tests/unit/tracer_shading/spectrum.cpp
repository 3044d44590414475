#include "tracer/shading/spectrum.h"

#include "tests/support/catch.h"

using namespace durer;
using namespace durer::tracer;

TEST_CASE("spectrum: the bands' mean is nearly white", "[tracer][dispersion]") {
  const int count = GENERATE(2, 3, 7, 20);
  CAPTURE(count);
  vec3 sum(0.0F);
  for (int i = 0; i < count; ++i) sum += spectral_band(i, count).hue;
  sum /= static_cast<float>(count);
  CHECK(sum.x == Approx(0.9968).margin(0.004));
  CHECK(sum.y == Approx(1).margin(0.001));
  CHECK(sum.z == Approx(0.9981).margin(0.003));
}

TEST_CASE("spectrum: the middle of the range bends by the ior itself", "[tracer][dispersion]") {
  CHECK(index_factor(1.2, 555) == 1);
  CHECK(index_factor(1.2, 380) == Approx(std::sqrt(1.2)));
}

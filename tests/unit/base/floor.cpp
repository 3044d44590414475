#include "base/floor.h"

#include <limits>

#include "tests/support/catch.h"

using namespace durer;

TEST_CASE("floor: agrees with the C library's", "[base][floor]") {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double x : {0.0, -0.0, 0.5, -0.5, 1.0, -1.0, 1e9 + 0.25, -1e9 - 0.25, 0x1p52 - 0.5,
                         0.5 - 0x1p52, 0x1p52, -0x1p52, 0x1p63, -0x1p63, 0x1p64, huge, -huge, tiny,
                         -tiny, std::nextafter(1.0, 0.0), std::nextafter(-1.0, 0.0),
                         std::numeric_limits<double>::infinity(),
                         -std::numeric_limits<double>::infinity()}) {
    CAPTURE(x);
    CHECK(floored(x) == std::floor(x));
  }
  CHECK(std::isnan(floored(std::numeric_limits<double>::quiet_NaN())));
}

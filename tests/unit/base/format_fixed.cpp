#include "base/format_fixed.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "tests/support/catch.h"

using namespace durer;

namespace {

std::string ours(double x, int places) {
  char buffer[format_fixed_size];
  return std::string(format_fixed(x, places, buffer));
}
std::string printed(double x, int places) {
  char buffer[700];
  std::snprintf(buffer, sizeof buffer, "%.*f", places, x);
  return buffer;
}

}  // namespace

TEST_CASE("format_fixed: ties, zeros and signs are those of printf", "[base][format]") {
  for (const double x : {0.0, -0.0, 0.5, 1.5, 2.5, -2.5, 0.125, 0.375, 1e15, 9.999999, 1e-300,
                         123456789.0625, 5e-324, 1e22, 1.7976931348623157e308, 0.1, 4503599627370497.5}) {
    for (const int places : {0, 1, 2, 3, 6, 15, 16, 40}) CHECK(ours(x, places) == printed(x, places));
  }
}

TEST_CASE("format_fixed: random numbers are printed as by printf", "[base][format]") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200000; ++i) {
    double x = std::bit_cast<double>(random());
    if (i % 2 == 0) x = std::ldexp(static_cast<double>(random() % 100000), -static_cast<int>(random() % 40));
    if (!std::isfinite(x)) continue;
    const int places = static_cast<int>(random() % 18);
    const std::string a = ours(x, places);
    const std::string b = printed(x, places);
    if (a != b) {
      CAPTURE(x, places);
      REQUIRE(a == b);
    }
  }
}

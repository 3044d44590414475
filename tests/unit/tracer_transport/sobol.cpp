#include "tracer/sobol.h"

#include <array>
#include <cmath>

#include "tests/support/catch.h"

using namespace durer;
using namespace durer::tracer;

TEST_CASE("sobol: 16 samples meet each elementary interval of the square once", "[tracer][sobol]") {
  const std::uint32_t pixel = GENERATE(0U, 7U, 123456U);
  const std::uint32_t first = GENERATE(0U, 16U, 160U);
  const std::uint32_t dimension = GENERATE(0U, 5U);
  const int columns = GENERATE(1, 2, 4, 8, 16);
  CAPTURE(pixel, first, dimension, columns);
  std::array<int, 16> met{};
  for (std::uint32_t i = first; i < first + 16; ++i) {
    SobolSampler random(pixel, i);
    random.go_to(dimension);
    const dvec2 u = random.next2();
    REQUIRE((u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1));
    const int rows = 16 / columns;
    ++met[static_cast<std::size_t>(static_cast<int>(u.x * columns) * rows +
                                   static_cast<int>(u.y * rows))];
  }
  for (const int n : met) CHECK(n == 1);
}

TEST_CASE("sobol: dimensions and pixels do not know of each other", "[tracer][sobol]") {
  constexpr std::uint32_t count = 4096;
  const auto correlation = [](auto a, auto b) {
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i) sum += (a(i) - 0.5) * (b(i) - 0.5);
    return 12 * sum / count;
  };
  const auto number = [](std::uint32_t pixel, std::uint32_t dimension) {
    return [=](std::uint32_t i) {
      SobolSampler random(pixel, i);
      random.go_to(dimension);
      return random.next();
    };
  };
  const double noise = 4 / std::sqrt(double{count});
  CHECK(correlation(number(1, 0), number(1, 0)) == Approx(1).margin(0.01));
  for (std::uint32_t d = 1; d < 8; ++d) {
    CAPTURE(d);
    CHECK(std::abs(correlation(number(1, 0), number(1, d))) < noise);
    CHECK(std::abs(correlation(number(1, 3), number(1 + d, 3))) < noise);
  }
}

TEST_CASE("sobol: the same sample has the same numbers", "[tracer][sobol]") {
  SobolSampler a(42, 3);
  SobolSampler b(42, 3);
  for (int i = 0; i < 10; ++i) CHECK(a.next() == b.next());
  a.go_to(2);
  b.go_to(2);
  CHECK(a.next2() == b.next2());
}

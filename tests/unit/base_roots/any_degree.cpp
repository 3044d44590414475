// Polynomials up to the language's greatest degree, against the same coefficients in long double.
#include "base/roots/any_degree.h"

#include <numbers>
#include <random>
#include <vector>

#include "tests/support/catch.h"

namespace durer {
namespace {

/// A value with its slope, and how far rounding to double may move the root next to it.
struct Exact {
  long double value;
  long double slope;
  double blur;
};
Exact exact(const AnyPolynomial& p, long double x) {
  long double y = p.c[0];
  long double slope = 0;
  long double size = std::abs(p.c[0]);
  for (std::size_t i = 1; i <= p.degree; ++i) {
    slope = slope * x + y;
    y = y * x + static_cast<long double>(p.c[i]);
    size = size * std::abs(x) + std::abs(p.c[i]);
  }
  const long double error = 2.0L * static_cast<long double>(p.degree) * 0x1p-53L * size;
  return {y, slope, static_cast<double>(error / std::abs(slope))};
}

/// The sign change in lo…hi, where there is exactly one.
double reference(const AnyPolynomial& p, long double lo, long double hi) {
  const bool low_sign = exact(p, lo).value > 0;
  for (int i = 0; i < 80; ++i) {
    const long double middle = (lo + hi) / 2;
    ((exact(p, middle).value > 0) == low_sign ? lo : hi) = middle;
  }
  return static_cast<double>(lo);
}

/// Chebyshev's polynomial: as many roots in -1…1 as its degree, crowded at the ends.
AnyPolynomial chebyshev(std::size_t degree) {
  std::vector<double> before{1};
  std::vector<double> now{0, 1};  // rising powers; whole numbers below 2^53
  for (std::size_t n = 1; n < degree; ++n) {
    std::vector<double> next(n + 2, 0.0);
    for (std::size_t i = 0; i <= n; ++i) next[i + 1] = 2 * now[i];
    for (std::size_t i = 0; i < n; ++i) next[i] -= before[i];
    before = std::exchange(now, next);
  }
  AnyPolynomial p;
  p.degree = degree;
  for (std::size_t i = 0; i <= degree; ++i) p.c[i] = now[degree - i];
  return p;
}

}  // namespace

TEST_CASE("roots: Chebyshev polynomials have as many as their degree", "[base][roots]") {
  const std::size_t n = GENERATE(5U, 6U, 9U, 16U, 25U, 34U, 35U);
  const AnyPolynomial p = chebyshev(n);
  const Roots<max_degree> roots = sign_changes(p, -2, 2);
  CAPTURE(n);
  REQUIRE(roots.count == n);
  const auto extremum = [n](std::size_t k) {  // ascending; between two of them lies one root
    return -std::cos(std::numbers::pi_v<long double> * static_cast<long double>(k) /
                     static_cast<long double>(n));
  };
  for (std::size_t k = 0; k < n; ++k) {
    const double expected = reference(p, extremum(k), extremum(k + 1));
    REQUIRE(std::abs(roots.values[k] - expected) <= 1e-15 + exact(p, expected).blur);
  }
}

TEST_CASE("roots: sparse polynomials of the greatest degree", "[base][roots]") {
  AnyPolynomial p;
  p.degree = 35;
  p.c[0] = 1;
  p.c[35] = -7;
  const Roots<max_degree> one = sign_changes(p, -10, 10);
  REQUIRE(one.count == 1);
  CHECK(one.values[0] == Approx(std::pow(7.0, 1.0 / 35)).epsilon(1e-15));
  p.degree = 34;
  p.c[34] = 1;
  p.c[35] = 0;
  CHECK(sign_changes(p, -10, 10).count == 0);
  p.c[17] = -3;  // (x^17)² - 3 x^17 + 1
  const Roots<max_degree> two = sign_changes(p, -10, 10);
  REQUIRE(two.count == 2);
  const double root = std::sqrt(5.0) / 2;
  CHECK(two.values[0] == Approx(std::pow(1.5 - root, 1.0 / 17)).epsilon(1e-14));
  CHECK(two.values[1] == Approx(std::pow(1.5 + root, 1.0 / 17)).epsilon(1e-14));
}

TEST_CASE("roots: random polynomials change their sign where they do in long double",
          "[base][roots]") {
  std::mt19937_64 random(35);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::size_t found = 0;
  for (int i = 0; i < 3000; ++i) {
    AnyPolynomial p;
    p.degree = 5 + static_cast<std::size_t>(i) % 31;
    for (std::size_t k = 0; k <= p.degree; ++k) p.c[k] = uniform(random);
    const Roots<max_degree> roots = sign_changes(p, -1.5, 1.5);
    CAPTURE(i, p.degree);
    REQUIRE((exact(p, -1.5).value > 0) == ((exact(p, 1.5).value > 0) == (roots.count % 2 == 0)));
    for (std::size_t k = 0; k < roots.count; ++k) {
      const Exact e = exact(p, roots.values[k]);
      const auto distance = static_cast<double>(std::abs(e.value / e.slope));
      REQUIRE(distance <= 4 * 0x1p-52 * std::abs(roots.values[k]) + 2 * e.blur);
      if (k > 0) REQUIRE(roots.values[k] > roots.values[k - 1]);
    }
    // None is missed: between neighbours the sign stays.
    double from = -1.5;
    for (std::size_t k = 0; k <= roots.count; ++k) {
      const double to = k < roots.count ? roots.values[k] : 1.5;
      const bool sign = exact(p, (from + to) / 2).value > 0;
      for (int j = 1; j < 16; ++j) {
        const double x = from + (to - from) * (j / 16.0);
        if (std::min(x - from, to - x) > 1e-9) REQUIRE((exact(p, x).value > 0) == sign);
      }
      from = to;
    }
    found += roots.count;
  }
  CHECK(found > 3000);
}

}  // namespace durer

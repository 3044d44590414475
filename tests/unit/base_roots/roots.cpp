#include <random>
#include <vector>

#include "base/roots/polynomial.h"
#include "tests/support/catch.h"

namespace durer {
namespace {

/// (x - r0)(x - r1)… in long double, rounded once.
template <std::size_t N>
Polynomial<N> with_roots(const std::array<double, N>& roots) {
  std::array<long double, N + 1> c{1};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = i + 1; k > 0; --k) c[k] -= c[k - 1] * static_cast<long double>(roots[i]);
  }
  Polynomial<N> p{};
  for (std::size_t i = 0; i <= N; ++i) p[i] = static_cast<double>(c[i]);
  return p;
}

/// The root next to x of the same coefficients, in long double.
template <std::size_t N>
long double refined(const Polynomial<N>& c, double x0) {
  long double x = x0;
  for (int i = 0; i < 50; ++i) {
    long double y = c[0];
    long double slope = 0;
    for (std::size_t k = 1; k <= N; ++k) {
      slope = slope * x + y;
      y = y * x + static_cast<long double>(c[k]);
    }
    if (slope == 0) break;
    x -= y / slope;
  }
  return x;
}

template <std::size_t N>
void check_random_roots(double spread) {
  std::mt19937_64 random(N);
  std::uniform_real_distribution<double> uniform(-spread, spread);
  for (int i = 0; i < 20000; ++i) {
    std::array<double, N> expected{};
    for (double& r : expected) r = uniform(random);
    std::sort(expected.begin(), expected.end());
    double gap = 2 * spread;
    for (std::size_t k = 1; k < N; ++k) gap = std::min(gap, expected[k] - expected[k - 1]);
    if (gap < 1e-3 * spread) continue;  // rounding the coefficients may already join these
    const Polynomial<N> p = with_roots<N>(expected);
    const Roots<N> roots = sign_changes<N>(p, -2 * spread, 2 * spread);
    CAPTURE(i, spread);
    REQUIRE(roots.count == N);
    for (std::size_t k = 0; k < N; ++k) {
      const auto exact = static_cast<double>(refined<N>(p, roots.values[k]));
      REQUIRE(std::abs(roots.values[k] - exact) <= 1e-9 * spread);
      REQUIRE(std::abs(roots.values[k] - expected[k]) <= 1e-7 * spread);
    }
  }
}

}  // namespace

TEST_CASE("roots: quadratics do not cancel", "[base][roots]") {
  const auto roots = quadratic_roots(1, -1e9, 1);
  REQUIRE(roots.count == 2);
  CHECK(roots.values[0] == Approx(1e-9).epsilon(1e-15));
  CHECK(roots.values[1] == Approx(1e9).epsilon(1e-15));
  CHECK(quadratic_roots(1, 0, 1).count == 0);
  CHECK(quadratic_roots(1, 2, 1).count == 0);
  CHECK(quadratic_roots(0, 2, -1).values[0] == 0.5);
  CHECK(quadratic_roots(0, 0, 1).count == 0);
}

TEST_CASE("roots: cubics and quartics are found whole and exact", "[base][roots]") {
  const double spread = GENERATE(1e-3, 1.0, 1e4);
  check_random_roots<3>(spread);
  check_random_roots<4>(spread);
}

TEST_CASE("roots: symmetric and sparse quartics", "[base][roots]") {
  const auto symmetric = quartic_roots({1, 0, -5, 0, 4}, -10, 10);
  REQUIRE(symmetric.count == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(symmetric.values[i] == Approx(std::array{-2.0, -1.0, 1.0, 2.0}[i]).epsilon(1e-15));
  }
  CHECK(quartic_roots({1, 0, 0, 0, 0}, -1, 1).count == 0);  // touches
  CHECK(quartic_roots({1, 0, 0, 0, -1}, -5, 5).count == 2);
  CHECK(quartic_roots({1, 0, 2, 0, 1}, -5, 5).count == 0);   // complex pairs, twice
  CHECK(quartic_roots({0, 0, 1, 0, -1}, -5, 5).count == 2);  // leading zeros
}

TEST_CASE("roots: the count is even between points of the same sign", "[base][roots]") {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const double a = uniform(random);
    const double b = a + std::pow(10.0, -1 - i % 15);  // pairs that grow together
    const auto p = with_roots<4>({a, b, uniform(random), uniform(random)});
    REQUIRE(quartic_roots(p, -3, 3).count % 2 == 0);
  }
}

TEST_CASE("roots: coefficients that are not numbers have none", "[base][roots]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(quadratic_roots(nan, 1, 1).count == 0);
  CHECK(quartic_roots({1, nan, 0, 0, -1}, -5, 5).count == 0);
}

}  // namespace durer

TEST_CASE("roots: Descartes' bound is one, and even only where the roots are", "[base][roots]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int i = 0; i < 5000; ++i) {
    std::array<double, 4> roots{};
    for (double& r : roots) r = uniform(random);
    const durer::Polynomial<4> p = durer::with_roots<4>(roots);
    const double lo = uniform(random);
    const double hi = lo + 0.1 + std::abs(uniform(random));
    const auto inside = static_cast<int>(std::count_if(
        roots.begin(), roots.end(), [&](double r) { return r > lo && r < hi; }));
    const int most = durer::most_sign_changes<4>(p, lo, hi);
    CAPTURE(i, lo, hi, inside);
    REQUIRE(most >= inside);
    REQUIRE((most - inside) % 2 == 0);
  }
}

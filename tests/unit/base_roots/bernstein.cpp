#include "base/roots/bernstein.h"

#include <random>

#include "tests/support/catch.h"

namespace durer {
namespace {

/// (x - r0)(x - r1)… as a product of linear factors.
Bernstein<6> with_roots(const std::array<double, 6>& r) {
  const auto line = [](double root) { return Bernstein<1>{-root, 1 - root}; };
  const auto two = product<1, 1>(line(r[0]), line(r[1]));
  const auto four = product<2, 2>(two, product<1, 1>(line(r[2]), line(r[3])));
  return product<4, 2>(four, product<1, 1>(line(r[4]), line(r[5])));
}

}  // namespace

TEST_CASE("bernstein: finds the roots in [0, 1] and no others", "[base][roots]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 2);
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 6> r{};
    for (double& x : r) x = uniform(random);
    std::sort(r.begin(), r.end());
    double gap = 1;
    for (std::size_t k = 1; k < 6; ++k) gap = std::min(gap, r[k] - r[k - 1]);
    if (gap < 1e-2) continue;
    std::vector<double> expected;
    for (const double x : r) {
      if (x > 0 && x < 1) expected.push_back(x);
    }
    const auto roots = sign_changes<6>(with_roots(r));
    CAPTURE(i);
    REQUIRE(roots.count == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      REQUIRE(roots.values[k] == Approx(expected[k]).margin(1e-9));
    }
  }
}

TEST_CASE("bernstein: double roots keep the parity of the ends", "[base][roots]") {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const double a = uniform(random);
    const double b = uniform(random);
    const double close = a + 1e-9 * uniform(random);
    const Bernstein<6> p = with_roots({a, close, b, b, -1, 3});
    const auto roots = sign_changes<6>(p);
    CAPTURE(i, a, b);
    REQUIRE((roots.count % 2 == 1) == ((p[0] < 0) != (p[6] < 0)));
  }
}

TEST_CASE("bernstein: whether the sign changes is known without the places", "[base][roots]") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(-0.5, 1.5);
  for (int i = 0; i < 20000; ++i) {
    const double a = uniform(random);
    const double b = uniform(random);
    const Bernstein<6> p = with_roots({a, b, uniform(random), uniform(random), -1, 3});
    CAPTURE(i);
    REQUIRE(has_sign_change<6>(p) == (sign_changes<6>(p).count > 0));
  }
}

TEST_CASE("bernstein: a quadratic's root is exact, however small a coefficient is",
          "[base][roots]") {
  for (const Bernstein<2> b : {Bernstein<2>{1e-12, 1, -1}, Bernstein<2>{-1e-12, -1, 1},
                               Bernstein<2>{1, 1e-9, -1e-14}, Bernstein<2>{-3, 0, 1},
                               Bernstein<2>{1, -5, -1e-15}, Bernstein<2>{2, 0, -2}}) {
    const auto roots = sign_changes<2>(b);
    REQUIRE(roots.count == 1);
    const double x = roots.values[0];
    const double least = std::max({std::abs(b[0]), std::abs(b[1]), std::abs(b[2])});
    CHECK(std::abs(value_and_slope<2>(b, x).value) <= 4e-16 * least);
  }
  CHECK(sign_changes<2>(Bernstein<2>{-1, 0, 0}).values[0] == 1);
}

TEST_CASE("bernstein: a zero at the beginning does not hide the change of sign", "[base][roots]") {
  const auto roots = sign_changes<2>(Bernstein<2>{0, 1, -1});  // 2 x (1 - x) - x^2
  REQUIRE(roots.count == 1);
  CHECK(roots.values[0] == Approx(2.0 / 3));
}

TEST_CASE("bernstein: products, more coefficients and parts have the same values",
          "[base][roots]") {
  const Bernstein<3> p{0.3, -2, 1.5, 4};
  const auto value = [](const auto& b, double x) {
    return value_and_slope<std::tuple_size_v<std::decay_t<decltype(b)>> - 1>(b, x).value;
  };
  const auto square = product<3, 3>(p, p);
  const auto more = raised<6, 3>(p);
  const auto part = restricted<3>(p, 0.2, 0.7);
  for (double x = 0; x <= 1; x += 0.125) {
    CHECK(value(square, x) == Approx(value(p, x) * value(p, x)));
    CHECK(value(more, x) == Approx(value(p, x)));
    CHECK(value(part, x) == Approx(value(p, 0.2 + 0.5 * x)));
  }
}

}  // namespace durer

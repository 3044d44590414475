#include "base/roots/each_sign_change.h"

#include <algorithm>
#include <random>
#include <vector>

#include "tests/support/catch.h"

using namespace durer;

namespace {

template <std::size_t N>
std::vector<double> first_of(const Polynomial<N>& c, double lo, double hi, std::size_t most) {
  std::vector<double> found;
  each_sign_change<N>(c, lo, hi, [&](double x) {
    found.push_back(x);
    return found.size() < most;
  });
  return found;
}

template <std::size_t N>
void agrees(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::size_t found = 0;
  for (int i = 0; i < 20000; ++i) {
    Polynomial<N> c;
    for (double& x : c) x = uniform(random);
    if (i % 3 == 0) c[1] = 0;
    const Roots<N> all = sign_changes<N>(c, -1.5, 1.5);
    found += all.count;
    for (std::size_t most = 1; most <= N + 1; ++most) {
      const std::vector<double> some = first_of<N>(c, -1.5, 1.5, most);
      CAPTURE(i, most);
      REQUIRE(some.size() == std::min<std::size_t>(most, all.count));
      for (std::size_t k = 0; k < some.size(); ++k) REQUIRE(some[k] == all.values[k]);
    }
  }
  CHECK(found > 10000);
}

}  // namespace

TEST_CASE("roots: one after another they are those found together, to the last bit",
          "[base][roots]") {
  std::mt19937_64 random(4);
  SECTION("cubics") { agrees<3>(random); }
  SECTION("quartics") { agrees<4>(random); }
}

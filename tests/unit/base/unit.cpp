#include "base/unit.h"

#include <random>
#include <vector>

#include "tests/support/catch.h"

using namespace durer;

TEST_CASE("unit: many vectors get the same bits as each alone", "[base][unit]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-5, 5);
  for (const std::size_t count : {0, 1, 2, 7, 16, 17, 40}) {
    std::vector<dvec3> vectors(count);
    for (dvec3& v : vectors) v = {coordinate(random), coordinate(random), coordinate(random)};
    const std::vector<dvec3> before = vectors;
    normalize_all(vectors);
    for (std::size_t i = 0; i < count; ++i) CHECK(vectors[i] == glm::normalize(before[i]));
  }
}

#include "base/large_array.h"

#include "tests/support/catch.h"

namespace durer {

TEST_CASE("large array: begins with zeros, small or large", "[base][large_array]") {
  const std::size_t size = GENERATE(0, 1, 1000, 5'000'000);
  const LargeArray<float> a(size);
  CHECK(a.size() == size);
  CHECK(a.empty() == (size == 0));
  CHECK(std::all_of(a.begin(), a.end(), [](float v) { return v == 0; }));
}

TEST_CASE("large array: a copy has numbers of its own, what was moved is empty",
          "[base][large_array]") {
  LargeArray<float> a(3);
  a[1] = 2;
  LargeArray<float> b = a;
  CHECK(b == a);
  b[1] = 3;
  CHECK_FALSE(b == a);
  const LargeArray<float> c = std::move(b);
  CHECK(b.empty());
  CHECK(c[1] == 3);
  a = c;
  CHECK(a == c);
  CHECK_FALSE(a == LargeArray<float>(2));
}

}  // namespace durer

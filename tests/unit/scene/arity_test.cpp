#include "scene/arity.h"

#include <string>
#include <vector>

#include "base/transform.h"
#include "tests/support/catch.h"

namespace durer::scene {
namespace arity_test {  // not nameless: arity.h declares a conversion to each of these

struct Empty {};
struct One {
  int a;
};
struct Mixed {
  bool flag = false;
  double number = 1;
  std::string text;
  std::vector<double> list;
  std::optional<bool> maybe;
  dvec3 vector{0.0};
  SharedTransform transform;
  std::optional<One> maybe_struct;
  One nested{2};
  std::array<std::uint32_t, 3> triple{};
};

}  // namespace arity_test

TEST_CASE("arity: counts the members of aggregates of any types", "[scene][arity]") {
  using namespace arity_test;
  CHECK(arity<Empty>() == 0);
  CHECK(arity<One>() == 1);
  CHECK(arity<Mixed>() == 10);
}

}  // namespace durer::scene

#include "base/shared_count.h"

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "base/boxed.h"
#include "base/shared_list.h"
#include "tests/support/catch.h"

using durer::Boxed;
using durer::Counted;
using durer::SharedList;

TEST_CASE("counted: the last owner destroys the value", "[base][shared]") {
  const auto watched = std::make_shared<int>(7);
  auto a = Counted<std::shared_ptr<int>>::make(watched);
  CHECK(watched.use_count() == 2);
  auto b = a;
  CHECK(b == a);
  CHECK_FALSE(a.is_single());
  a = {};
  CHECK_FALSE(a);
  CHECK(b.is_single());
  CHECK(watched.use_count() == 2);
  auto c = std::move(b);
  CHECK_FALSE(b);  // NOLINT: what is left is defined
  c = c;           // NOLINT: meant
  CHECK(**c.get() == 7);
  c = {};
  CHECK(watched.use_count() == 1);
}

TEST_CASE("counted: several threads may share a value", "[base][shared]") {
  const auto watched = std::make_shared<int>(7);
  {
    const auto shared = Counted<std::shared_ptr<int>>::make(watched);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([shared] {
        for (int i = 0; i < 10000; ++i) const auto copy = shared;
      });
    }
    for (std::thread& t : threads) t.join();
    CHECK(shared.is_single());
  }
  CHECK(watched.use_count() == 1);
}

TEST_CASE("boxed: nobody else sees a change", "[base][shared]") {
  Boxed<std::string> a(std::string("one"));
  Boxed<std::string> b = a;
  CHECK(a.same(b));
  b.edit() = "two";
  CHECK(*a == "one");
  CHECK(*b == "two");
  const std::string* const own = &b.get();
  b.edit() += "!";  // it is his alone
  CHECK(&b.get() == own);
  CHECK(Boxed<std::string>().is_plain());
}

TEST_CASE("shared list: copies are the same list", "[base][shared]") {
  const SharedList<double> none;
  CHECK(none.empty());
  CHECK(none.begin() == none.end());
  SharedList<double> a{1, 2, 3};
  const SharedList<double> b = a;
  CHECK(b.identity() == a.identity());
  a = SharedList<double>{1, 2, 3};
  CHECK(b.identity() != a.identity());
  CHECK(a == b);
  CHECK(b.size() == 3);
  CHECK(b.back() == 3);
}

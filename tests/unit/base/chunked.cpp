#include "base/chunked.h"

#include <memory>
#include <string>
#include <utility>

#include "tests/support/catch.h"

using durer::Chunked;

TEST_CASE("chunked: references stay valid while it grows", "[base][chunked]") {
  Chunked<int, 2> list;
  list.push_back(7);
  int* const first = &list[0];
  for (int i = 1; i < 100; ++i) list.push_back(i);
  CHECK(&list[0] == first);
  CHECK(*first == 7);
  CHECK(list.size() == 100);
  for (std::size_t i = 1; i < 100; ++i) CHECK(list[i] == static_cast<int>(i));
}

TEST_CASE("chunked: sizes at the edges of chunks", "[base][chunked]") {
  Chunked<std::string, 1> list;
  CHECK(list.empty());
  CHECK(list.size() == 0);
  for (int i = 0; i < 5; ++i) {
    list.emplace_back(3, static_cast<char>('a' + i));
    CHECK(list.size() == static_cast<std::size_t>(i + 1));
    CHECK(list.back()[0] == 'a' + i);
  }
  for (int i = 5; i > 0; --i) {
    CHECK(list.size() == static_cast<std::size_t>(i));
    list.pop_back();
  }
  CHECK(list.empty());
  list.push_back("again");
  CHECK(list.back() == "again");
}

TEST_CASE("chunked: copies are deep, moves leave nothing behind", "[base][chunked]") {
  Chunked<std::string, 2> a;
  for (int i = 0; i < 10; ++i) a.push_back(std::to_string(i));
  Chunked<std::string, 2> b = a;
  b[3] = "changed";
  CHECK(a[3] == "3");
  b = a;
  CHECK(b[3] == "3");
  CHECK(b.size() == 10);
  const std::string* const place = &a[5];
  const Chunked<std::string, 2> c = std::move(a);
  CHECK(&c[5] == place);
}

TEST_CASE("chunked: iteration visits all in order", "[base][chunked]") {
  Chunked<std::unique_ptr<int>, 1> list;
  for (int i = 0; i < 7; ++i) list.push_back(std::make_unique<int>(i));
  int next = 0;
  for (const auto& p : std::as_const(list)) CHECK(*p == next++);
  CHECK(next == 7);
  for (auto& p : list) *p *= 2;
  CHECK(*list.back() == 12);
  list.clear();
  CHECK(list.begin() == list.end());
}

TEST_CASE("chunked: it can be made longer and shorter", "[base][chunked]") {
  Chunked<int, 2> list(3);
  CHECK(list.size() == 3);
  list.resize(9);
  CHECK(list.size() == 9);
  CHECK(list[8] == 0);
  list.resize(4);
  CHECK(list.size() == 4);
  list.resize(0);
  CHECK(list.empty());
}

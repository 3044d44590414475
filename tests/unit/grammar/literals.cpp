#include "grammar/literals.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "tests/support/catch.h"

using namespace durer::grammar;

namespace {

LiteralRun find(const std::string& text, std::uint32_t shortest = 2) {
  const char* stopped = nullptr;
  return find_literals(text.data(), text.data() + text.size(), shortest, stopped);
}

}  // namespace

TEST_CASE("literals: a run ends before whatever is no literal of its width", "[grammar][literals]") {
  CHECK(find("1, 2, 3 }").count == 3);
  CHECK(find("<1,2>,<3,4>,<5,6,7>,<8,9>,").count == 2);
  CHECK(find("1, 2, 3*4, 5").count == 2);
  CHECK(find("1, 2, A, 5").count == 2);
  CHECK(find("1, 2, 3 4, 5").count == 2);
  CHECK(find("1, 2, 1.5.x, 5").count == 2);
  CHECK(find("1, 2, 1e, 5, 6").count == 2);
  CHECK(find("1, 2, /* three */ 3, 4,").count == 2);
  CHECK(find("<1,2,3>.x, <1,2,3>,").count == 0);
  CHECK(find("<1,2,3,4,5,6>, <1,2,3,4,5,6>,").count == 0);
  CHECK(find("<1 2>, <3 4>,").count == 0);
  CHECK(find("1, 2").count == 0);  // what follows might continue it
  CHECK(find("1,", 1).comma_after);
  CHECK_FALSE(find("1}", 1).comma_after);
}

TEST_CASE("literals: every spelling of a number is read as strtod reads it", "[grammar][literals]") {
  std::mt19937_64 random(3);
  const char* const formats[] = {"%.0f", "%.3f", "%.9f", "%.17g", "%g", "%e", "%.25f"};
  std::string text;
  std::vector<double> expected;
  for (int i = 0; i < 20000; ++i) {
    const double x = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 120) - 120) *
                     (random() % 2 == 0 ? 1 : -1);
    char number[512];
    std::snprintf(number, sizeof number, formats[random() % std::size(formats)], x);
    expected.push_back(std::strtod(number, nullptr));
    text += number;
    text += random() % 2 == 0 ? "," : " ,\n\t";
  }
  text += "- .5, 5., 007, 123456789012345678901234567890, }";
  for (const double x : {-0.5, 5.0, 7.0, 123456789012345678901234567890.0}) expected.push_back(x);
  const LiteralRun run = find(text);
  REQUIRE(run.count == expected.size());
  LiteralReader reader(run);
  for (const double x : expected) {
    double v = 0;
    reader.read(&v);
    if (v != x) REQUIRE(v == x);
    CHECK(reader.comma());
  }
}

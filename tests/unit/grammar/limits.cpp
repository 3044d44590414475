#include <chrono>

#include "tests/support/catch.h"
#include "tests/unit/grammar/dump.h"

using durer::test::diagnose;
using durer::test::dump;
using durer::test::Parsed;

namespace {

std::string times(int n, std::string_view text) {
  std::string out;
  for (int i = 0; i < n; ++i) out += text;
  return out;
}

std::string nested(int n, std::string_view open, std::string_view close) {
  return times(n, open) + "1" + times(n, close);
}

double seconds(const std::string& source) {
  const auto start = std::chrono::steady_clock::now();
  const Parsed p(source);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Nest {
  std::string_view open, close;
};

}  // namespace

TEST_CASE("limits: two hundred levels parse in linear time", "[grammar][limits]") {
  const auto n = GENERATE(Nest{"(", ")"}, Nest{"<1,", ">"}, Nest{"f(", ")"}, Nest{"sin(2*(", "))"},
                          Nest{"A[", "]"}, Nest{"union {", "}"}, Nest{"#if (1) ", " #end"},
                          Nest{"(2 * #if (1) ", " #end)"}, Nest{"f(a < ", ")"},
                          Nest{"(1 ? ", " : 2)"}, Nest{"-", ""},
                          Nest{"#macro M() < #if (1) ", " #end #end"}, Nest{"#if (1) {(", "#end"},
                          Nest{"#if (1) <(1 @ ", "#end"}, Nest{"< #if (1) ", " #end >"});
  CAPTURE(n.open);
  const std::string source = nested(200, n.open, n.close);
  CHECK(Parsed("#if (0) " + source + " #end").tree != nullptr);
  CHECK(seconds(source) < 1.0);
}

TEST_CASE("limits: deeper nesting is a diagnostic, not a crash", "[grammar][limits]") {
  const auto n = GENERATE(Nest{"(", ")"}, Nest{"<1,", ">"}, Nest{"f(", ")"}, Nest{"A[", "]"},
                          Nest{"union {", "}"}, Nest{"#if (1) ", " #end"}, Nest{"-", ""},
                          Nest{"(1 ? ", " : 2)"}, Nest{"< #if (1) ", " #end >"});
  CAPTURE(n.open);
  CHECK(diagnose(nested(900 / 2, n.open, n.close)) == "none");
  CHECK(diagnose(nested(100000, n.open, n.close)).substr(0, 6) == "D0303 ");
  CHECK(diagnose("#if (0) " + nested(5000, n.open, n.close) + " #end").substr(0, 6) == "D0303 ");
}

TEST_CASE("limits: very long chains are a diagnostic, long ones are not", "[grammar][limits]") {
  CHECK(diagnose("#declare A = " + times(4000, "1+") + "1;") == "none");
  CHECK(diagnose("#declare A = " + times(100000, "1+") + "1;").substr(0, 6) == "D0303 ");
  CHECK(diagnose("#declare A = <" + times(100000, "1,") + "1>;") == "none");
  CHECK(diagnose(times(100000, "a ")) == "none");
}

TEST_CASE("limits: errors do not flood", "[grammar][limits]") {
  CHECK(Parsed(times(5000, "}")).diagnostics.all().size() == 20);
  CHECK(Parsed(times(5000, "\xE9 ")).diagnostics.all().size() == 20);
}

TEST_CASE("limits: hostile repetitions stay linear", "[grammar][limits]") {
  const auto text =
      GENERATE(std::string_view("< "), std::string_view("<1 "), std::string_view("#if (1) < #end "),
               std::string_view("(1 ? "), std::string_view("/* "), std::string_view("\" "),
               std::string_view("a.b "), std::string_view("#declare A = "));
  CAPTURE(text);
  CHECK(seconds(times(20000, text)) < 3.0);
  CHECK(seconds("#macro M() " + times(20000, text) + " #end") < 3.0);
}

// Splines in scenes (language §5.2). Values are the oracle's.
#include "tests/support/catch.h"
#include "tests/unit/interpreter/support.h"

namespace durer::interpreter::test {
namespace {

const std::string line = "#declare S = spline { linear_spline 0, 1 1, 3 } ";

std::string error(const std::string& text) {
  const std::string e = error_of(text);
  return e.substr(e.find(": ") + 2);
}

}  // namespace

TEST_CASE("splines: four kinds, and calls as another kind", "[interpreter][splines]") {
  const auto at = [](const std::string& kind, const std::string& call) {
    return vector_of(
        call, 2, "#declare S = spline { " + kind + " 0,<0,0,0> 1,<1,2,0> 2,<4,1,0> 3,<9,5,0> }");
  };
  CHECK(at("linear_spline", "S(1.5)") == "2.5000 1.5000");
  CHECK(at("quadratic_spline", "S(1.5)") == "2.2500 1.8750");
  CHECK(at("cubic_spline", "S(1.5)") == "2.2500 1.3750");
  CHECK(at("natural_spline", "S(1.5)") == "2.2000 1.3500");
  CHECK(at("", "S(1.5)") == "2.5000 1.5000");
  CHECK(at("", "S(1.5, natural_spline)") == "2.2000 1.3500");
}

TEST_CASE("splines: lengths", "[interpreter][splines]") {
  CHECK(vector_of("S(0.5)", 3, line, 0) == "2 2 0");  // a float makes two components
  CHECK(value_of("S(0.5).x", line, 0) == "2");
  CHECK(value_of("vlength(S(0.5))", line) == "2.828427");
  CHECK(vector_of("S(0.5)+<0,0,1>", 3, line, 0) == "2 2 1");
  CHECK(error(line + "#declare A = sin(S(0.5));") == "expected a float as argument, found a value of 2 components");
  CHECK(error(line + "#declare A = S(0.5).z;") ==
        "there is no component `z` in a value of 2 components");
}

TEST_CASE("splines: what an entry lacks it takes from the one before", "[interpreter][splines]") {
  const std::string s = "#declare S = spline { linear_spline 0,<1,2> 1,<3,4,5> 2,<6,7> } ";
  CHECK(vector_of("S(0)", 3, s, 0) == "1 2 0");
  CHECK(vector_of("S(1)", 3, s, 0) == "3 4 5");
  CHECK(vector_of("S(2)", 3, s, 0) == "6 7 5");
}

TEST_CASE("splines: copies extend another, variables share nothing", "[interpreter][splines]") {
  CHECK(vector_of("S(1.5)", 3, line + "#declare S = spline { S 2, <4,5,6> }") ==
        "3.5000 4.0000 3.0000");
  CHECK(vector_of("S2(0.5)", 2, line + "#declare S2 = S; #declare S = 4;", 0) == "2 2");
  CHECK(vector_of("S2(0.5)", 2, line + "#declare S2 = spline { S }", 0) == "2 2");
  CHECK(value_of("A[1](0.5).x", "#declare A = array[2] {spline {0,1 1,3}, spline {0,3 1,4}}", 1) ==
        "3.5");
}

TEST_CASE("splines: macros get them by reference", "[interpreter][splines]") {
  CHECK(value_of("S(1.5).x", line + "#macro M(P) #declare P = spline { P 2, 8 } #end M(S)", 1) ==
        "5.5");
}

TEST_CASE("splines: keys in any order, commas optional", "[interpreter][splines]") {
  CHECK(value_of("S(0.5).x", "#declare S = spline { linear_spline 1 5 0 1 }", 0) == "3");
  CHECK(value_of("S(0.5).x", "#declare S = spline { linear_spline 0,<1,2>,1,<3,4>, }", 0) == "2");
  CHECK(value_of("S(0.5).x", "#macro E() 0,1 1,3 #end #declare S = spline { E() }", 0) == "2");
}

TEST_CASE("splines: mistakes are named", "[interpreter][splines]") {
  CHECK(error("#declare S = spline { linear_spline }") == "a spline needs at least one entry");
  CHECK(error(line + "#declare A = S().x;") == "a spline is called with one key");
  CHECK(error(line + "#declare A = S(1, 2).x;") == "a spline is called with one key");
  CHECK(error(line + "#declare A = S(1, sphere).x;") ==
        "expected linear_spline, quadratic_spline, cubic_spline or natural_spline, found `sphere`");
  CHECK(error(line + "#declare A = S(<1,2>).x;") ==
        "expected a float as argument, found a value of 2 components");
  CHECK(error(line + "#declare A = S.x;") == "expected a number or vector, found a spline");
  CHECK(error("#declare S = spline { 0, rgb 1 }") == "expected a number or vector, found `rgb`");
}

}  // namespace durer::interpreter::test

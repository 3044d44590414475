// Values of the conformance table (language §11) and of the tables of §2 and §3.
#include "support.h"
#include "tests/support/catch.h"

using namespace durer::interpreter::test;

TEST_CASE("expressions: operators and precedence", "[interpreter][expressions]") {
  CHECK(value_of("(1|0&0)", "", 0) == "0");
  CHECK(value_of("(1<2<3)", "", 0) == "1");
  CHECK(value_of("(0.1+0.2=0.3)", "", 0) == "1");
  CHECK(value_of("(1<1+1e-11)", "", 0) == "1");
  CHECK(value_of("(1<=1-1e-11)", "", 0) == "1");
  CHECK(value_of("(\"a\"<\"b\")", "", 0) == "1");
  CHECK(value_of("(\"a\"=\"a\"?5:6)", "", 0) == "5");
  CHECK(value_of("-2*3", "", 0) == "-6");
  CHECK(value_of("--2", "", 0) == "2");
  CHECK(value_of("!5", "", 0) == "0");
  CHECK(value_of("-!0", "", 0) == "-1");
  CHECK(value_of("2-3-4", "", 0) == "-5");
  CHECK(value_of("2+3*4/6", "", 0) == "4");
  CHECK(value_of("(<1,2,3>.y)", "", 0) == "2");
  CHECK(value_of("(A.gray)", "#declare A=<1,2,3>;", 3) == "1.817");
  CHECK(value_of("-A.y", "#declare A=<1,2,3>;", 0) == "-2");
  CHECK(value_of("1e", "", 0) == "1");
}

TEST_CASE("expressions: vectors of all lengths", "[interpreter][expressions]") {
  CHECK(vector_of("!<1,0,2>", 3, "", 0) == "0 1 0");
  CHECK(vector_of("<1,2>+<1,2,3>", 3, "", 0) == "2 4 3");
  CHECK(vector_of("<1,2 -3>", 3, "", 0) == "1 -1 0");
  CHECK(vector_of("<1,2,3,>", 3, "", 0) == "1 2 3");
  CHECK(vector_of("<1 2 3>", 3, "", 0) == "1 2 3");
  CHECK(vector_of("1/<1,2,4>", 3, "", 2) == "1.00 0.50 0.25");
  CHECK(vector_of("(<1,2,3> < <2,2,2>)", 3, "", 0) == "1 0 0");
  CHECK(vector_of("2*x+3*y-z", 3, "", 0) == "2 3 -1");
  CHECK(vector_of("<(2>1),0,0>", 3, "", 0) == "1 0 0");
}

TEST_CASE("expressions: a component leaves the other slots behind", "[interpreter][expressions]") {
  // `translate` shows them (language §2.4).
  const auto moved = [](const std::string& e) {
    const Run r = run("#declare A=<1,2,3>;\nsphere { 0, 1 translate " + e + " }");
    if (!r.scene) return r.errors.front();
    const auto t = r.scene->objects.back().transform->forward.t;
    char out[64];
    std::snprintf(out, sizeof out, "%g %g %g", t.x, t.y, t.z);
    return std::string(out);
  };
  CHECK(moved("A.y") == "2 2 3");
  CHECK(moved("A.x+1") == "2 2 3");
  CHECK(moved("A.y*1") == "2 2 3");
  CHECK(moved("-A.y") == "-2 2 3");
  CHECK(moved("(A.y)") == "2 2 2");
  CHECK(moved("1*A.y") == "2 2 2");
  CHECK(moved("2*A.z") == "6 6 6");
  CHECK(moved("A.y*y") == "0 2 0");
  CHECK(moved("<A.y,A.y,A.y>") == "2 2 2");
  CHECK(moved("5") == "5 5 5");
}

TEST_CASE("expressions: colours", "[interpreter][expressions]") {
  CHECK(vector_of("rgbt <1,.2,.3,.4>", 5, "", 1) == "1.0 0.2 0.3 0.0 0.4");
  CHECK(vector_of("color .3", 5, "", 1) == "0.3 0.3 0.3 0.3 0.3");
  CHECK(vector_of("rgb <1,2,3,4>", 5, "", 0) == "1 2 3 4 0");
  CHECK(vector_of("srgb .5", 5, "", 3) == "0.214 0.214 0.214 0.000 0.000");
  CHECK(vector_of("rgb 1 transmit .4", 5, "", 1) == "1.0 1.0 1.0 0.0 0.4");
  CHECK(vector_of("color C filter .2", 5, "#declare C = rgb <1,.5,0>;", 1) ==
        "1.0 0.5 0.0 0.2 0.0");
  CHECK(vector_of("C*.5", 5, "#declare C = rgbf <1,.5,0,.5>;", 2) == "0.50 0.25 0.00 0.25 0.00");
  CHECK(vector_of("red 1 green .5", 5, "", 1) == "1.0 0.5 0.0 0.0 0.0");
  // Colour variables are single precision.
  CHECK(value_of("C.red", "#declare C = rgb .1;", 12) == "0.100000001490");
}

TEST_CASE("expressions: float functions", "[interpreter][builtins]") {
  CHECK(value_of("int(-1.7)", "", 0) == "-1");
  CHECK(value_of("div(-7,2)", "", 0) == "-3");
  CHECK(value_of("mod(5,-3)", "", 0) == "2");
  CHECK(value_of("select(0,2,3)", "", 0) == "3");
  CHECK(value_of("select(0,2,3,4)", "", 0) == "3");
  CHECK(value_of("select(1e-12,2,3,4)", "", 0) == "4");
  CHECK(value_of("max(1,5,3)", "", 0) == "5");
  CHECK(value_of("bitwise_xor(6,3)", "", 0) == "5");
  CHECK(value_of("strcmp(\"a\",\"ab\")", "", 0) == "-98");
  CHECK(value_of("val(\"12.5e1xyz\")", "", 0) == "125");
  CHECK(value_of("asc(\"\")", "", 0) == "0");
  CHECK(value_of("strlen(concat(\"ab\",\"cde\"))", "", 0) == "5");
  CHECK(value_of("sin(1<2)", "", 4) == "0.8415");
  CHECK(value_of("vlength(<3,4,0>)", "", 0) == "5");
  CHECK(value_of("vdot(x+y, 2*y)", "", 0) == "2");
  CHECK(value_of("degrees(pi)", "", 4) == "180.0000");
  CHECK(value_of("1/0", "", 0) == "inf");
  CHECK(value_of("-1/0", "", 0) == "inf");
}

TEST_CASE("expressions: vector functions", "[interpreter][builtins]") {
  CHECK(vector_of("vrotate(<1,2,3>,<30,40,50>)") == "1.8013 2.5077 2.1135");
  CHECK(vector_of("vaxis_rotate(x, z, 90)") == vector_of("vrotate(x, 90*z)"));
  CHECK(vector_of("vcross(x,y)", 3, "", 0) == "0 0 1");
  CHECK(vector_of("vnormalize(<0,3,4>)", 3, "", 1) == "0.0 0.6 0.8");
  CHECK(vector_of("vturbulence(2,.5,6,<1,2,3>)") == "-0.3805 -0.5382 0.4217");
}

TEST_CASE("expressions: strings", "[interpreter][builtins]") {
  CHECK(text_of("str(3.14159,-8,3)") == "0003.142");
  CHECK(text_of("str(2.5,0,0)") == "2");
  CHECK(text_of("str(3.5,0,0)") == "4");
  CHECK(text_of("vstr(9,<1,2>,\"; \",0,2)") == "1.00; 2.00; 0.00; 0.00; 0.00");
  CHECK(text_of("vstr(3,5,\",\",0,1)") == "5.0,0.0,0.0");
  CHECK(text_of("datetime(-1)") == "1999-12-31 00:00:00Z");
  CHECK(text_of("substr(\"ABCDE\",2,3)") == "BCD");
  CHECK(text_of("strupr(\"aBc\")") == "ABC");
  CHECK(text_of("chr(65)") == "A");
  CHECK(text_of("\"a\\tb\\\\n\"") == "a\tb\\n");
  CHECK(text_of("substr(\"ABC\",2,3)").substr(0, 5) == "D0302");
}

TEST_CASE("expressions: random streams are bit-equal to the oracle's", "[interpreter][rand]") {
  const std::string zero = "#declare S = seed(0);";
  CHECK(vector_of("<rand(S),rand(S),rand(S)>", 3, zero, 9) ==
        "0.000002874 0.466563685 0.249070229");
  CHECK(value_of("rand(seed(-5))", "", 15) == "0.890052870123194");
  CHECK(value_of("rand(seed(3))", "", 15) == "0.265972876983223");
  // Both branches of ?: draw.
  CHECK(value_of("R", "#declare S=seed(0); #declare Q=(1 ? rand(S) : rand(S)); #declare R=rand(S);",
                 6) == "0.249070");
}

TEST_CASE("expressions: what has no value is an error", "[interpreter][expressions]") {
  CHECK(error_of("#declare A = 1<2;").substr(0, 2) == "D0");
  CHECK(error_of("#declare A = B;") == "D0203 at 1:14: `B` is not declared");
  CHECK(error_of("#declare A = sqrt(-1);").substr(0, 5) == "D0301");
  CHECK(error_of("#declare A = ln(0);").substr(0, 5) == "D0301");
  CHECK(error_of("#declare A = <1,2,3,4,5,6>;").substr(0, 2) == "D0");
  CHECK(error_of("#declare A = 5\n#declare B = 6;").substr(0, 5) == "D0101");
  CHECK(error_of("#declare V=<1,2,3>; #if (V) #end").substr(0, 5) == "D0204");
}

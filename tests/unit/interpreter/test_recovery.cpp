// Several errors in one run: each told once, without those that only follow from them.
#include <fmt/format.h>

#include "support.h"
#include "tests/support/catch.h"

using namespace durer::interpreter::test;

namespace {

/// "2 5: `A` is not declared": line and claim of each error.
std::vector<std::string> errors_of(const std::string& text) {
  std::vector<std::string> out;
  for (const std::string& e : run(text).errors) {
    const std::size_t at = e.find(" at ") + 4;
    const std::size_t colon = e.find(':', at);
    out.push_back(e.substr(at, colon - at) + e.substr(e.find(": ", colon) + 1));
  }
  return out;
}

using Errors = std::vector<std::string>;

}  // namespace

TEST_CASE("recovery: every broken statement is told", "[interpreter][recovery]") {
  CHECK(errors_of("sphere { 0, Radius }\n"
                  "box { -1, 1 open }\n"
                  "sphere { 0, 1 }\n"
                  "#declare A = sin(\"x\");\n"
                  "sphere { <1,2,3>, \"s\" }\n") ==
        Errors{"1 `Radius` is not declared", "2 `box` takes no `open` here",
               "4 expected a number or vector, found a string",
               "5 expected a number or vector, found a string"});
}

TEST_CASE("recovery: a failed declaration is not complained about again",
          "[interpreter][recovery]") {
  CHECK(errors_of("#declare A = sin(\"x\");\n"
                  "#declare B = A + 1;\n"
                  "#declare C = <A, B, 0>;\n"
                  "sphere { C, B }\n"
                  "#debug str(A, 0, 0)\n"
                  "#declare A = 2;\n"
                  "sphere { 0, A translate Nope }") ==
        Errors{"1 expected a number or vector, found a string", "7 `Nope` is not declared"});
}

TEST_CASE("recovery: an undeclared name is told once", "[interpreter][recovery]") {
  CHECK(errors_of("sphere { 0, R }\nsphere { 1, R }\nobject { R }\nR\n") ==
        Errors{"1 `R` is not declared"});
}

TEST_CASE("recovery: a failed macro body leaves its names without complaint",
          "[interpreter][recovery]") {
  CHECK(errors_of("#macro Setup(N)\n"
                  "  #declare First = 1;\n"
                  "  #declare Bad = N + \"s\";\n"
                  "  #declare Second = 2;\n"
                  "  #if (N) #declare Third = sphere { 0, 1 } #end\n"
                  "#end\n"
                  "Setup(3)\n"
                  "sphere { 0, First }\n"
                  "sphere { 0, Second }\n"
                  "object { Third }\n"
                  "object { Fourth }\n") ==
        Errors{"3 expected a number or vector, found a string", "11 `Fourth` is not declared"});
}

TEST_CASE("recovery: an include guard does not hide the rest of a file",
          "[interpreter][recovery]") {
  CHECK(errors_of("#ifndef (Guard)\n"
                  "#declare Guard = 1;\n"
                  "#declare A = nothing_at_all;\n"
                  "#macro M() 1 #end\n"
                  "#declare B = 5;\n"
                  "#if (B) #declare D = missing; #declare C = M() + B; #end\n"
                  "#end\n"
                  "sphere { 0, C + A }\n"
                  "sphere { B }\n") ==
        Errors{"3 `nothing_at_all` is not declared", "6 `missing` is not declared",
               "9 expected the radius of this `sphere`, found `}`"});
}

TEST_CASE("recovery: a loop tells its error once", "[interpreter][recovery]") {
  CHECK(errors_of("#macro M(I) sphere { I*x, Nil } #end\n"
                  "#for (I, 1, 5) M(I) #end\n"
                  "#while (Nil < 3) #declare K = 1; #end\n"
                  "M(1) M(2)\n"
                  "sphere { 0, K }") == Errors{"1 `Nil` is not declared"});
}

TEST_CASE("recovery: a definition that is lost is not missed", "[interpreter][recovery]") {
  CHECK(errors_of("#declare T = texture { pigmnt { rgb 1 } }\n"
                  "#declare A = array[2] { 1, Oops }\n"
                  "#declare B = A[1] + 1;\n"
                  "#declare A[0] = 3;\n"
                  "#declare O = union { sphere { 0, 1 } object { Thing } }\n"
                  "object { O texture { T } }\n"
                  "#declare F = function(x) { x + nope }\n"
                  "#declare V = F(2);\n"
                  "sphere { 0, V }\n") ==
        Errors{"1 `texture` has no setting `pigmnt`", "2 `Oops` is not declared",
               "5 `Thing` is not declared", "7 `nope` is not declared"});
}

TEST_CASE("recovery: a missing include hides unknown names", "[interpreter][recovery]") {
  CHECK(errors_of("#include \"not-there.inc\"\n"
                  "#include \"nor-this.inc\"\n"
                  "object { Knob(3) texture { T_Stone } }\n"
                  "#declare X = Number + 3;\n"
                  "sphere { 0, X }\n"
                  "box { 0 }\n")
            .size() == 3);
}

TEST_CASE("recovery: a missing semicolon costs nothing else", "[interpreter][recovery]") {
  CHECK(errors_of("#declare A = 1\n"
                  "#declare B = <1,2,3>\n"
                  "sphere { B, A }\n") ==
        Errors{"1 this `#declare` of a float must end with `;`",
               "2 this `#declare` of a vector must end with `;`"});
}

TEST_CASE("recovery: what a lost statement left open is closed", "[interpreter][recovery]") {
  CHECK(errors_of("#macro Open() union { sphere { Zero, 1 } #end\n"
                  "Open()\n"
                  "  sphere { 0, 1 }\n"
                  "  translate x\n"
                  "}\n"
                  "sphere { 0, Last }\n")
            .front() == "1 `Zero` is not declared");
}

TEST_CASE("recovery: #error, limits and versions end the run", "[interpreter][recovery]") {
  CHECK(errors_of("sphere { 0, A }\n#error \"enough\"\nsphere { 0, B }") ==
        Errors{"1 `A` is not declared", "2 enough"});
  CHECK(errors_of("#macro M() M() #end\nM()\nsphere { 0, B }").size() == 1);
  CHECK(errors_of("#version 9.9;\nsphere { 0, B }").size() == 1);
}

TEST_CASE("recovery: twenty errors are enough", "[interpreter][recovery]") {
  std::string text;
  for (int i = 0; i < 50; ++i) text += fmt::format("sphere {{ 0, N{} }}\n", i);
  CHECK(errors_of(text).size() == 20);
}

TEST_CASE("recovery: labels lead to the other half of the trouble", "[interpreter][recovery]") {
  CHECK(run("#macro M(A) A #end\nsphere { 0, M(1,2) }").labels ==
        Errors{"1: the macro is defined here"});
  CHECK(run("#macro M() 1 #end\n#declare M = 3;").labels == Errors{"1: the macro is defined here"});
  CHECK(run("#declare S =\n\"text\"\n#declare T = S + 1;").labels ==
        Errors{"1: `S` is declared here"});
  CHECK(run("#declare Scale = 2;\nsphere { 0, Scael }").help ==
        Errors{"did you mean `Scale`?"});
}

TEST_CASE("recovery: several syntax errors are told, one per line", "[interpreter][recovery]") {
  CHECK(errors_of("sphere { <0,0,0 1 }\n"
                  "sphere { 0, 1 }\n"
                  "box { 0, 2* }\n"
                  "#declare A = 1; #declare sphere = 2;\n"
                  "#nonsense\n"
                  "#macro M() (2+) #end\n"
                  "union { sphere { 0, 1 }\n"
                  "  sphere { 0, (1+) } }\n") ==
        Errors{"1 expected a component, `,` or `>`, found `}`",
               "3 expected an operand after `*`, found `}`",
               "4 expected a name that is not reserved, found the reserved word `sphere`",
               "5 there is no directive `#nonsense`", "8 expected an operand after `+`, found `)`"});
}

TEST_CASE("recovery: objects cannot nest without end", "[interpreter][recovery]") {
  CHECK(errors_of("#declare O = sphere { 0, 1 }\n"
                  "#for (I, 1, 10000) #declare O = union { object { O } sphere { x, 1 } } #end\n") ==
        Errors{"2 objects are nested more than 5000 deep"});
}

TEST_CASE("recovery: deep recursion is an error", "[interpreter][recovery]") {
  durer::interpreter::Options o;
  o.limits.macro_depth = 0;
  const durer::interpreter::test::Run r =
      run("#macro F(N) (1 + F(N + 1)) #end\n#declare A = F(0);", true, o);
  REQUIRE(r.errors.size() == 1);
  CHECK(r.errors.front().substr(0, 5) == "D0303");
  CHECK(error_of("#declare A = array[1];\n"
                 "#for (I, 1, 300000) #declare A = array[1] { A } #end") == "no error");
}

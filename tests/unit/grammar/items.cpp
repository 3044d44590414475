#include "tests/support/catch.h"
#include "tests/unit/grammar/dump.h"

using durer::test::diagnose;
using durer::test::dump;
using durer::test::Parsed;

TEST_CASE("items: blocks are words and braces", "[grammar][items]") {
  CHECK(dump("sphere { 0, 1 pigment { rgb x } }") == ":sphere {0 ',' 1 :pigment {:rgb x}}");
  CHECK(dump("array[2][2] { {1,2}, {3,4}, }") == ":array [2] [2] {{1 ',' 2} ',' {3 ',' 4} ','}");
  CHECK(dump("finish { Shine phong 1 }") == ":finish {Shine :phong 1}");
}

TEST_CASE("items: map entries are brackets", "[grammar][items]") {
  CHECK(dump("pigment_map { [0 T1][1 T2] }") == ":pigment_map {[0 T1] [1 T2]}");
  CHECK(dump("color_map { [0.0, 0.5 color A color B] [0.5 -x rgb y] }") ==
        ":color_map {[0 ',' 0.5 :color A :color B] [(- 0.5 x) :rgb y]}");
}

TEST_CASE("items: colour words and keywords separate expressions", "[grammar][items]") {
  CHECK(dump("checker rgb 1 red 1") == ":checker :rgb 1 :red 1");
  CHECK(dump("rgb C*f transmit .4") == ":rgb (* C f) :transmit 0.4");
  CHECK(dump("texture{A} texture{B}") == ":texture {A} :texture {B}");
}

TEST_CASE("items: semicolons and commas stand anywhere", "[grammar][items]") {
  CHECK(dump("sphere{0,1}; , ;") == ":sphere {0 ',' 1} ';' ',' ';'");
}

TEST_CASE("items: a `#` before a keyword or a brace means nothing", "[grammar][items]") {
  CHECK(dump("camera { look_at 0# }") == ":camera {:look_at 0}");
  CHECK(dump("# sphere { 0, 1 } ##declare A=1;") == ":sphere {0 ',' 1} #declare A=1;");
  CHECK(diagnose("sphere { 0, # 1 }") == "D0101 1:15 there is no directive `#1`");
  CHECK(dump("#if (0) # 1 #end") == "#if (0){'#' 1}");
}

TEST_CASE("items: very old scenes declare without `#`", "[grammar][items]") {
  CHECK(dump("declare X = 1") == ":declare X '=' 1");
  CHECK(dump("include \"a.inc\"") == ":include \"a.inc\"");
}

TEST_CASE("items: marks that nothing explains are errors outside of bodies", "[grammar][items]") {
  CHECK(diagnose("sphere { 0, 1 @ }") ==
        "D0101 1:15 expected something for this block or `}`, found `@`");
  CHECK(diagnose("sphere { 0, 1 + }") == "D0101 1:17 expected an operand after `+`, found `}`");
  CHECK(diagnose("A @ B") ==
        "D0101 1:3 expected an object, a directive or the end of the file, found `@`");
}

TEST_CASE("items: an include may begin and end within an expression", "[grammar][items]") {
  CHECK(dump("* 2") == "'*' 2");
  CHECK(dump("1 + ") == "1 '+'");
}

TEST_CASE("items: in a directive body nothing is an error yet", "[grammar][recovery]") {
  CHECK(dump("#if (0) don't @ ` ? \\ #end") == "#if (0){don ''' t '@' '`' '?' '\\'}");
  CHECK(dump("#if (c) < 5 #end") == "#if (c){'<' 5}");
  CHECK(dump("#macro M() sphere { <0, 1 } #end") == "#macro M(){:sphere {'<' 0 ',' 1}}");
  CHECK(
      dump("#if (0) #foo #declare = 3; #if xx 3 #end #while #end #macro #end #end") ==
      "#if (0){#unknown foo #unknown declare '=' 3 ';' #unknown if #unknown while #unknown macro}");
  CHECK(dump("#if (0) #switch (1) 5 #case (1) #end #end") == "#if (0){#unknown switch}");
  CHECK(dump("#if (0) #declare A = <1, 2; #end") == "#if (0){#declare A=none '<' 1 ',' 2 ';'}");
}

TEST_CASE("items: what could not be read in a body is remembered", "[grammar][recovery]") {
  const Parsed p("#macro M()\n  sphere { <0, 1 }\n#end");
  REQUIRE(p.tree != nullptr);
  REQUIRE(p.tree->flaws.size() == 1);
  CHECK(p.sources.place(p.tree->flaws[0].place).column == 12);
  CHECK(p.tree->flaws[0].why.message == "expected a component, `,` or `>`, found `}`");
  CHECK_FALSE(p.diagnostics.has_errors());
}

TEST_CASE("items: groups know their marks", "[grammar][spans]") {
  const Parsed p("union { a } ");
  const auto& item = p.tree->items[p.tree->top.first + 1];
  CHECK(p.text(item.span) == "{ a }");
  CHECK(p.text(p.tree->groups[item.ref].open) == "{");
  CHECK(p.text(p.tree->groups[item.ref].close) == "}");
}

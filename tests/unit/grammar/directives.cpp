#include "tests/support/catch.h"
#include "tests/unit/grammar/dump.h"

using durer::test::diagnose;
using durer::test::dump;
using durer::test::Parsed;
namespace ast = durer::ast;

TEST_CASE("declare: a closed expression before the semicolon is the value", "[grammar][declare]") {
  CHECK(dump("#declare A = B*2+1;") == "#declare A=(+ (* B 2) 1);");
  CHECK(dump("#local A[i][1] = V.x;") == "#local A[i][1]=V.x;");
  CHECK(dump("#declare A = M(1);") == "#declare A=M(1);");
  CHECK(dump("#declare A=1;;;") == "#declare A=1; ';'");  // the oracle takes two
  CHECK(dump("# declare\nA=1;") == "#declare A=1;");
}

TEST_CASE("declare: text and names may stand without semicolon", "[grammar][declare]") {
  CHECK(dump("#declare S = \"a\" #declare T = concat(S, \"b\") sphere{0,1}") ==
        "#declare S=\"a\" #declare T=concat(S \"b\") :sphere {0 ',' 1}");
  CHECK(dump("#declare T2 = T1 texture {T}") == "#declare T2=T1 :texture {T}");
}

TEST_CASE("declare: any other value follows as items", "[grammar][declare]") {
  CHECK(dump("#declare C = rgb <1,0,0>;") == "#declare C=none :rgb <1 0 0> ';'");
  CHECK(dump("#declare O = sphere { 0, 1 }") == "#declare O=none :sphere {0 ',' 1}");
  CHECK(dump("#declare A = B #if(c) + 1 #end;") == "#declare A=none B #if (c){(pos 1)} ';'");
  CHECK(dump("#declare A = #if(c) 1; #else 2; #end") ==
        "#declare A=none #if (c){1 ';'} else {2 ';'}");
  CHECK(dump("#declare A = M(1) texture {T}") == "#declare A=none M(1) :texture {T}");
  CHECK(dump("#declare A = 2 * #if(c) 1 #end;") == "#declare A=none 2 '*' #if (c){1} ';'");
  CHECK(dump("#declare F = function(x) {x}") == "#declare F=none :function (x) {x}");
  CHECK(dump("#declare X = #if(F) union{ #else merge{ #end a }") ==
        "#declare X=none #if (F){:union '{'} else {:merge '{'} a '}'");
}

TEST_CASE("declare: deprecation is kept", "[grammar][declare]") {
  CHECK(dump("#declare deprecated A=1;") == "#declare (deprecated none) A=1;");
  CHECK(dump("#declare deprecated once \"use B\" A=1; #declare C=1;") ==
        "#declare (deprecated once \"use B\") A=1; #declare C=1;");
}

TEST_CASE("declare: reserved words are no targets", "[grammar][declare]") {
  CHECK(diagnose("#declare sphere = 1;") ==
        "D0101 1:10 expected a name that is not reserved, found the reserved word `sphere`");
  CHECK(diagnose("#declare A 3;") == "D0101 1:12 expected `=`, found `3`");
}

TEST_CASE("undef: takes a name or an element", "[grammar][declare]") {
  CHECK(dump("#undef A #undef B[1][2] x") == "#undef A #undef B[1][2] x");
}

TEST_CASE("conditionals: chains keep their branches in order", "[grammar][conditionals]") {
  CHECK(dump("#if (a<b) 1 #elseif (c) 2 #else 3 #end") == "#if ((< a b)){1} if (c){2} else {3}");
  CHECK(dump("#ifdef (A[1]) 1 #elseif (2) 3 #end #ifndef (sphere) #end") ==
        "#ifdef A[1]{1} if (2){3} #ifndef sphere{}");
  CHECK(dump("#if (1) #else a #else b #end") == "#if (1){} else {a} else {b}");
  CHECK(dump("#if (#if(a) 1 #else 2 #end) 3 #end") == "#if open(#if (a){1} else {2}){3}");
  CHECK(dump("#if (1) -1 #end") == "#if (1){(neg 1)}");
}

TEST_CASE("conditionals: switches keep cases, ranges and the rest", "[grammar][conditionals]") {
  CHECK(dump("#switch (a) #case (1) b #break #range (2, 4) c #range (5 6) #else d #end") ==
        "#switch (a) case (1){b #break} range 2 4{c} range 5 6{} else{d}");
  CHECK(dump("#switch (a) #end") == "#switch (a)");
  CHECK(diagnose("#switch (1) 5 #case (1) #end") ==
        "D0101 1:13 expected `#case`, `#range` or `#else`, found `5`");
}

TEST_CASE("loops: heads are read with or without commas", "[grammar][loops]") {
  CHECK(dump("#while (i<3) #declare i=i+1; #end") == "#while ((< i 3)){#declare i=(+ i 1);}");
  CHECK(dump("#for (I, 0, 10, 2) a #end") == "#for I 0 10 2{a}");
  CHECK(dump("#for (I 0 n-1) a #end") == "#for I 0 (- n 1) none{a}");
  CHECK(diagnose("#for (x, 0, 1) #end").substr(0, 9) == "D0101 1:7");
}

TEST_CASE("macros: parameters and body", "[grammar][macros]") {
  CHECK(dump("#macro M(a, b c,) a+b #end") == "#macro M(a b c){(+ a b)}");
  CHECK(dump("#macro M() #macro N(z_) z_ #end M() #end") == "#macro M(){#macro N(z_){z_} M()}");
  CHECK(diagnose("#macro M(x) #end") ==
        "D0101 1:10 expected a parameter name or `)`, found the reserved word `x`");
}

TEST_CASE("messages: the operand is one text, nothing more", "[grammar][messages]") {
  CHECK(dump("#debug \"x\" -3 #warning concat(\"a\", S) #error S #render \"\" #statistics \"\"") ==
        "#debug \"x\" (neg 3) #warning concat(\"a\" S) #error S #render \"\" #statistics \"\"");
  CHECK(dump("#include \"a.inc\" #include A[1]") == "#include \"a.inc\" #include A[1]");
  CHECK(dump("#debug #if(c) \"a\" #end") == "#debug none #if (c){\"a\"}");
}

TEST_CASE("version: is a directive after `#` and a value elsewhere", "[grammar][version]") {
  CHECK(dump("#declare T = version; #version 3.7; #version T;") ==
        "#declare T=version; #version 3.7 #version T");
  CHECK(dump("#version rgb 3.7;") == "#version none :rgb 3.7 ';'");
}

TEST_CASE("files: operands follow as items", "[grammar][files]") {
  CHECK(dump("#fopen H \"f\" write #fclose H") == "#fopen H \"f\" :write #fclose H");
  CHECK(dump("#read (H, A, B[1])") == "#read open(H ',' A ',' B[1])");
  CHECK(dump("#write (H, V <1,2,3>, uint16le 258 \"\\n\") -1") ==
        "#write open(H ',' V <1 2 3> ',' :uint16le 258 \"\\n\") (neg 1)");
  CHECK(dump("#default { finish { ambient 0 } }") == "#default {:finish {:ambient 0}}");
}

TEST_CASE("unknown directives: errors at once outside of bodies, later inside",
          "[grammar][directives]") {
  const Parsed p("#delcare A = 1;");
  REQUIRE(p.tree == nullptr);
  CHECK(p.diagnostics.all()[0].message == "there is no directive `#delcare`");
  CHECK(p.diagnostics.all()[0].help.at(0) == "did you mean `#declare`?");
  CHECK(dump("#if (0) #delcare A #end") == "#if (0){#unknown delcare A}");
}

TEST_CASE("directives: stand between any two tokens of a block", "[grammar][directives]") {
  CHECK(dump("sphere { #declare r=1; 0, #if(c) r #else 2 #end pigment { #include \"p.inc\" } }") ==
        ":sphere {#declare r=1; 0 ',' #if (c){r} else {2} :pigment {#include \"p.inc\"}}");
  CHECK(dump("color_map { #while(i<1) [i rgb i] #end }") ==
        ":color_map {#while ((< i 1)){[i :rgb i]}}");
}

TEST_CASE("directives: spans end with the head", "[grammar][spans]") {
  const Parsed p("#if ( a ) b #else c #end #declare X = 1 ; #macro M( a ) #end #include \"f\" ");
  REQUIRE(p.tree != nullptr);
  const auto& items = p.tree->items;
  const auto top = p.tree->top.first;
  CHECK(p.text(items[top].span) == "#if ( a )");
  CHECK(p.text(items[top + 1].span) == "#declare X = 1 ;");
  CHECK(p.text(items[top + 2].span) == "#macro M( a )");
  CHECK(p.text(items[top + 3].span) == "#include \"f\"");
  const auto& chain = std::get<ast::If>(p.tree->directives[items[top].ref].node);
  CHECK(p.text(p.tree->branches[chain.branches.first + 1].span) == "#else");
  const auto& macro = std::get<ast::Macro>(p.tree->directives[items[top + 2].ref].node);
  CHECK(p.text(macro.head) == "M( a )");
  const auto& declare = std::get<ast::Declare>(p.tree->directives[items[top + 1].ref].node);
  CHECK(p.text(declare.target) == "X");
}

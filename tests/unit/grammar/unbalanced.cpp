// The irregular uses of language §7.4, and what is an error all the same.
#include "tests/support/catch.h"
#include "tests/unit/grammar/dump.h"

using durer::test::diagnose;
using durer::test::dump;
using durer::test::Parsed;

TEST_CASE("unbalanced: branches open alternative blocks", "[grammar][unbalanced]") {
  CHECK(dump("#macro B(M) #if(M) merge { #else union { #end a b } #end") ==
        "#macro B(M){#if (M){:merge '{'} else {:union '{'} a b '}'}");
  CHECK(dump("#if(M) merge { #else union { #end a }") ==
        "#if (M){:merge '{'} else {:union '{'} a '}'");
  CHECK(dump("#switch(M) #case(1) merge { #break #else union { #end a }") ==
        "#switch (M) case (1){:merge '{' #break} else{:union '{'} a '}'");
}

TEST_CASE("unbalanced: an optional wrapper is closed by a second conditional",
          "[grammar][unbalanced]") {
  CHECK(dump("#if(c) merge{ #end a b #if(c) } #end") == "#if (c){:merge '{'} a b #if (c){'}'}");
  CHECK(dump("object { #if(c) merge{ #end a #if(c) } #end scale 2 }") ==
        ":object {#if (c){:merge '{'} a #if (c){'}'} :scale 2}");
  CHECK(dump("#local P = #if(F) #if(M) merge{ #else union{ #end #end a #if(F) b } #end") ==
        "#local P=none #if (F){#if (M){:merge '{'} else {:union '{'}} a #if (F){b '}'}");
}

TEST_CASE("unbalanced: an outer block keeps its own brace", "[grammar][unbalanced]") {
  // The inner brace is closed by the conditional, so the last one belongs to the outer block.
  CHECK(dump("union { union { #if(c) } #else b } #end }") ==
        ":union {:union '{' #if (c){'}'} else {b '}'}}");
  CHECK(dump("union { #if(c) } #else } #end") == ":union '{' #if (c){'}'} else {'}'}");
}

TEST_CASE("unbalanced: one branch writes, the other builds", "[grammar][unbalanced]") {
  CHECK(dump("#macro G(w) #if(w) #fopen f N write #write(f,\"mesh{\\n\") #else mesh{ #end a "
             "#if(w) #write(f,\"}\") #fclose f #else translate v_ } #end #end") ==
        "#macro G(w){#if (w){#fopen f N :write #write open(f ',' \"mesh{\\n\")} else {:mesh '{'} a "
        "#if (w){#write open(f ',' \"}\") #fclose f} else {:translate v_ '}'}}");
}

TEST_CASE("unbalanced: arguments of #write continue across directives", "[grammar][unbalanced]") {
  CHECK(dump("#macro H() #if(W) #write(F,n, #else mesh2{vertex_vectors{n, #end "
             "#while(i) #if(W) \",\", P[i][j], #else P[i][j], #end #end "
             "#if(W) \"}\") #else }} #end #end") ==
        "#macro H(){#if (W){#write '(' F ',' n ','} else {:mesh2 '{' :vertex_vectors '{' n ','} "
        "#while (i){#if (W){\",\" ',' P[i][j] ','} else {P[i][j] ','}} "
        "#if (W){\"}\" ')'} else {'}' '}'}}");
}

TEST_CASE("unbalanced: an argument list is split by a conditional", "[grammar][unbalanced]") {
  CHECK(dump("#if(c) M(1, #else M(2, #end 3)") == "#if (c){M '(' 1 ','} else {M '(' 2 ','} 3 ')'");
  CHECK(dump("f(1, #if(c) 2, #end 3)") == "open f(1 ',' #if (c){2 ','} 3)");
}

TEST_CASE("unbalanced: macros open what their caller closes", "[grammar][unbalanced]") {
  CHECK(dump("#macro O() sphere { 0, 1 #end union { O() scale 2 } box {0,1} }") ==
        "#macro O(){:sphere '{' 0 ',' 1} :union {O() :scale 2 '}' :box {0 ',' 1}}");
  CHECK(dump("Open() a }") == "Open() a '}'");
  CHECK(dump("union { a Close()") == ":union '{' a Close()");
}

TEST_CASE("unbalanced: brackets without partner are errors outside of bodies",
          "[grammar][unbalanced]") {
  CHECK(diagnose("sphere { 0, 1") == "D0102 1:14 no matching `}`");
  CHECK(diagnose("sphere { 0, 1 } }") == "D0102 1:17 no matching `{`");
  CHECK(diagnose("sphere { (0, 1 }") == "D0102 1:16 no matching `)`");
  CHECK(diagnose("sphere { 0), 1 }") == "D0102 1:11 no matching `(`");
  CHECK(diagnose("color_map { [0 rgb 1 }") == "D0102 1:22 no matching `]`");
  CHECK(diagnose("sphere { sin(1), 1") == "D0102 1:19 no matching `}`");
}

TEST_CASE("unbalanced: the diagnostic shows what was opened", "[grammar][unbalanced]") {
  const Parsed flat("union { sphere { 0, 1 box { 0, 1 } }");
  REQUIRE(flat.tree == nullptr);
  const auto& d = flat.diagnostics.all().at(0);
  REQUIRE(d.labels.size() == 1);
  CHECK(flat.sources.place(d.labels[0].span.begin).column == 7);
  CHECK(d.labels[0].text == "this `{` is still open");
}

TEST_CASE("unbalanced: indentation tells where a brace is missing", "[grammar][unbalanced]") {
  const Parsed p("union {\n  sphere {\n    0, 1\n  box {\n    0, 1\n  }\n}\n");
  REQUIRE(p.tree == nullptr);
  const auto& d = p.diagnostics.all().at(0);
  REQUIRE(d.labels.size() == 2);
  CHECK(d.labels[1].text == "the `}` that closes this one is indented otherwise");
  CHECK(p.sources.place(d.labels[1].span.begin).line == 2);
}

TEST_CASE("unbalanced: directives must pair", "[grammar][unbalanced]") {
  CHECK(diagnose("#if (1)\n a") == "D0102 2:3 no matching `#end`");
  CHECK(diagnose("#end") == "D0102 1:1 `#end` without a directive to end");
  CHECK(diagnose("#while (1) #else #end") == "D0102 1:12 `#else` without `#if`");
  CHECK(diagnose("#switch (1) #case (1) #if (2) #case (3) #end #end") ==
        "D0102 1:31 `#case` without `#switch`");
  CHECK(diagnose("#if (1) #else #elseif (2) #end") ==
        "D0101 1:16 expected `#end`, found the reserved word `elseif`");
  const Parsed p("#if (1)\n#while (2)\n#end\n");
  CHECK(p.sources.place(p.diagnostics.all().at(0).labels.at(0).span.begin).line == 1);
}

#include "tests/support/catch.h"
#include "tests/unit/grammar/dump.h"
#include "tests/unit/grammar/equal.h"

using durer::test::Parsed;

TEST_CASE("print: parsing the printed text gives an equal tree", "[grammar][print]") {
  const auto source = GENERATE(
      "", "1 .5 1e300 1e999 0.1 123456789012345678", R"("a\"b\\" "C:\x")",
      "sphere { <0,1,-2>, A[1][2].x texture { T scale -1 } }",
      "#declare X = a*(b+c)/-d; #local S = \"x\" #declare Y = Z texture {T}",
      "#declare deprecated once \"m\" A[1] = 1; #undef A[1]",
      "#if (a<b & c!=d | !e) 1 #elseif (x>=y) 2 #else 3 #end #ifdef(A) #end #ifndef(B[1]) #end",
      "#switch(a) #case(1) b #break #range(2,3) c #else d #end",
      "#for (I,0,10,2) #end #for (I,0,1) a #end #while(1) #end #macro M(a,b) a+b #end",
      "#version 3.7; -1 #include \"f\" #debug str(1,2,3) #default {} #fopen F \"f\" read "
      "#read(F,A)",
      "<1, #if(c) 2 #else 3 #end> (1 #if(c) +2 #end) f(rgb 1,) A[#if(c) 1 #end][2] f(,)",
      "#macro B(M) #if(M) merge { #else union { #end a ( ] < 3 <= >= != #foo #if x #end #end",
      "function(x,y) { x | y & f(x,y).red ? 1 : 2 } (a ? b : c ? d : e)",
      "\xEF\xBB\xBF\"\xC3\xA9\"", "color_map { [0 rgb 1][1 rgb 0] }", "- - + ! a", "-(-1)--1");
  CAPTURE(source);
  Parsed first(source);
  REQUIRE(first.tree != nullptr);
  const std::string text = durer::grammar::print(*first.tree, first.symbols);
  CAPTURE(text);
  const durer::FileId file = first.sources.add("printed", text);
  const auto second = durer::grammar::parse(first.sources, file, first.symbols, first.diagnostics);
  REQUIRE(second != nullptr);
  CHECK(durer::ast::same(*first.tree, *second));
  CHECK(durer::grammar::print(*second, first.symbols) == text);
}

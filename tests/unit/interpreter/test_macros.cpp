#include "support.h"
#include "tests/support/catch.h"

using namespace durer::interpreter::test;

namespace {
std::string printed(const std::string& text) {
  const Run r = run(text);
  return r.errors.empty() ? r.debug : r.errors.front();
}
}  // namespace

TEST_CASE("macros: bodies are spliced, not called", "[interpreter][macros]") {
  const std::string m = "#macro M(a,b) a+b #end\n";
  CHECK(value_of("2*M(1,2)", m, 0) == "4");
  CHECK(value_of("M(1,2)*2", m, 0) == "5");
  CHECK(value_of("(2*M(1,2))", m, 0) == "4");
  CHECK(value_of("M(1,2)-M(3,4)", m, 0) == "4");  // 1+2-3+4
  CHECK(value_of("sin(M(0,0))", m, 0) == "0");
  CHECK(value_of("V().y", "#macro V() <1,2,3> #end", 0) == "2");
  CHECK(value_of("V().y*3", "#macro V() <1,2,3> #end", 0) == "6");
  CHECK(vector_of("<M(1,2),P(),3>", 3, m + "#macro P() 4 #end", 0) == "3 4 3");
  CHECK(vector_of("<Two(),3>", 3, "#macro Two() 1,2 #end", 0) == "1 2 3");
  CHECK(vector_of("<1,2,3>*F(2)", 3, "#macro F(a) (a*10) #end", 0) == "20 40 60");
}

TEST_CASE("macros: a body of statements ends in a value", "[interpreter][macros]") {
  CHECK(value_of("F(5)", "#macro F(n) #local r=1; #while (n>1) #local r=r*n; #local n=n-1; #end r #end", 0) == "120");
  CHECK(value_of("Fact(6)", "#macro Fact(n) #if (n<=1) 1 #else (n*Fact(n-1)) #end #end", 0) == "720");
  CHECK(printed("#macro T(s) concat(s,\"!\") #end #debug T(\"hi\")") == "hi!");
}

TEST_CASE("macros: what follows the value of a declare waits for it", "[interpreter][macros]") {
  CHECK(printed("#version 3.1; #macro F() 5 #end #declare A = F()\n#if (A = 5) #debug \"yes\" #end") == "yes");
  CHECK(printed("#macro F() #local R = 5; R #end #declare A = F();\n#if (A = 5) #debug \"yes\" #end") == "yes");
  CHECK(printed("#macro F() #local R = 5; R; #end #macro G() #local A = F()\n#if (A = 5) #debug \"yes\" #end #end G()") == "yes");
  CHECK(printed("#macro F() #local R = 5; R; #end #declare A = F()\n#if (A = 5) #debug \"yes\" #end") == "yes");
}

TEST_CASE("macros: names are passed by reference", "[interpreter][macros]") {
  CHECK(printed("#macro M(P) #local P=6; #end #declare A=1; M(A) #debug str(A,0,0)") == "6");
  CHECK(printed("#macro M(P) #declare P=6; #end #declare A=1; M(A) #debug str(A,0,0)") == "6");
  CHECK(printed("#macro M(P) #local P=6; #end #declare A=1; M((A)) #debug str(A,0,0)") == "1");
  CHECK(printed("#macro M(P) #declare P[0]=7; #end #declare A=array[1]{1} M(A) #debug str(A[0],0,0)") == "7");
  CHECK(printed("#macro M(P) #declare P=7; #end #declare A=array[2]{1,2} M(A[1]) #debug str(A[1],0,0)") == "7");
  CHECK(printed("#macro N(Q) #declare Q=8; #end #macro M(P) N(P) #end #declare A=1; M(A) #debug str(A,0,0)") == "8");
  CHECK(printed("#macro M() #local A[0]=5; #end #declare A=array[1]{1} M() #debug str(A[0],0,0)") == "1");
}

TEST_CASE("macros: scopes are dynamic", "[interpreter][macros]") {
  CHECK(printed("#macro Inner() #debug str(L,0,0) #end #macro Outer() #local L=3; Inner() #end Outer()") == "3");
  CHECK(printed("#macro M() #local L=3; #end M() #ifdef(L) #debug \"leak\" #else #debug \"ok\" #end") == "ok");
  CHECK(printed("#declare A=1; #macro M() #local A=2; #declare A=3; #end M() #debug str(A,0,0)") == "1");
  CHECK(printed("#macro M(I) #for(I,0,2) #end #end #declare K=9; M((K)) #debug str(K,0,0)") == "9");
  CHECK(printed("#declare I=7; #macro M() #for(I,0,2) #end #end M() #debug str(I,0,0)") == "7");
}

TEST_CASE("macros: #break returns", "[interpreter][macros]") {
  CHECK(printed("#macro M() #debug \"a\" #break #debug \"b\" #end M() #debug \"c\"") == "ac");
}

TEST_CASE("macros: arguments of every kind", "[interpreter][macros]") {
  CHECK(printed("#macro M(c) #debug vstr(3,c,\",\",0,1) #end M(rgb <1,.5,0>)") == "1.0,0.5,0.0");
  const Run r = run("#macro Ball(p, tx) sphere { p, 1 texture { tx } } #end\n"
                    "Ball(<1,2,3>, texture { pigment { rgb 1 } })");
  REQUIRE(r.scene);
  CHECK(r.scene->roots.size() == 1);
  CHECK(printed("#macro M(a,b,c) #debug str(a+b*c,0,0) #end M(1 2 3)") == "7");
  CHECK(printed("#macro M(a,b) #debug str(a-b,0,0) #end M(1, #if (1) 5 #else 6 #end)") == "-4");
  CHECK(printed("#macro M(a,b) #debug str(a-b,0,0) #end M(#if (1) 1, 2 #else 3, 4 #end)") == "-1");
  CHECK(printed("#macro M(a) #end M(1,2)").substr(0, 5) == "D0202");
  CHECK(printed("#macro M(a) #end M(Undeclared)").substr(0, 5) == "D0203");
}

TEST_CASE("macros: runaway recursion is an error", "[interpreter][limits]") {
  CHECK(error_of("#macro M() M() #end M()").substr(0, 5) == "D0303");
  CHECK(error_of("#macro M(n) (1+M(n+1)) #end #declare A = M(0);").substr(0, 5) == "D0303");
}

// What the language has had since 3.8 (language §1.6, §4.6, §5.1).
#include "support.h"
#include "tests/support/catch.h"

using namespace durer::interpreter;
using namespace durer::interpreter::test;

namespace {

/// What a scene of version 3.8 prints; the first error if there is one.
std::string says(const std::string& text) {
  const Run r = run("#version 3.8;\n" + text, false);
  return r.errors.empty() ? r.debug : r.errors.front();
}

/// The same for the float that `expression` is worth after `text`.
std::string worth(const std::string& text, const std::string& expression) {
  return says(text + "\n#debug str(" + expression + ", 0, 3)");
}

}  // namespace

TEST_CASE("additions: new words are reserved since 3.8 only", "[interpreter][additions]") {
  CHECK(value_of("mixed", "#declare mixed = 3;", 0) == "3");
  CHECK(value_of("global.x + optional", "#declare global = <7,8,9>; #declare optional = 1;", 0) ==
        "8");
  CHECK(value_of("dictionary[1]", "#declare dictionary = array[2]{1,2};", 0) == "2");
  CHECK(error_of("#debug str(tau, 0, 0)") == "D0203 at 1:12: `tau` is not declared");
  CHECK(says("#declare mixed = 3;") ==
        "D0201 at 2:10: `mixed` is a word of the language since version 3.8");
  CHECK(says("#macro optional() 1 #end").substr(0, 5) == "D0201");
}

TEST_CASE("additions: tau and atand", "[interpreter][additions]") {
  CHECK(worth("", "tau") == "6.283");
  CHECK(worth("", "atand(1)") == "45.000");
  CHECK(worth("#declare F = function(x) { x*tau }", "F(2)") == "12.566");
}

TEST_CASE("additions: versions up to 3.8", "[interpreter][additions]") {
  CHECK(worth("", "version") == "3.800");
  CHECK(run("#version 3.9;", false).errors.front().substr(0, 5) == "D0306");
  const Run native = run("#debug str(version,0,2) sphere { srgb 1, 1 }", false, {}, "a.scene");
  CHECK(native.debug == "3.80");
  CHECK(run("#debug str(version,0,2)", false, {}, "a.pov").debug == "3.70");
  CHECK(run("#version 3.5; #debug str(version,0,2)", false, {}, "a.scene").debug == "3.50");
  Options option;
  option.version = 380;
  CHECK(run("#debug str(version + tau,0,2)", false, option).debug == "10.08");
}

TEST_CASE("additions: dictionaries hold values of any kind", "[interpreter][additions]") {
  const std::string d =
      "#declare D = dictionary { [\"a\"]: 1, .b: \"text\", .c: <1,2,3>, .o: sphere { 0, 1 },\n"
      "  .list: array[2] { 5, 6 }, .sub: dictionary { .deep: 9 }, .f: function(x) { x*x } }\n";
  CHECK(worth(d, "D.a") == "1.000");
  CHECK(worth(d, "D[\"a\"] + D.sub.deep") == "10.000");
  CHECK(worth(d, "D.list[1] + D.sub[\"deep\"]") == "15.000");
  CHECK(worth(d, "D.f(4)") == "16.000");
  CHECK(worth(d, "strlen(D.b)") == "4.000");
  CHECK(says(d + "#debug D.b #debug concat(D[\"b\"], \"!\")") == "texttext!");
  CHECK(says(d + "#debug vstr(3, D.c*2, \",\", 0, 0)") == "2,4,6");
  CHECK(says(d + "object { D.o translate D.c }") == "");
  CHECK(worth(d + "#declare V = D.c; #declare E = D[\"list\"];", "V.y + E[0]") == "7.000");
  CHECK(worth(d + "#declare K = \"sub\";", "D[K].deep") == "9.000");
}

TEST_CASE("additions: vectors in dictionaries have components", "[interpreter][additions]") {
  const std::string d =
      "#version 3.8; #declare K = dictionary { .at: <0.5,0.25>, .list: array[2] { <1,2,3>, y } };";
  CHECK(value_of("K.at.x + K.at.y", d, 2) == "0.75");
  CHECK(value_of("K.list[0].z*K[\"at\"].x", d, 1) == "1.5");
}

TEST_CASE("additions: entries are targets", "[interpreter][additions]") {
  CHECK(worth("#declare D = dictionary; #declare D.a = 3; #declare D[\"b\"] = D.a*2;",
              "D.a + D.b") == "9.000");
  CHECK(worth("#declare D = dictionary {} #declare D.a = 3; #declare D.a = \"four\";",
              "strlen(D.a)") == "4.000");
  CHECK(worth("#declare D = dictionary { .s: dictionary } #declare D.s.x1 = 3;", "D.s.x1") ==
        "3.000");
  CHECK(worth("#declare D = dictionary { .l: array[2] } #declare D.l[1] = 3;", "D.l[1]") ==
        "3.000");
  CHECK(worth("#declare A = array[2]; #declare A[0] = dictionary; #declare A[0].k = 4;",
              "A[0].k") == "4.000");
  CHECK(worth("#declare A = array[2]; #declare A[1] = dictionary; #declare A[1][\"k\"] = 4;",
              "A[1][\"k\"]") == "4.000");
}

TEST_CASE("additions: dictionaries are copied, and passed by reference",
          "[interpreter][additions]") {
  CHECK(worth("#declare D = dictionary { .a: 1 } #declare E = D; #declare E.a = 2;", "D.a") ==
        "1.000");
  CHECK(worth("#declare D = dictionary { .a: 1 } #macro M(P) #declare P.a = 5; #end M(D)", "D.a") ==
        "5.000");
  CHECK(worth("#declare D = dictionary { .a: 1 } #macro M(P) #declare P = 5; #end M(D.a)",
              "D.a") == "5.000");
}

TEST_CASE("additions: entries can be asked for and removed", "[interpreter][additions]") {
  const std::string d = "#declare D = dictionary { .a: 1, .b: 2 }\n";
  CHECK(worth(d, "defined(D.a)*10 + defined(D.zzz)") == "10.000");
  CHECK(says(d + "#ifdef (D[\"a\"]) #debug \"yes\" #end #ifndef (D[\"q\"]) #debug \"no\" #end") ==
        "yesno");
  CHECK(says(d + "#undef D.a #undef D[\"b\"] #ifdef (D.a) #debug \"yes\" #end #ifdef (D.b) "
                 "#debug \"yes\" #end") == "");
  CHECK(says(d + "#debug str(D.aa, 0, 0)") == "D0203 at 3:12: the dictionary has no entry `aa`");
  CHECK(run("#version 3.8; #declare D = dictionary { .key: 1 }\n#debug str(D.kye, 0, 0)", false)
            .help == std::vector<std::string>{"did you mean `key`?"});
  CHECK(says("#declare N = 1;\n#declare N.a = 2;") ==
        "D0204 at 3:10: expected a dictionary, found a float");
}

TEST_CASE("additions: only what can be called is called", "[interpreter][additions]") {
  CHECK(says("#declare S = 1; #declare A = S(1, sphere).S(1, sphere);").substr(0, 5) == "D0204");
  CHECK(error_of("#declare A = S(1, sphere).S(1, sphere);").substr(0, 5) == "D0204");
  CHECK(error_of("#declare S = 1; #declare A = S.list[2];").substr(0, 5) == "D0204");
  CHECK(error_of("#declare F = function(x) { D.call(x) }").substr(0, 5) == "D0204");
}

TEST_CASE("additions: components stay what they were", "[interpreter][additions]") {
  CHECK(worth("#declare V = <1,2,3>;", "V.y + V.x") == "3.000");
  CHECK(worth("#declare A = array[2] { <1,2>, <3,4> }", "A[1].y") == "4.000");
  CHECK(worth("#declare S = seed(0); #declare A = array[2] { <1,2>, <3,4> } "
              "#declare B = A[int(rand(S)*2)].y;",
              "rand(S)") == "0.467");
}

TEST_CASE("additions: the scopes are dictionaries", "[interpreter][additions]") {
  CHECK(worth("#declare A = 1; #macro M() #local A = 2; global.A*10 + local.A #end", "M()") ==
        "12.000");
  CHECK(worth("#macro M() #declare global.G = 7; #declare local.L = 1; #end M()",
              "G + defined(L)") == "7.000");
  CHECK(worth("#declare Q = 4;", "global[\"Q\"]") == "4.000");
  CHECK(says("#declare P = 1; #macro M() #ifdef (local.P) #debug \"yes\" #end #end M()") == "");
}

TEST_CASE("additions: parameters may be optional", "[interpreter][additions]") {
  const std::string m =
      "#macro M(A, optional B, optional C)\n"
      "  A*100 #ifdef (local.B) + B*10 #end #ifdef (local.C) + C #end\n"
      "#end\n";
  CHECK(worth(m, "(M(1))") == "100.000");
  CHECK(worth(m, "(M(1, 2))") == "120.000");
  CHECK(worth(m, "(M(1, 2, 3))") == "123.000");
  CHECK(worth(m, "(M(1,, 3))") == "103.000");
  CHECK(worth(m, "(M(1, Undeclared, 3))") == "103.000");
  CHECK(says(m + "#debug str(M(), 0, 0)").substr(0, 5) == "D0202");
  CHECK(says(m + "#debug str(M(1,2,3,4), 0, 0)").substr(0, 5) == "D0202");
}

TEST_CASE("additions: several targets at once", "[interpreter][additions]") {
  CHECK(worth("#declare (A, B) = (1, 2);", "A*10 + B") == "12.000");
  CHECK(worth("#declare A = 1; #declare B = 2; #declare (A, B) = (B, A);", "A*10 + B") ==
        "22.000");
  CHECK(worth("#declare <A, B, C> = <1,2,3>*2;", "A*100 + B*10 + C") == "246.000");
  CHECK(worth("#declare {A,, B} = array[3] { 1, 2, 3 };", "A*10 + B") == "13.000");
  CHECK(worth("#declare {A} = array[1] { \"x\" };", "strlen(A)") == "1.000");
  CHECK(worth("#declare D = dictionary; #declare L = array[2]; #declare (D.k, L[1]) = (4, 5);",
              "D.k*10 + L[1]") == "45.000");
  CHECK(worth("#macro M() #local (A, B) = (1, 2); #end M()", "defined(A)") == "0.000");
  CHECK(says("#declare (A, B) = (1);").substr(0, 5) == "D0202");
  CHECK(says("#declare <A, B> = <1,2,3>;").substr(0, 5) == "D0202");
  CHECK(says("#declare <A, B> = 5;").substr(0, 5) == "D0204");
  CHECK(error_of("#declare (A, B) = (1, 2);").substr(0, 5) == "D0306");
}

TEST_CASE("additions: mixed arrays", "[interpreter][additions]") {
  const std::string a = "#declare A = array mixed[3] { 1, \"two\", <3,3,3> }\n";
  CHECK(worth(a, "A[0] + strlen(A[1]) + A[2].z") == "7.000");
  CHECK(worth(a + "#declare A[0] = \"four\";", "strlen(A[0])") == "4.000");
  CHECK(worth("#declare A = array mixed { 1, \"two\" }", "dimension_size(A, 1)") == "2.000");
  CHECK(says("#declare A = array[2] { 1, \"two\" }").substr(0, 5) == "D0204");
}

TEST_CASE("additions: arrays without size grow", "[interpreter][additions]") {
  CHECK(worth("#declare A = array; #for (I, 0, 9) #declare A[I] = I*I; #end",
              "A[9] + dimension_size(A, 1)") == "91.000");
  CHECK(worth("#declare A = array { 1, 2, 3 } #declare A[5] = 7;",
              "dimension_size(A, 1)*10 + defined(A[4])") == "60.000");
  CHECK(worth("#declare A = array[] { 1, 2 }", "A[1]") == "2.000");
  CHECK(says("#declare A = array; #debug str(A[0], 0, 0)").substr(0, 5) == "D0302");
  CHECK(error_of("#declare A = array;").substr(0, 5) == "D0202");
}

TEST_CASE("additions: initialisers may leave elements out", "[interpreter][additions]") {
  CHECK(worth("#declare A = array[4] optional { 1,, 3 }",
              "A[0] + A[2] + 10*defined(A[1]) + 100*defined(A[3])") == "4.000");
  CHECK(worth("#declare A = array[2][2] optional { { 1 }, { , 4 } }", "A[0][0] + A[1][1]") ==
        "5.000");
  CHECK(says("#declare A = array[4] { 1, 2, 3 }").substr(0, 5) == "D0202");
}

TEST_CASE("additions: entries of dictionaries go to macros by reference", "[interpreter][additions]") {
  const std::string add =
      "#macro Add(P) #declare P = P + 1; #end "
      "#declare D = dictionary { .a: 1, [\"b\"]: <1,2,3>, .c: array[2] {5, 6}, "
      ".d: dictionary { .e: 7 } };";
  CHECK(worth(add + "Add(D.a)", "D.a") == "2.000");
  CHECK(worth(add + "Add(D[\"b\"])", "D.b.z") == "4.000");
  CHECK(worth(add + "Add(D.c[1])", "D.c[1]") == "7.000");
  CHECK(worth(add + "#macro Inner(P) Add(P.e) #end Inner(D.d)", "D.d.e") == "8.000");
  CHECK(worth(add + "#declare A = array[2] { D, D } Add(A[1].a)", "100*A[1].a + 10*A[0].a + D.a") ==
        "211.000");
  CHECK(worth(add + "#declare G = 1; Add(global.G)", "G") == "2.000");
  CHECK(worth(add + "#macro Text(P) #declare P = \"text\"; #end Text(D.a)", "strlen(D.a)") ==
        "4.000");
  CHECK(worth(add + "Add(D.b.y)", "D.b.y") == "2.000");  // a component has no place of its own
  CHECK(says(add + "Add(D.missing)").substr(0, 5) == "D0203");
}

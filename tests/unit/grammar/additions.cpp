// What the language has had since 3.8 only.
#include "tests/support/catch.h"
#include "tests/unit/grammar/dump.h"

using durer::test::diagnose;
using durer::test::dump;

TEST_CASE("additions: entries of dictionaries are places", "[grammar][additions]") {
  CHECK(dump("#declare D.key = 1;") == "#declare D.key=1;");
  CHECK(dump("#local D[\"a\"] = 1;") == "#local D[\"a\"]=1;");
  CHECK(dump("#declare D.list[2].name = 1;") == "#declare D.list[2].name=1;");
  CHECK(dump("#undef D.key") == "#undef D.key");
  CHECK(dump("D.call(1) D.list[2] D.sub.key") == "D.call(1) D.list[2] D.sub.key");
  CHECK(dump("#ifdef (D.key) 1 #end") == "#ifdef D.key{1}");
}

TEST_CASE("additions: components are no entries", "[grammar][additions]") {
  CHECK(dump("A.x (3)") == "A.x (3)");
  CHECK(dump("A.red [1 2]") == "A.red [1 2]");
  CHECK(diagnose("A.x.y").substr(0, 5) == "D0101");
}

TEST_CASE("additions: dictionaries have keys and values", "[grammar][additions]") {
  CHECK(dump("#declare D = dictionary { [\"a\"]: 1, .b: -x };") ==
        "#declare D=none dictionary {[\"a\"] ':' 1 ',' '.' b ':' (neg x)} ';'");
}

TEST_CASE("additions: the scopes are dictionaries", "[grammar][additions]") {
  CHECK(dump("#ifndef (local.P) local.P + global.Q #end") ==
        "#ifndef local.P{(+ local.P global.Q)}");
  CHECK(dump("#declare local.P = 1;") == "#declare local.P=1;");
}

TEST_CASE("additions: several targets at once", "[grammar][additions]") {
  CHECK(dump("#declare (A, B[1]) = (1, 2);") == "#declare (A B[1]= open(1 ',' 2) ';'");
  CHECK(dump("#local <A, B> = V;") == "#local <A B= V ';'");
  CHECK(dump("#declare {A, , B} = C;") == "#declare {A none B= C ';'");
  CHECK(diagnose("#declare (1) = 2;") == "D0101 1:11 expected a name that is not reserved, found `1`");
  CHECK(diagnose("#declare (A = 2;").substr(0, 5) == "D0102");
}

TEST_CASE("additions: parameters may be optional", "[grammar][additions]") {
  CHECK(dump("#macro M(A, optional B, optional) #end") == "#macro M(A optional B optional){}");
}

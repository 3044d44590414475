#include "support.h"
#include "tests/support/catch.h"

using namespace durer::interpreter::test;

namespace {
std::string printed(const std::string& text) {
  const Run r = run(text);
  return r.errors.empty() ? r.debug : r.errors.front();
}
}  // namespace

TEST_CASE("directives: conditions", "[interpreter][directives]") {
  CHECK(printed("#if (1) #debug \"a\" #else #debug \"b\" #end") == "a");
  CHECK(printed("#if (0) #debug \"a\" #elseif (2) #debug \"b\" #else #debug \"c\" #end") == "b");
  CHECK(printed("#ifdef (A) #debug \"a\" #else #debug \"b\" #end") == "b");
  CHECK(printed("#declare A=1; #ifdef (A) #debug \"a\" #end #ifndef (A) #debug \"b\" #end") == "a");
  CHECK(printed("#if (defined(sphere)) #debug \"a\" #else #debug \"b\" #end") == "b");
  CHECK(printed("#declare A = array[2]; #declare A[1]=5; #debug "
                "str(defined(A[0])+2*defined(A[1]),0,0)") == "2");
  CHECK(printed("#if (0) @ nonsense $ } #frobnicate #end #debug \"ok\"") == "ok");
}

TEST_CASE("directives: #while and #for", "[interpreter][directives]") {
  CHECK(printed("#declare I=0; #while (I<3) #debug str(I,0,0) #declare I=I+1; #end") == "012");
  CHECK(printed("#for (I,0,10,4) #declare I=I+1; #debug concat(str(I-1,0,0),\" \") #end") ==
        "0 5 10 ");
  CHECK(printed("#declare N=0; #for (I,0,1,.1) #declare N=N+1; #end #debug str(N,0,0) #debug "
                "str(I,0,1)") == "111.1");
  CHECK(printed("#for (I,5,1,-2) #debug str(I,0,0) #end") == "531");
  CHECK(printed("#for (I,0,9) #if (I=3) #break #end #debug str(I,0,0) #end") == "012");
  CHECK(printed("#for (I,1,3) #for (J,1,I) #debug str(J,0,0) #end #end") == "112123");
  CHECK(printed("#for (I,0,3,0) #end").substr(0, 5) == "D0302");
}

TEST_CASE("directives: #switch falls through, even into #else", "[interpreter][directives]") {
  CHECK(printed("#switch(1) #case(1) #debug \"a\" #case(2) #debug \"b\" #else #debug \"c\" #end") ==
        "abc");
  CHECK(
      printed(
          "#switch(3) #case(1) #debug \"a\" #break #range(2,4) #debug \"b\" #case(9) #debug \"c\" "
          "#break #else #debug \"d\" #end") == "bc");
  CHECK(printed("#switch(7) #case(1) #debug \"a\" #else #debug \"e\" #end") == "e");
}

TEST_CASE("directives: names and scopes", "[interpreter][directives]") {
  CHECK(printed("#declare A=1; #undef A #ifdef(A) #debug \"still\" #else #debug \"gone\" #end") ==
        "gone");
  CHECK(printed("#local A=2; #debug str(A,0,0)") == "2");
  CHECK(printed("#declare sphere = 5;").substr(0, 2) == "D0");
  CHECK(printed("#declare D=1; #declare D=\"s\"; #debug D") == "s");
  CHECK(printed("#declare A=1;; #debug str(A,0,0)") == "1");
}

TEST_CASE("directives: arrays", "[interpreter][arrays]") {
  CHECK(printed("#declare A = array[3] {1,2,3} #debug str(A[0]+A[1]*A[2],0,0)") == "7");
  CHECK(printed("#declare A = array[2][2] {{1,2},{3,4}} #debug str(A[1][0],0,0)") == "3");
  CHECK(printed("#declare A = array[2][2] {{1,2},{3,4}} #debug "
                "str(dimension_size(A,2)+dimensions(A),0,0)") == "4");
  CHECK(printed(
            "#declare A = array[2] {1,2} #declare B = A; #declare B[0]=9; #debug str(A[0],0,0)") ==
        "1");
  CHECK(printed("#declare A = array[2] {\"x\",\"y\"} #debug A[1]") == "y");
  CHECK(printed("#declare A = array[2] {1,2} #debug str(A[0.9999999999999],0,0)") == "2");
  CHECK(printed("#declare A = array[2] {1,2} #debug str(A[2],0,0)").substr(0, 5) == "D0302");
  CHECK(printed("#declare A = array[2] {1 2 3}").substr(0, 2) == "D0");
  CHECK(printed("#declare A = array[3] {1 2}").substr(0, 2) == "D0");
  CHECK(printed("#declare A = array[2] {1, x}").substr(0, 5) == "D0204");
  CHECK(printed("#declare A = array[2] {rgb 1 rgb 0} #debug vstr(3, A[0], \",\", 0, 0)") ==
        "1,1,1");
  CHECK(printed("#declare A = array[2]; #declare A[0] = array[2] {4,5} #debug str(A[0][1],0,0)") ==
        "5");
}

TEST_CASE("directives: messages", "[interpreter][directives]") {
  CHECK(printed("#error \"stop here\"") == "D0304 at 1:1: stop here");
  const Run r = run("#warning \"careful\"");
  REQUIRE(r.warnings.size() >= 1);
  CHECK(r.warnings.front() == "D0305 at 1:1: careful");
  CHECK(printed("#debug 5").substr(0, 5) == "D0204");
}

TEST_CASE("directives: #version", "[interpreter][directives]") {
  CHECK(printed("#debug str(version,0,2)") == "3.70");
  CHECK(printed("#version 3.5; #debug str(version,0,2)") == "3.50");
  CHECK(printed("#declare V = version; #version 3.5; #version V; #debug str(version,0,2)") ==
        "3.70");
  CHECK(printed("#version 3.9;").substr(0, 5) == "D0306");
  CHECK(run("sphere {0,1}", false).scene->settings.effective_version == 362);
  CHECK(run("sphere {0,1}").scene->settings.effective_version == 370);
}

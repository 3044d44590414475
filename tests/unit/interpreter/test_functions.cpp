// Functions of the user in scenes (language §6). What a body computes to the last bit is tested in
// tests/unit/functions; here is what surrounds it. Values are the oracle's.
#include <array>
#include <fstream>
#include <sstream>

#include "functions/evaluate.h"
#include "tests/support/catch.h"
#include "tests/unit/interpreter/support.h"

namespace durer::interpreter::test {
namespace {

/// Stands in for the tracer: patterns are x / 2, pigments <x, y, z, 0.25, 0.5>.
class FakePigments final : public scene::PigmentQueries {
 public:
  functions::External pattern_function(const scene::Scene&, const scene::Pigment&) override {
    functions::External e;
    e.name = "pattern";
    e.point = [](const void*, const functions::Context&, const double* p, double* out) {
      *out = p[0] / 2;
    };
    return e;
  }
  functions::External inside_function(const scene::Scene&, scene::ObjectId) override {
    functions::External e;
    e.name = "inside";
    e.point = [](const void*, const functions::Context&, const double* p, double* out) {
      *out = p[0] > 0 ? 1 : 0;
    };
    return e;
  }
  functions::External pigment_function(const scene::Scene&, const scene::Pigment&) override {
    functions::External e;
    e.name = "pigment";
    e.components = 5;
    e.point = [](const void*, const functions::Context&, const double* p, double* out) {
      std::copy_n(p, 3, out);
      out[3] = 0.25;
      out[4] = 0.5;
    };
    return e;
  }
};

std::string shown(const std::string& text) {
  FakePigments pigments;
  Options options;
  options.pigments = &pigments;
  const Run r = run(text, true, options);
  return r.errors.empty() ? r.debug : r.errors.front();
}
/// `call` to three decimals, after `before`.
std::string value(const std::string& before, const std::string& call) {
  return shown(before + "\n#debug str(" + call + ", 0, 3)");
}
std::string error(const std::string& text) {
  const std::string e = shown(text);
  return e.substr(e.find(": ") + 2);
}

}  // namespace

TEST_CASE("functions: parameters are x, y, z or what the list says", "[interpreter][functions]") {
  CHECK(value("#declare f = function { x*100+y*10+z }", "f(1,2,3)") == "123.000");
  CHECK(value("#declare f = function(a, b) { a*10+b }", "f(1,2)") == "12.000");
  CHECK(value("#declare f = function(a b) { a-b }", "f(3 2)") == "1.000");
  CHECK(value("#declare f = function(y) { y+x }", "f(3)") == "3.000");  // x has no argument
  CHECK(value("#declare f = function(x, u) { x }", "f(1,2)") == "2.000");
  CHECK(value("#declare f = function(u, v) { x*10+y }", "f(1,2)") == "12.000");
  CHECK(value("#declare f = function(a, a) { a }", "f(2,3)") == "2.000");
}

TEST_CASE("functions: variables are captured when the function is declared",
          "[interpreter][functions]") {
  CHECK(value("#declare A = 3; #declare f = function { A*x } #declare A = 4;", "f(2,0,0)") ==
        "6.000");
  CHECK(value("#declare A = array[2] {3, 4} #declare I = 1; #declare f = function { A[I]*x }",
              "f(2,0,0)") == "8.000");
  CHECK(value("#declare f = function { clock+pi+image_width*0 }", "f(0,0,0)") == "3.142");
  CHECK(value("#declare f = function { x } #declare g = function { f(x,y,z)+1 } #undef f "
              "#declare f = function { 7*x }",
              "g(2,0,0)") == "3.000");
}

TEST_CASE("functions: bodies may hold macros and directives", "[interpreter][functions]") {
  CHECK(value("#declare f = function { #if (1) x+ #end y }", "f(2,3,0)") == "5.000");
  CHECK(value("#macro M(A) A+1 #end #declare f = function { 2*M(3)*x }", "f(2,0,0)") == "8.000");
  CHECK(value("#macro M() x+1 #end #declare f = function { 2*M()*y }", "f(2,2,0)") == "6.000");
  CHECK(value("#macro M() x+1 #end #declare f = function { 2*(M())*y }", "f(2,2,0)") == "12.000");
  CHECK(value("#declare f = function { #local i=0; #while (i<3) x*i+ #local i=i+1; #end 0 }",
              "f(2,0,0)") == "6.000");
  CHECK(value("#declare f = function { x #if (1) +y #end * 2 }", "f(1,3,0)") == "7.000");
  CHECK(value("#macro P() pow(x,2)|0 #end #declare f = function { 1 & P() & 0 | 1 }", "f(1,3,0)") ==
        "1.000");
}

TEST_CASE("functions: operators bind as they do in functions", "[interpreter][functions]") {
  const auto at = [](const std::string& body) {
    return value("#declare f = function { " + body + " }", "f(1,2,3)");
  };
  CHECK(at("1|0&0") == "1.000");
  CHECK(at("x<y<z") == "1.000");
  CHECK(at("2--x") == "3.000");
  CHECK(at("-x*-y") == "2.000");
  CHECK(at("select(x-1, 5, 6, 7)") == "6.000");
  CHECK(at("select(-x, 5, 6)") == "5.000");
  CHECK(at("sum(i, 1, 3, prod(j, 1, i, j))") == "9.000");
  CHECK(at("max(x, y, z, 5, x|y)") == "5.000");
  CHECK(at("degrees(pi)+radians(0)") == "180.000");
  CHECK(at("1/0") == "inf");
  CHECK(at("x/(0)") == "inf");
}

TEST_CASE("functions: they can be copied, stored, passed and called from anywhere",
          "[interpreter][functions]") {
  CHECK(value("#declare f = function { x*2 } #declare g = f;", "g(2,0,0)") == "4.000");
  CHECK(value("#declare A = array[2] {function { x }, function { y }}", "A[1](1,2,3)") == "2.000");
  CHECK(value("#declare A = array[2] {function { x }, function { y }} "
              "#declare g = function { A[1](x,y,z)+1 }",
              "g(1,2,3)") == "3.000");
  CHECK(shown("#macro M(p) #debug str(p(7,2,3),0,0) #end M(function { x*2 })") == "14");
  CHECK(shown("#declare f = function { x } #macro M(p) #local g = function { p(x,y,z)+1 } "
              "#debug str(g(7,2,3),0,0) #end M(f) M(f)") == "88");
  CHECK(value("#declare f = function { x*y } #macro M() 2, 3 #end", "f(M(), 4)") == "6.000");
  CHECK(value("#declare f = function { x*y }", "f(#if (1) 2 #else 3 #end, 3, 4)") == "6.000");
  CHECK(vector_of("f(1,2)+<1,2,3>", 3, "#declare f = function(a,b) { a*10+b }", 0) == "13 14 15");
  CHECK(vector_of("<f(1),2,3>*f(2)", 3, "#declare f = function(a) { a }", 0) == "2 4 6");
}

TEST_CASE("functions: calls are what a fresh call would be, however often",
          "[interpreter][functions]") {
  CHECK(value("#declare f = function(a) { sum(i, 1, a, i*i) } #declare T = 0; "
              "#for (I, 1, 200) #declare T = T+f(I)-f(I-1); #end",
              "T") == "2686700.000");
}

TEST_CASE("functions: internal shapes and noises by number", "[interpreter][functions]") {
  CHECK(value("#declare f = function { internal(57) }", "f(2,3,3)") == "4.690");
  CHECK(value("#declare f = function { internal(57.9) }", "f(2,3,3)") == "4.690");
  CHECK(value("#declare f = function { internal(61) }", "f(2,3,3,1)") == "3.690");
  CHECK(value("#declare f = function(a) { internal(61) }", "f(2,3,3,1)") == "3.690");
  CHECK(value("#declare f = function { internal(76) }", "f(0.3,1.7,-2.2)") == "0.529");
  CHECK(value("global_settings { noise_generator 3 } #declare f = function { internal(76) }",
              "f(0.3,1.7,-2.2)") == "0.670");
  CHECK(error("#declare f = function { internal(79) }") == "there is no internal function 79");
  CHECK(error("#declare f = function { internal(57)+1 }") ==
        "expected `(N)` and nothing else after `internal`, found an expression");
  CHECK(error("#declare f = function { #if (1) 1+ #end internal(57) }") ==
        "`internal` must be the whole body of a function");
}

TEST_CASE("functions: transforms, splines, patterns and pigments", "[interpreter][functions]") {
  const auto vector = [](const std::string& before, const std::string& call, int n) {
    return shown(before + "\n#declare V = " + call + ";\n#debug vstr(" + std::to_string(n) +
                 ", V, \" \", 0, 2)");
  };
  const std::string move = "#declare f = function { transform { scale 2 translate x } }";
  CHECK(vector(move, "f(1,2,3)", 3) == "3.00 4.00 6.00");
  CHECK(value(move + "#declare g = function { f(x,y,z).y+f(x,y,z).z }", "g(1,2,3)") == "10.000");
  const std::string spline =
      "#declare f = function { spline { linear_spline 0, <1,2,3,4,5> 1, <3,4,5,6> } }";
  CHECK(vector(spline, "f(0.5)", 5) == "2.00 3.00 4.00 5.00 5.00");
  CHECK(value(spline + "#declare g = function { f(x).transmit+f(x).gray*10 }", "g(.5,0,0)") ==
        "33.170");
  CHECK(value("#declare f = function { pattern { gradient x } }", "f(3,0,0)") == "1.500");
  const std::string pigment = "#declare f = function { pigment { gradient x } }";
  CHECK(vector(pigment, "f(1,2,3)", 5) == "1.00 2.00 3.00 0.25 0.50");
  CHECK(value(pigment, "f(1,2,3).transmit") == "0.500");
  CHECK(value(pigment + "#declare g = function { f(x,y,z).hf }", "g(1,2,3)") == "1.004");
  CHECK(value(pigment + "#declare g = function { f(x,y,z).t*10+f(x,y,z).v }", "g(1,2,3)") ==
        "4.500");
  CHECK(value(pigment + "#macro M() f(x,y,z) #end #declare g = function { 1+M().green }",
              "g(1,2,3)") == "3.000");
}

TEST_CASE("functions: pigments hold the tapes of their patterns", "[interpreter][functions]") {
  const Run r =
      run("#declare A = 2; #declare P = pigment { function { A*x+y } scale 3 } #declare A = 5; "
          "sphere { 0, 1 pigment { P } } sphere { 0, 1 pigment { P gradient x } }");
  for (const auto& e : r.errors) UNSCOPED_INFO(e);
  REQUIRE(r.scene);
  const auto pigment = [&](std::size_t i) -> scene::Pigment {
    const scene::Object& o = r.scene->objects[r.scene->roots[i].object];
    return r.scene->textures[o.texture.texture].layers[0].pigment.get();
  };
  REQUIRE(pigment(0).pattern->function);
  functions::Workspace w;
  CHECK(functions::evaluate(*pigment(0).pattern->function, std::array{1.0, 2.0, 3.0}, w) == 4);
  CHECK_FALSE(pigment(1).pattern->function);
  CHECK(error("#declare P = pigment { function { internal(57) } }") ==
        "`internal` must be the whole body of a function");
}

TEST_CASE("functions: mistakes in bodies are named", "[interpreter][functions]") {
  const auto in = [](const std::string& body) {
    return error(
        "#declare V = <1,2,3>; #declare h = function { x } #declare S = spline { 0, 1 } "
        "#declare p = function { transform { scale 2 } } "
        "#declare f = function { " +
        body + " }");
  };
  CHECK(in("nothing_of_that_name") == "`nothing_of_that_name` is not declared");
  CHECK(in("nofunc(x)") == "`nofunc` is not declared");
  CHECK(in("f(x,y,z)") == "`f` is not declared");  // recursion
  CHECK(in("V") == "functions compute with floats only, `V` is a vector");
  CHECK(in("V.x") == "functions compute with floats only, `V` is a vector");
  CHECK(in("h") == "functions compute with floats only, `h` is a function");
  CHECK(in("<1,2,3>.x") == "functions compute with floats only, found a vector");
  CHECK(in("\"a\"") == "functions compute with floats only, found a string");
  CHECK(in("x.x") == "there are no components here: this is a float");
  CHECK(in("h(x,y,z).x") == "there are no components here: this is a float");
  CHECK(in("p(x,y,z)") == "this call has 3 components; a function needs one of them");
  CHECK(in("p(x,y,z).foo") == "`foo` is no component");
  CHECK(in("h(x,y)") == "`h` takes 3 arguments, here are 2");
  CHECK(in("S(x).x") == "expected a function to call, `S` is a spline");
  CHECK(in("t") == "`t` has no meaning in a function");
  CHECK(in("x+true") == "`true` has no meaning in a function");
  CHECK(in("sqr(x)") == "`sqr` has no meaning in a function");
  CHECK(in("rand(x)") == "`rand` cannot be used in a function");
  CHECK(in("!x") == "functions have no `!`");
  CHECK(in("x ? 1 : 2") == "functions have no `?:`");
  CHECK(in("--x") == "a function takes one sign at most here");
  CHECK(in("x;") == "the body of a function is one expression, without `;`");
  CHECK(in("abs(x, y)") == "`abs` takes 1 argument, here are 2");
  CHECK(in("max(x)") == "`max` takes 2 or more arguments, here is 1");
  CHECK(in("select(x, 1)") == "`select` takes 3 or 4 arguments, here are 2");
  CHECK(in("sum(1, 1, 3, x)") == "expected a name for the counter");
  CHECK(in("x/0") == "this divides by the constant 0");
  CHECK(in("x y") == "expected an operator or `}` in this function, found `y`");
  CHECK(in("") == "expected a number, parameter or call in this function, found `}`");
}

TEST_CASE("functions: mistakes around them are named", "[interpreter][functions]") {
  const std::string f = "#declare f = function { x } ";
  CHECK(shown(f + "\n#debug str(f(1, 2), 0, 0)") ==
        "D0202 at 2:12: this function takes 3 arguments, here are 2");
  CHECK(error(f + "#declare A = f(<1,2,3>, 2, 3);") ==
        "expected a float as argument, found a value of 3 components");
  CHECK(error(f + "#declare f = 3;") == "`f` is a function and cannot be redeclared");
  CHECK(error(f + "#macro M() #local f = 3; #end M()") ==
        "`f` is a function and cannot be redeclared");
  CHECK(error("#declare A = array[1] {function { x }} #declare A[0] = function { y }") ==
        "`A` is a function and cannot be redeclared");
  CHECK(shown(f + "#undef f #declare f = 3; #debug str(f,0,0)") == "3");
  CHECK(shown(f + "#macro M(f) #debug str(f,0,0) #end M(3)") == "3");
  CHECK(error("#declare f = function(t) { t }") == "expected the name of a parameter, found `t`");
  CHECK(error("#declare f = function() { 1 }") == "a function needs at least one parameter");
  CHECK(error("#declare f = function(a) { pattern { gradient x } }") ==
        "a function of a pattern has no parameters to choose");
  CHECK(error("#declare f = function { pattern { } }") ==
        "expected a pattern, such as `bozo` or `gradient x`");
}

TEST_CASE("functions: bodies mean in scenes what they mean to the builder",
          "[interpreter][functions][oracle]") {
  // The oracle's values of random bodies, with 17 decimals.
  std::ifstream file(DURER_FUNCTION_DATA "/bodies.tsv");
  std::string scene;
  std::vector<std::string> expected;
  std::vector<std::string> bodies;
  std::string last;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string body, x, y, z, v;
    std::getline(fields, body, '\t');
    std::getline(fields, x, '\t');
    std::getline(fields, y, '\t');
    std::getline(fields, z, '\t');
    std::getline(fields, v);
    // Inside a later argument the oracle calls pow() of its C library (functions/rewrite.cpp).
    if (body.find("pow(") != std::string::npos && body.find(',') < body.rfind("pow(")) continue;
    if (body != last) scene += "#ifdef (F) #undef F #end #declare F = function { " + body + " }\n";
    last = body;
    scene += "#debug concat(str(F(" + x + "," + y + "," + z + "), 0, 17), \"\\n\")\n";
    expected.push_back(v);
    bodies.push_back(body);
  }
  REQUIRE(expected.size() > 1000);
  std::istringstream got(shown(scene));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    std::string line;
    std::getline(got, line);
    CAPTURE(bodies[i], expected[i], line);
    const bool nan = expected[i].find("nan") != std::string::npos;
    CHECK((nan ? line.find("nan") != std::string::npos
               : line.compare(0, expected[i].size(), expected[i]) == 0));
  }
}

}  // namespace durer::interpreter::test

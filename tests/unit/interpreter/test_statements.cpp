// The shorter ways of loops and macros, against the long one: nothing may tell them apart.
#include "support.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::interpreter::test;

namespace {

/// Runs the scene both ways; what is seen.
std::string same(const std::string& text) {
  const std::string scene = "#version 3.7; global_settings { assumed_gamma 1 }\n" + text;
  const std::string quick = seen(scene, true);
  CHECK(quick == seen(scene, false));
  return quick;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("statements: objects of nested macros", "[interpreter][statements]") {
  const std::string s = same(R"(
#declare Dice = seed(11);
#declare Paint = array[4] { rgb <1, 0.6, 0.2>, rgb <0.3, 0.7, 1>, rgb <0.8, 0.9, 0.3>, rgb 0.8 }
#macro Knob(At, Size, Kind)
  #switch (mod(Kind, 3))
    #case (0) sphere { At, Size pigment { Paint[mod(Kind, 4)] } } #break
    #case (1) box { -Size, Size rotate 30*Kind*y translate At pigment { color Paint[mod(Kind, 4)] } } #break
    #else cylinder { At, At + 2*Size*y, 0.4*Size pigment { rgb Size } finish { phong 0.5 } }
  #end
#end
#macro Row(Base, Count)
  #local K = 0;
  #while (K < Count)
    Knob(Base + <K - Count/2, 0.3*rand(Dice), 0>, 0.1 + 0.3*rand(Dice), K)
    #local K = K + 1;
  #end
#end
#for (L, 1, 3) Row(L*y, 12) #end)");
  CHECK(holds(s, "cylinder"));
}

TEST_CASE("statements: objects in loops inside CSG", "[interpreter][statements]") {
  same(R"(
#macro Ball(P) sphere { P, 0.5 pigment { rgb P } } #end
union {
  #for (I, 1, 5)
    Ball(I*x)
    #if (mod(I, 2) = 0) box { -I, I translate I*z } #else union { Ball(y) Ball(z) } #end
    #local J = I; ;
  #end
  translate y
})");
}

TEST_CASE("statements: an object that is unusual only sometimes", "[interpreter][statements]") {
  same(R"(
#declare Thing = sphere { 0, 2 }
#macro Make(What, T) sphere { What, T translate T } #end
#for (I, 1, 4)
  #if (I < 3) Make(I*x, I) #else object { Thing translate I*x } #end
  sphere { <I, 0, 0>, 1 scale <1, I - 2, 1> }
  sphere { I, 1 hollow pigment { checker rgb 1 rgb I/4 } }
#end
#macro Twice(What) #for (I, 1, 2) sphere { What pigment { rgb I/2 } } #end #end
Twice(Thing))");
}

TEST_CASE("statements: looks that change in a loop", "[interpreter][statements]") {
  same(R"(
#for (I, 1, 6)
  sphere { I*x, 1 pigment { rgb 0.5 } finish { phong I/10 } }
  #if (I = 3) #default { finish { ambient 0.4 } } #end
  #if (I = 5) #default { texture { pigment { checker } } } #end
  sphere { I*y, 1 pigment { rgb <I, 0, 1>/6 } }
  sphere { I*z, 1 finish { diffuse I/10 } }
  sphere { I*z, 1 pigment { rgbt <1, 1, 1, I/10> } translate 1 }
  sphere { I*z, 1 translate 1 pigment { color rgb x filter 0.5 } }
#end)");
}

TEST_CASE("statements: constant finishes start from the default", "[interpreter][statements]") {
  const Run r = run(R"(
#for (I, 0, 5)
  #if (I = 3) #default { finish { ambient 0.4 } } #end
  sphere { I*x, 1 pigment { rgb 0.5 } finish { phong 0.3 } }
#end)");
  REQUIRE(r.scene);
  REQUIRE(r.scene->roots.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto id = r.scene->objects[r.scene->roots[i].object].texture.texture;
    const scene::Finish& finish = *r.scene->textures[id].layers.back().finish;
    CHECK(finish.phong == 0.3F);
    CHECK(finish.ambient.x == (i < 3 ? 0.1F : 0.4F));
  }
}

TEST_CASE("statements: versions that change in a loop", "[interpreter][statements]") {
  same(R"(
#for (I, 1, 4)
  #version 3.5 + 0.1*I;
  sphere { I*x, 1 - 0.1*I pigment { rgb I/4 } }
  #local A = version*2;
  box { -A, A }
#end)");
  same(R"(
#declare N = 0;
#while (N < 4)
  #version (N < 2 ? 1.0 : 3.7);
  sphere { <1 -1 2> 1 pigment { color red 1 } }
  #declare N = N + 1;
#end)");
}

TEST_CASE("statements: parameters by reference", "[interpreter][statements]") {
  const std::string s = same(R"(
#macro Count(N) #declare N = N + 1; #end
#macro Swap(A, B) #local T = A; #declare A = B; #declare B = T; #end
#declare Total = 0; #declare P = 1; #declare Q = <1, 2, 3>;
#declare List = array[3] { 1, 2, 3 }
#for (I, 0, 2)
  Count(Total)
  Count(List[I])
  Swap(P, Q)
  sphere { Q, 1 + Total }
#end
#debug concat(str(Total, 0, 0), vstr(3, P, ",", 0, 0), str(List[2], 0, 0)))");
  CHECK(s.find("31,2,34") == 0);
}

TEST_CASE("statements: names that change their kind", "[interpreter][statements]") {
  same(R"(
#declare V = 1;
#macro Sum(A, B) (A + B) #end
#for (I, 1, 6)
  #declare W = Sum(V, I)*2;
  #debug concat(vstr(3, W + <0, 0, 0>, ",", 0, 2), " ")
  #if (I = 2) #declare V = <1, 2, 3>; #end
  #if (I = 3) #undef W #declare V = rgb 0.3; #end
  #if (I = 4) #declare V = 4; #macro Sum(A, B) A*B #end #end
  #if (I = 5) #declare V = I*pi; #end
  sphere { I*V, 1 }
#end)");
}

TEST_CASE("statements: breaks and recursion", "[interpreter][statements]") {
  same(R"(
#macro Tree(P, Depth)
  sphere { P, Depth/4 pigment { rgb Depth/4 } }
  #if (Depth = 0) #break #end
  Tree(P + <Depth, 1, 0>, Depth - 1)
  Tree(P - <Depth, -1, 0>, Depth - 1)
  #declare Made = Made + 1;
#end
#declare Made = 0;
#for (I, 1, 9)
  Tree(I*z, 2)
  #while (Made > 0)
    #declare Made = Made - 2;
    #switch (Made) #case (1) #break #range (2, 5) sphere { 0, Made } #break #else box { 0, Made } #end
    #if (Made = 3) #break #end
  #end
  #if (I > 5) #break #end
#end
#debug str(I + Made, 0, 0))");
}

TEST_CASE("statements: random numbers are drawn in order", "[interpreter][statements]") {
  same(R"(
#declare R = seed(7);
#declare A = array[4] { 1, 2, 3, 4 }
#macro Two(A, B) sphere { <A, B, rand(R)>, 1 + rand(R) pigment { rgb rand(R) } rotate rand(R)*360 } #end
#for (I, 1, 6)
  Two(rand(R), rand(R)*I)
  sphere { rand(R)/(I - 3), rand(R) }
  #local X = rand(R) + A[4*rand(R)];
  box { -X, A[floor(3*rand(R))]*rand(R) }
#end
#debug str(rand(R), 0, 9))");
}

TEST_CASE("statements: errors inside macros", "[interpreter][statements]") {
  const std::string s = same(R"(
#macro Inner(P, R) sphere { P, R } #end
#macro Outer(N)
  #local K = 0;
  #while (K < N) Inner(K*x, 1) Inner(Nowhere + K, 1) #local K = K + 1; #end
  #declare Lost = 3;
#end
#for (I, 1, 3) Outer(I) #end
#declare B = Lost + 1;
sphere { 0, "a" })");
  CHECK(holds(s, "`Nowhere` is not declared"));
  CHECK(holds(s, "in macro `Outer`, called here"));
  same("#macro M(A) cylinder { A, A, 1 } #end\n#for (I, 1, 3) M(I) #end");
  same("#macro M(A, B) sphere { A, B } #end\n#for (I, 1, 3) M(I) #end");
  same("#for (I, 1, 3) sphere { <I, 1, 2, 3>, 1 } #end");
  same("#for (I, 1, 3) sphere { 0, I, } #end");
  same("#for (I, 1, 3) sphere { 0, I } #local A = I/0; box { -I/0, 1 } #end");
  same("#macro M(A) M(A + 1) #end\n#for (I, 1, 3) M(I) #end");
}

TEST_CASE("statements: text that is spliced", "[interpreter][statements]") {
  same(R"(
#macro Open() sphere { 0, 1 #end
#macro Word() pigment #end
#macro Tail(I) translate I*x } #end
#for (I, 1, 3)
  Open() Word() { rgb 1 } Tail(I)
  sphere { 0, 1 + I Tail(I)
  sphere { Word() }
#end)");
  same(R"(
#macro Shape(K) #if (K > 1) sphere #else box #end #end
#for (I, 1, 3) Shape(I) { -I, I } #end)");
}

TEST_CASE("statements: objects that look alike share a texture", "[interpreter][statements]") {
  const Run r = run(R"(
#for (I, 0, 9)
  sphere { I*x, 1 pigment { rgb mod(I, 2) } finish { phong 0.5 } }
  sphere { I*y, 1 pigment { rgb mod(I, 2) } }
#end)");
  REQUIRE(r.scene);
  CHECK(r.scene->objects.size() == 20);
  CHECK(r.scene->textures.size() == 5);  // with the default
  const auto texture = [&](std::size_t i) {
    return r.scene->objects[r.scene->roots[i].object].texture.texture;
  };
  CHECK(texture(0) == texture(4));
  CHECK(texture(0) != texture(1));
  CHECK(texture(0) != texture(2));
}

TEST_CASE("statements: equal finishes of one block are one", "[interpreter][statements]") {
  const Run r = run(R"(
#for (I, 0, 9) sphere { I*x, 1 pigment { rgb I } finish { phong 0.5 } } #end)");
  REQUIRE(r.scene);
  const auto finish = [&](std::size_t i) {
    const auto id = r.scene->objects[r.scene->roots[i].object].texture.texture;
    return r.scene->textures[id].layers.back().finish;
  };
  CHECK(finish(0)->phong == 0.5F);
  CHECK(finish(2).same(finish(9)));
}

TEST_CASE("statements: more colours than are remembered", "[interpreter][statements]") {
  const Run r = run(R"(
#for (I, 1, 70000) sphere { 0, 1 pigment { rgb I/70000 } } #end
#for (I, 69996, 70000) sphere { 0, 1 pigment { rgb I/70000 } } #end)");
  REQUIRE(r.scene);
  REQUIRE(r.scene->roots.size() == 70005);
  bool right = true;
  for (std::size_t i = 0; i < r.scene->roots.size(); ++i) {
    const auto id = r.scene->objects[r.scene->roots[i].object].texture.texture;
    const auto step = static_cast<double>(i < 70000 ? i + 1 : i - 4);
    const float grey = r.scene->textures[id].layers.back().pigment->colour.rgb.x;
    right = right && grey == static_cast<float>(step / 70000);
  }
  CHECK(right);
  CHECK(r.scene->textures.size() >= 70001);
  CHECK(r.scene->textures.size() <= 70006);
}

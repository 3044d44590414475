// Objects that are words and a list of points → operands as their types lay them out.
#include <fmt/format.h>

#include "support.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::interpreter::test;
using Args = std::vector<double>;

namespace {

Args args_of(const std::string& text) {
  const Run r = run(text);
  CAPTURE(text, r.errors);
  REQUIRE(r.scene);
  REQUIRE(r.scene->roots.size() == 1);
  const auto& args = r.scene->objects[r.scene->roots[0].object].args;
  return Args(args.begin(), args.end());
}

std::string patch(const std::string& settings, int points = 16) {
  std::string text = "bicubic_patch { " + settings;
  for (int i = 0; i < points; ++i) text += fmt::format("{}<{}, {}, 0>", i == 0 ? " " : ", ", i % 4, i / 4);
  return text + " }";
}

}  // namespace

TEST_CASE("lathe: linear unless a spline is named, commas may be missing", "[interpreter][lathe]") {
  CHECK(args_of("lathe { 2, <0.5, 1>, <1, 2> }") == Args{0, 0.5, 1, 1, 2});
  CHECK(args_of("lathe { linear_spline 2 <0.5, 1> <1, 2> }") == Args{0, 0.5, 1, 1, 2});
  CHECK(args_of("lathe { quadratic_spline 1 <1, 0> }")[0] == 1);
  CHECK(args_of("lathe { cubic_spline 1 <1, 0> }")[0] == 2);
  CHECK(args_of("lathe { bezier_spline 1 <1, 0> }")[0] == 3);
}

TEST_CASE("lists of points: a number is a whole point, a count loses its fraction",
          "[interpreter][lathe]") {
  CHECK(args_of("lathe { 2.9, 1, <2, 3> }") == Args{0, 1, 1, 2, 3});
  CHECK(args_of("#declare A = array[2] { <1, 2>, <3, 4> } "
                "lathe { 2, #for (I, 0, 1) A[I] #end }") == Args{0, 1, 2, 3, 4});
}

TEST_CASE("lists of points: what is missing is counted, an absurd number is refused",
          "[interpreter][lathe]") {
  const Run r = run("lathe { 3, <0.5, 1>, <1, 2> }");
  REQUIRE(r.errors.size() == 1);
  CHECK(r.errors[0] == "D0202 at 1:29: expected 3 points, here are 2");
  CHECK(r.labels == std::vector<std::string>{"1: in this block"});
  CHECK(error_of("lathe { -1, <0, 0> }") == "D0302 at 1:1: there is no list of -1 points");
  CHECK(error_of("prism { 0, 1, 1e12, <0, 0> }") ==
        "D0302 at 1:1: there is no list of 1000000000000 points");
}

TEST_CASE("prism: spline and sweep in any order, the last one counts", "[interpreter][prism]") {
  CHECK(args_of("prism { -1, 2, 3, <0, 1>, <2, 3>, <4, 5> }") ==
        Args{0, 0, -1, 2, 0, 0, 1, 2, 3, 4, 5});
  CHECK(args_of("prism { conic_sweep cubic_spline 0 1 1 <1, 0> }") == Args{2, 1, 0, 1, 0, 1, 0});
  CHECK(args_of("prism { cubic_spline conic_sweep linear_sweep bezier_spline 0, 1, 1, <1, 0> }") ==
        Args{3, 0, 0, 1, 0, 1, 0});
  CHECK(args_of("prism { 0, 1, 1, <1, 0> open }") == Args{0, 0, 0, 1, 1, 1, 0});
}

TEST_CASE("sor: a list, and perhaps no caps", "[interpreter][sor]") {
  CHECK(args_of("sor { 2, <1, 0>, <2, 1> }") == Args{0, 1, 0, 2, 1});
  CHECK(args_of("sor { 1, <1, 0> open rotate x }") == Args{1, 1, 0});
}

TEST_CASE("sphere_sweep: a spline must be named, each centre has its radius",
          "[interpreter][sphere_sweep]") {
  CHECK(args_of("sphere_sweep { linear_spline 2, <1, 2, 3>, 4, y, 5 }") ==
        Args{0, 1e-6, 1, 2, 3, 4, 0, 1, 0, 5});
  CHECK(args_of("sphere_sweep { cubic_spline, 1, 0, 1 tolerance 0.1 }") ==
        Args{1, 0.1, 0, 0, 0, 1});
  CHECK(args_of("sphere_sweep { b_spline 1 x 0.5 }") == Args{2, 1e-6, 1, 0, 0, 0.5});
  CHECK(error_of("sphere_sweep { 2, x, 1, y, 1 }").find("`linear_spline`, `cubic_spline` or") !=
        std::string::npos);
}

TEST_CASE("polygon: points in space", "[interpreter][polygon]") {
  CHECK(args_of("polygon { 3, x, y, <1, 2, 3> }") == Args{3, 1, 0, 0, 0, 1, 0, 1, 2, 3});
  CHECK(error_of("polygon { 3, x, y }").find("expected 3 points, here are 2") !=
        std::string::npos);
}

TEST_CASE("bicubic_patch: settings as words, without them, and what they default to",
          "[interpreter][patch]") {
  const Args plain = args_of(patch("type 1"));
  REQUIRE(plain.size() == 11 + 48);
  CHECK(Args(plain.begin(), plain.begin() + 11) == Args{0, 0, 0, 0, 0, 1, 0, 1, 1, 0, 1});
  CHECK(plain[11 + 3 * 15] == 3);
  const Args words = args_of(patch("v_steps 4.7 flatness 0.1 u_steps 3 type 0 accuracy 0.01,"));
  CHECK(Args(words.begin(), words.begin() + 3) == Args{3, 4, 0.1});
  const Args bare = args_of(patch("1, 3, 4"));
  CHECK(Args(bare.begin(), bare.begin() + 3) == Args{3, 4, 0});
  const Args uv = args_of(patch("type 1 uv_vectors <0, 0> <2, 0> <2, 2> <0, 2>,"));
  CHECK(Args(uv.begin() + 3, uv.begin() + 11) == Args{0, 0, 2, 0, 2, 2, 0, 2});
}

TEST_CASE("bicubic_patch: a type must be told, one that is too great is type 1",
          "[interpreter][patch]") {
  CHECK(error_of(patch("u_steps 3")).find("a patch needs `type 0` or `type 1`") !=
        std::string::npos);
  CHECK(run(patch("type 7")).warnings.size() == 1);
  CHECK(error_of(patch("type 1", 15)).find("expected 16 points, here are 15") !=
        std::string::npos);
}

TEST_CASE("cutaway_textures: belongs to intersections and differences", "[interpreter][objects]") {
  const Run r = run("difference { sphere { 0, 1 } box { 0, 1 } cutaway_textures }");
  REQUIRE(r.scene);
  CHECK(r.scene->objects[r.scene->roots[0].object].cutaway_textures);
  CHECK(error_of("union { sphere { 0, 1 } box { 0, 1 } cutaway_textures }").substr(0, 5) ==
        "D0214");
}

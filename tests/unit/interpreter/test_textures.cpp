// Patterns with their warps, normals and patterned textures, as data.
#include "tests/support/catch.h"
#include "tests/unit/interpreter/support.h"

using namespace durer;
using namespace durer::interpreter::test;

namespace {

scene::Texture texture_of(const std::string& items) {
  const Run r = run("sphere { 0, 1 texture { " + items + " } }");
  CAPTURE(r.errors);
  REQUIRE(r.scene);
  return r.scene->textures[r.scene->objects.back().texture.texture];
}
scene::Pattern pattern_of(const std::string& body) {
  return *texture_of("pigment { " + body + " }").layers.back().pigment->pattern;
}
scene::Normal normal_of(const std::string& body) {
  return *texture_of("normal { " + body + " }").layers.back().normal;
}
bool says(const std::string& text, const std::string& what) {
  const std::string error = error_of(text);
  CAPTURE(error);
  return error.find(what) != std::string::npos;
}

constexpr std::uint32_t checker = 0;
constexpr std::uint32_t gradient = 1;
constexpr std::uint32_t average = 3;
constexpr std::uint32_t turbulence = 0;
constexpr std::uint32_t repeat = 1;

}  // namespace

TEST_CASE("patterns: turbulence outside of warps is nearest to the pattern",
          "[interpreter][textures]") {
  for (const char* body : {"gradient x turbulence 0.3 octaves 3 warp { repeat y } scale 2",
                           "gradient x warp { repeat y } scale 2 octaves 3 turbulence 0.3"}) {
    CAPTURE(body);
    const scene::Pattern p = pattern_of(body);
    REQUIRE(p.warps.size() == 2);
    CHECK(p.warps[0].classic);
    CHECK(p.warps[0].type == turbulence);
    CHECK(p.warps[0].args == std::vector<double>{0.3, 0.3, 0.3, 3, 0.5, 2});
    CHECK(p.warps[1].type == repeat);
    CHECK(p.transform->forward.x.x == 2);
  }
}

TEST_CASE("patterns: transformations before a warp are steps of their own",
          "[interpreter][textures]") {
  const scene::Pattern p =
      pattern_of("gradient x scale 2 translate x warp { repeat x flip y } rotate 90*z");
  REQUIRE(p.warps.size() == 2);
  CHECK(p.warps[0].type == scene::none);
  CHECK(p.warps[0].transform->point({1, 0, 0}).x == Approx(3));
  CHECK(p.warps[1].args == std::vector<double>{1, 0, 0, 0, 1, 0});
  CHECK(p.transform->point({1, 0, 0}).y == Approx(1));
}

TEST_CASE("patterns: modifiers of the wrong kind are named", "[interpreter][textures]") {
  CHECK(says("#declare P = pigment { gradient x warp { twist 1 } }", "D0214"));
  CHECK(says("#declare P = pigment { gradient x noise_generator 4 }", "D0302"));
  CHECK(says("#declare P = pigment { average }", "needs a `pigment_map`"));
  CHECK(says("#declare P = pigment { checker color_map { [0 rgb 0] } }",
             "takes a list, not a map"));
}

TEST_CASE("normals: amount, modifiers and maps", "[interpreter][textures]") {
  const scene::Normal n = normal_of("gradient x, 0.7 accuracy 0.01 scale 3");
  CHECK(n.pattern->type == gradient);
  CHECK(n.amount == 0.7F);
  CHECK(n.accuracy == 0.01F);
  CHECK(n.pattern->transform->forward.x.x == 3);

  const scene::Normal list = normal_of("checker normal { gradient x } normal { gradient y 0.2 }");
  CHECK(list.pattern->type == checker);
  REQUIRE(list.children.size() == 2);
  CHECK(list.children[1].amount == 0.2F);

  const scene::Normal map =
      normal_of("average normal_map { [2 gradient x] [gradient y] } no_bump_scale");
  CHECK(map.pattern->type == average);
  REQUIRE(map.entries.size() == 2);
  CHECK(map.entries[0].key == 2);
  CHECK(map.entries[1].key == 1);
  CHECK(map.children[1].no_bump_scale);

  const scene::Normal slopes = normal_of("gradient x slope_map { [0 <0, 1>] [1 <0.5, -1>] }");
  REQUIRE(slopes.slopes.size() == 2);
  CHECK(slopes.slopes[1].height == 0.5F);
  CHECK(slopes.slopes[1].slope == -1);
}

TEST_CASE("normals: what cannot be is an error", "[interpreter][textures]") {
  CHECK(says("sphere { 0, 1 normal { 0.5 } }", "D0201"));
  CHECK(says("sphere { 0, 1 normal { scale 2 } }", "expected a pattern"));
  CHECK(says("sphere { 0, 1 normal { checker slope_map { [0 <0, 1>] } } }",
             "takes a list, not a map"));
  CHECK(says("sphere { 0, 1 normal { average } }", "needs a `normal_map`"));
}

TEST_CASE("textures: a pattern chooses among textures", "[interpreter][textures]") {
  const Run r = run(
      "#declare A = texture { pigment { rgb 1 } }\n"
      "sphere { 0, 1 texture { gradient x texture_map { [0.2 A] [0.7 A scale 2] "
      "[0.9 pigment { rgb x }] } scale 2 } scale 3 }");
  REQUIRE(r.scene);
  const scene::TextureUse use = r.scene->objects.back().texture;
  const scene::Texture& t = r.scene->textures[use.texture];
  REQUIRE(t.patterned());
  CHECK(t.pattern->type == gradient);
  CHECK(t.pattern->transform->forward.x.x == 2);
  REQUIRE(t.entries.size() == 3);
  CHECK(t.entries[1].key == 0.7F);
  CHECK(r.scene->textures[t.entries[2].texture].layers.back().pigment->colour.rgb.x == 1);
  CHECK(use.transform->forward.x.x == 3);
}

TEST_CASE("textures: lists and tiles", "[interpreter][textures]") {
  CHECK(texture_of("checker texture { pigment { rgb 1 } }").entries.size() == 2);
  // `tiles` begins with the cells of value 1.
  const Run r = run(
      "sphere { 0, 1 texture { tiles { texture { pigment { rgb x } } tile2 texture { pigment { "
      "rgb y } } } } }");
  REQUIRE(r.scene);
  const scene::Texture& t = r.scene->textures[r.scene->objects.back().texture.texture];
  REQUIRE(t.entries.size() == 2);
  CHECK(r.scene->textures[t.entries[1].texture].layers.back().pigment->colour.rgb.x == 1);
}

TEST_CASE("textures: patterned ones have no layers", "[interpreter][textures]") {
  const std::string checks = "texture { checker texture { pigment { rgb 1 } } }";
  CHECK(says("sphere { 0, 1 " + checks + " texture { pigment { rgbt 1 } } }", "cannot be a layer"));
  CHECK(says("sphere { 0, 1 " + checks + " finish { phong 1 } }", "has no layers"));
  CHECK(says("sphere { 0, 1 texture { gradient x } }", "needs a `texture_map`"));
}

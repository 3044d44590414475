// Scenes as text and JSON.
#include "scene/dump.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "scene/fields.h"
#include "tests/support/catch.h"

namespace durer::scene {
namespace {

using Json = nlohmann::json;

constexpr std::array ball_params = {
    Param{.name = "centre", .kind = ArgKind::vector, .doc = "", .fallback = {}},
    Param{.name = "radius", .kind = ArgKind::number, .doc = "", .fallback = {}},
};
constexpr TypeInfo ball = [] {
  TypeInfo t;
  t.name = "ball";
  t.params = ball_params;
  return t;
}();
constexpr PatternInfo stripes = [] {
  PatternInfo p;
  p.name = "stripes";
  return p;
}();
constexpr std::array<const TypeInfo*, 1> primitives = {&ball};
constexpr std::array<const PatternInfo*, 1> patterns = {&stripes};

Registry registry() { return {primitives, patterns}; }

Object some_ball() {
  Object o;
  o.type = 0;
  o.args = {1, 2, 3, 0.5, 7, 8};
  return o;
}

std::string text_of(const Scene& scene, const SourceMap* sources = nullptr) {
  return dump_text(scene, registry(), sources, DumpStyle::text);
}

Json json_of(const Scene& scene, const SourceMap* sources = nullptr) {
  return Json::parse(dump_text(scene, registry(), sources, DumpStyle::json));
}

template <typename T>
void check_names(const Json& json) {
  std::apply(
      [&](const auto&... f) {
        const auto one = [&](const auto& field) {
          CAPTURE(field.name);
          const bool flat = field.name == "extras";  // as if they were the object's own
          CHECK(json.contains(std::string(field.name)) == (field.role != Role::place && !flat));
        };
        (one(f), ...);
      },
      Fields<T>::all);
}

}  // namespace

TEST_CASE("dump: JSON has every field of every struct", "[scene][dump]") {
  Scene scene;
  Object object = some_ball();
  object.extras.edit().mesh = std::make_shared<Mesh>();
  object.transform = Transform::scale(dvec3(2));
  scene.objects.push_back(object);
  scene.roots.emplace_back();
  scene.lights.emplace_back();
  scene.interiors.emplace_back();
  scene.atmosphere.emplace_back();
  Texture texture;
  texture.layers.emplace_back();
  texture.layers[0].pigment.edit().entries.emplace_back();
  scene.textures.push_back(texture);
  scene.sky_sphere.emplace();
  const Json json = json_of(scene);
  check_names<Object>(json["objects"][0]);
  check_names<ObjectExtras>(json["objects"][0]);
  check_names<TextureUse>(json["objects"][0]["texture"]);
  check_names<Affine>(json["objects"][0]["transform"]);
  check_names<Mesh>(json["meshes"][0]);
  check_names<Root>(json["roots"][0]);
  check_names<Light>(json["lights"][0]);
  check_names<Interior>(json["interiors"][0]);
  check_names<Media>(json["atmosphere"][0]);
  check_names<Texture>(json["textures"][0]);
  check_names<Layer>(json["textures"][0]["layers"][0]);
  check_names<Finish>(json["textures"][0]["layers"][0]["finish"]);
  check_names<Pigment>(json["textures"][0]["layers"][0]["pigment"]);
  check_names<PigmentEntry>(json["textures"][0]["layers"][0]["pigment"]["entries"][0]);
  check_names<SkySphere>(json["sky_sphere"]);
  check_names<Camera>(json["camera"]);
  check_names<Settings>(json["settings"]);
  check_names<GammaCurve>(json["settings"]["assumed_gamma"]);
  check_names<Colour>(json["background"]);
}

TEST_CASE("dump: operands have the names of the registry", "[scene][dump]") {
  Scene scene;
  scene.objects.push_back(some_ball());
  Pigment pigment;
  pigment.pattern.edit().type = 0;
  scene.sky_sphere = SkySphere{.pigments = {pigment}, .transform = {}};
  const Json json = json_of(scene);
  const Json& object = json["objects"][0];
  CHECK(object["type"] == "ball");
  CHECK(object["args"]["centre"] == Json({1, 2, 3}));
  CHECK(object["args"]["radius"] == 0.5);
  CHECK(object["args"]["more"] == Json({7, 8}));
  CHECK(json["sky_sphere"]["pigments"][0]["pattern"]["type"] == "stripes");
}

TEST_CASE("dump: text leaves out what has its default", "[scene][dump]") {
  Scene scene;
  scene.objects.push_back(some_ball());
  scene.settings.max_trace_level = 9;
  CHECK(text_of(scene) ==
        "settings\n"
        "  max_trace_level 9\n"
        "camera\n"
        "background\n"
        "  transmit 1\n"
        "sky_sphere -\n"
        "fogs\n"
        "rainbows\n"
        "lights\n"
        "roots\n"
        "objects\n"
        "  0\n"
        "    type ball\n"
        "    args\n"
        "      centre <1, 2, 3>\n"
        "      radius 0.5\n"
        "      more <7, 8>\n"
        "textures\n"
        "interiors\n"
        "atmosphere\n"
        "meshes\n");
}

TEST_CASE("dump: places have file, line, column and the calls that led there", "[scene][dump]") {
  SourceMap sources;
  const FileId file = sources.add("a.pov", "one\ntwo\n  three\n");
  const Loc base = sources.base(file);
  Scene scene;
  scene.origins.push_back({{base + 4, 3}, 0});   // two
  scene.origins.push_back({{base + 10, 5}, 1});  // three, from two
  Object object = some_ball();
  object.origin = 2;
  scene.objects.push_back(object);
  CHECK(json_of(scene, &sources)["objects"][0]["origin"] == Json({"a.pov:3:3", "a.pov:2:1"}));
  CHECK_FALSE(json_of(scene)["objects"][0].contains("origin"));
}

TEST_CASE("dump: numbers survive, and strings of any bytes are JSON", "[scene][dump]") {
  Scene scene;
  scene.camera.location = {0.1, 1e-300, -12345678.9};
  scene.camera.up.x = std::numeric_limits<double>::infinity();
  scene.camera.up.y = std::numeric_limits<double>::quiet_NaN();
  Object object;
  object.extras.edit().unsupported = "a \"b\" \\ \n \x01 \xC3\xA9 \xFF \xC3";
  object.hollow = false;
  scene.objects.push_back(object);
  const Json json = json_of(scene);  // which has no infinity
  CHECK(json["camera"]["location"][0].get<double>() == 0.1);
  CHECK(json["camera"]["location"][1].get<double>() == 1e-300);
  CHECK(json["camera"]["location"][2].get<double>() == -12345678.9);
  CHECK(json["camera"]["up"] == Json({"inf", "nan", 0}));
  CHECK(json["objects"][0]["hollow"] == false);
  CHECK(json["objects"][0]["unsupported"].get<std::string>() ==
        "a \"b\" \\ \n \x01 \xC3\xA9 \xEF\xBF\xBD \xEF\xBF\xBD");
}

TEST_CASE("dump: objects share meshes", "[scene][dump]") {
  Scene scene;
  auto mesh = std::make_shared<Mesh>();
  mesh->vertices = {vec3(0), vec3(1, 0, 0), vec3(0, 1, 0)};
  mesh->faces = {{0, 1, 2}};
  mesh->face_textures = {{0, none, none}};
  for (int i = 0; i < 2; ++i) {
    scene.objects.push_back(some_ball());
    scene.objects.back().extras.edit().mesh = mesh;
  }
  const Json json = json_of(scene);
  CHECK(json["objects"][1]["mesh"] == 0);
  REQUIRE(json["meshes"].size() == 1);
  CHECK(json["meshes"][0]["vertices"][1] == Json({1, 0, 0}));
  CHECK(json["meshes"][0]["faces"][0] == Json({0, 1, 2}));
  CHECK(json["meshes"][0]["face_textures"][0] == Json({0, nullptr, nullptr}));
}

TEST_CASE("dump: large scenes come in pieces", "[scene][dump]") {
  Scene scene;
  for (int i = 0; i < 1000; ++i) scene.objects.push_back(some_ball());
  std::string whole;
  int pieces = 0;
  dump(scene, registry(), nullptr, DumpStyle::json, [&](std::string_view piece) {
    whole += piece;
    ++pieces;
  });
  CHECK(pieces > 3);
  CHECK(whole == dump_text(scene, registry(), nullptr, DumpStyle::json));
}

}  // namespace durer::scene

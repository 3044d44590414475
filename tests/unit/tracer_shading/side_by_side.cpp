// Neighbouring rays side by side, and plain surfaces the short way: the picture must not tell.
#include <cstring>
#include <string>

#include "tests/unit/tracer_shading/shading_test.h"
#include "tracer/film/eye.h"

using namespace durer;
using namespace durer::test;
using tracer::render;
using tracer::RenderOptions;

namespace {

struct Gallery : SceneBuilder {
  Gallery() : SceneBuilder(tracer::registry()) {
    look({0, 3, -8}, {0, 0.5, 0}, 40);
    scene.background = rgbft(0.1F, 0.2F, 0.4F);
    light({10, 20, -30});
    light({-9, 6, -8}, {0.5F, 0.3F, 0.2F});
  }

  scene::Pigment pigment(std::string_view pattern_name, bool stirred, float clear = 0) {
    scene::Pigment p;
    scene::Pattern& pattern = p.pattern.edit();
    pattern.type = pattern_of(pattern_name);
    pattern.args = default_args(*tracer::registry().patterns[pattern.type]);
    pattern.transform = Transform::scale(dvec3(0.4)).then(Transform::rotate_deg(dvec3(20, 30, 10)));
    pattern.frequency = 1.7F;
    pattern.wave = tracer::registry().patterns[pattern.type]->wave;
    if (stirred) pattern.warps.push_back(turbulence());
    p.entries = {{0, rgbft(0.2F, 0.3F, 0.5F), scene::none},
                 {0.4F, rgbft(0.9F, 0.8F, 0.6F, 0, clear), scene::none},
                 {1, rgbft(0.5F, 0.1F, 0.1F, clear / 2, clear / 2), scene::none}};
    return p;
  }
  scene::Normal bumps(std::string_view pattern_name) {
    scene::Normal n;
    n.pattern.edit().type = pattern_of(pattern_name);
    n.pattern.edit().args =
        default_args(*tracer::registry().patterns[n.pattern->type]);
    n.pattern.edit().transform = Transform::scale(dvec3(0.2));
    return n;
  }
  void place(scene::TextureId t) {
    add("plane", {0, 1, 0, 0}, t);
    for (const double x : {-1.4, 0.0, 1.4}) add("sphere", {x, 0.6, 0, 0.6}, t);
  }
  [[nodiscard]] scene::Warp turbulence() const {
    scene::Warp w;
    for (std::size_t i = 0; i < tracer::registry().warps.size(); ++i) {
      if (tracer::registry().warps[i]->name == "turbulence") w.type = static_cast<std::uint32_t>(i);
    }
    w.args = {0.4, 0.3, 0.5, 5, 0.6, 2.1};
    w.classic = true;
    return w;
  }

 private:
  [[nodiscard]] std::uint32_t pattern_of(std::string_view name) const { return pattern(name); }
};

RenderOptions small_picture() {
  RenderOptions options;
  options.width = 70;
  options.height = 40;
  options.threads = 1;
  options.antialias = false;
  return options;
}
std::vector<float> pixels(const scene::Scene& scene) {
  const auto c = compiled(scene);
  const auto image = render(*c, small_picture()).image;
  return {image.pixels.begin(), image.pixels.end()};
}
// The same, ray by ray.
std::vector<float> one_by_one(const scene::Scene& scene) {
  const auto c = compiled(scene);
  const RenderOptions options = small_picture();
  const tracer::Viewpoint view(*c, options);
  tracer::Eye eye(view);
  std::vector<float> out;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const tracer::Pixel p = eye.see(x, y, 0);
      out.insert(out.end(), {p.x, p.y, p.z, 1 - p.w});
    }
  }
  return out;
}
bool same(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

scene::Finish glossy() {
  scene::Finish f;
  f.specular = 0.4F;
  f.crand = 0.05F;
  return f;
}

}  // namespace

TEST_CASE("side by side: patterns look as they do for one ray", "[tracer][side_by_side]") {
  const std::string name = GENERATE("marble", "granite", "wood", "agate", "bozo", "wrinkles",
                                    "leopard", "crackle", "slope", "aoi", "checker");
  const bool stirred = GENERATE(false, true);
  CAPTURE(name, stirred);
  Gallery s;
  s.place(s.texture(s.pigment(name, stirred), glossy()));
  CHECK(same(pixels(s.scene), one_by_one(s.scene)));
}

TEST_CASE("side by side: bumps are as they are for one ray", "[tracer][side_by_side]") {
  const std::string name = GENERATE("bumps", "wrinkles", "dents", "ripples", "granite", "slope");
  const bool keep = GENERATE(false, true);
  CAPTURE(name, keep);
  Gallery s;
  scene::Normal n = s.bumps(name);
  n.no_bump_scale = keep;
  s.place(s.layers({{s.pigment("bozo", false), glossy(), {}, n}}));
  CHECK(same(pixels(s.scene), one_by_one(s.scene)));
}

TEST_CASE("side by side: layers are looked up as far as they show", "[tracer][side_by_side]") {
  Gallery s;
  scene::Finish mirror = glossy();
  mirror.reflection_min = mirror.reflection_max = vec3(0.2F);
  mirror.conserve_energy = true;
  const float clear = GENERATE(0.0F, 0.8F, 1.0F);
  CAPTURE(clear);
  s.place(s.layers({{s.pigment("wood", true), glossy(), {}},
                    {s.pigment("agate", false, clear), mirror, {}, s.bumps("bumps")},
                    {s.pigment("bozo", true, clear), glossy(), {}},
                    {s.pigment("marble", true, clear), glossy(), {}},
                    {s.pigment("leopard", false, clear), glossy(), {}}}));
  CHECK(same(pixels(s.scene), one_by_one(s.scene)));
}

TEST_CASE("side by side: what is before and behind a surface stays there", "[tracer][side_by_side]") {
  Gallery s;
  s.place(s.texture(s.pigment("wood", true), glossy()));
  scene::Finish mirror = glossy();
  mirror.reflection_min = mirror.reflection_max = vec3(0.3F);
  scene::Interior crown;
  crown.ior = 1.4;
  crown.fade_power = 1;
  crown.fade_distance = 1;
  const auto inside = s.interior(crown);
  const auto glass = s.texture(s.pigment("bozo", false, 0.9F), mirror);
  for (const double x : {-2.0, -0.5, 1.0}) s.add("sphere", {x, 1.2, -2, 0.7}, glass, inside);
  SECTION("in clear air") {}
  SECTION("in fog") {
    scene::Fog fog;
    fog.distance = 12;
    fog.colour = rgbft(0.6F, 0.7F, 0.8F);
    s.scene.fogs.push_back(fog);
  }
  CHECK(same(pixels(s.scene), one_by_one(s.scene)));
}

// A layer that shows nothing, but is there.
TEST_CASE("plain surfaces: the short way gives what the long one gives", "[tracer][side_by_side]") {
  const float diffuse_back = GENERATE(0.0F, 0.3F);
  Gallery s;
  scene::Light& lamp = s.scene.lights[1];
  SECTION("points") {}
  SECTION("a fading spotlight") {
    lamp.kind = scene::Light::Kind::spotlight;
    lamp.radius_deg = 6;
    lamp.falloff_deg = 15;
    lamp.point_at = {0, 0, 0};
    lamp.fade_distance = 8;
    lamp.fade_power = 2;
  }
  SECTION("without shadows") { lamp.shadowless = true; }
  SECTION("areas") {
    lamp.has_area = true;
    lamp.area.u = {2, 0, 0};
    lamp.area.v = {0, 2, 0};
    lamp.area.n1 = lamp.area.n2 = 3;
    SECTION("seen as points") {}
    SECTION("that shine as a whole") { lamp.area.illumination = true; }
  }
  SECTION("something clear that dims shadows") {
    s.add("sphere", {0, 3, -3, 0.8}, s.texture(plain(rgbft(1, 0.5F, 0.5F, 0.8F)), dull()));
  }
  const scene::Pigment pigment = s.pigment("granite", false);
  scene::Finish finish = glossy();
  finish.diffuse_back = diffuse_back;
  finish.crand = 0;
  finish.irid = 0.2F;
  finish.irid_thickness = 0.3F;
  finish.metallic = 1;
  const scene::Layer shown{pigment, finish, {}, s.bumps("bumps")};
  Gallery longer = s;
  s.place(s.layers({shown}));
  longer.place(longer.layers({shown, {plain(rgbft(1, 1, 1, 0, 1)), dull(), {}}}));
  CHECK(same(pixels(s.scene), pixels(longer.scene)));
  CHECK(same(pixels(s.scene), one_by_one(s.scene)));
}

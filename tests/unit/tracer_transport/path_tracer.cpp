// Random paths against what is known without them: furnaces, the ordinary tracer's direct light,
// and themselves with another way of looking.
#include "tests/unit/tracer_transport/path_test.h"

using namespace durer;
using namespace durer::test;
using tracer::PathRules;

namespace {

// A ball in a white sky.
struct Furnace : SceneBuilder {
  explicit Furnace(const scene::Finish& finish, const Colour& colour = rgbft(1, 1, 1),
                   double ior = -1)
      : SceneBuilder(tracer::registry()) {
    look({0, 0, -4}, {0, 0, 0}, 15);
    scene.background = rgbft(1, 1, 1);
    scene::Interior inside;
    inside.ior = ior;
    add("sphere", {0, 0, 0, 1}, texture(plain(colour), finish), interior(inside));
  }
};

scene::Finish glass() {
  scene::Finish f = dull();
  f.reflection_max = vec3(1.0F);
  f.fresnel = f.conserve_energy = true;
  return f;
}

// A room with a bright panel below its ceiling, a ball, and walls of two colours.
struct Room : SceneBuilder {
  explicit Room(bool panel = true) : SceneBuilder(tracer::registry()) {
    look({0, 1, -0.95}, {0, 0.9, 1}, 80);
    const auto white = texture(plain(rgbft(0.7F, 0.7F, 0.7F)), matte(1));
    add("plane", {0, 1, 0, 0}, white);
    add("plane", {0, -1, 0, -2}, white);
    add("plane", {0, 0, 1, -1}, white);
    add("plane", {0, 0, -1, -1}, white);
    add("plane", {1, 0, 0, -1}, texture(plain(rgbft(0.7F, 0.1F, 0.1F)), matte(1)));
    add("plane", {-1, 0, 0, -1}, texture(plain(rgbft(0.1F, 0.6F, 0.2F)), matte(1)));
    if (panel) {
      scene::Finish bright = dull();
      bright.emission = vec3(5.0F);
      add("box", {-0.4, 1.9, -0.2, 0.4, 1.95, 0.6}, texture(plain(rgbft(1, 1, 1)), bright));
    }
  }
};

}  // namespace

TEST_CASE("paths: a white ball in a white sky cannot be seen", "[tracer][paths]") {
  scene::Finish mirror = dull();
  mirror.reflection_min = mirror.reflection_max = vec3(1.0F);
  scene::Finish film = matte(0.6F);
  film.reflection_min = film.reflection_max = vec3(0.4F);
  CHECK(along_paths(Furnace(matte(1)).scene, 16) == vec3(1.0F));
  check_near(along_paths(Furnace(mirror).scene, 16), vec3(1.0F), 1e-6);
  check_near(along_paths(Furnace(film).scene, 64), vec3(1.0F), 1e-5);
  check_near(along_paths(Furnace(glass(), rgbft(1, 1, 1, 0, 1), 1.5).scene, 16), vec3(1.0F), 1e-5);
  check_near(along_paths(Furnace(dull(), rgbft(1, 1, 1, 0, 1)).scene, 16), vec3(1.0F), 1e-6);
}

TEST_CASE("paths: half of a grey ball's light is lost at every bounce", "[tracer][paths]") {
  const vec3 grey(0.5F, 0.25F, 0.75F);
  check_near(along_paths(Furnace(matte(1), {grey}).scene, 256), grey, 1e-3);
  scene::Finish both = matte(0.5F);
  both.diffuse_back = 0.5F;
  check_near(along_paths(Furnace(both, rgbft(1, 1, 1)).scene, 1024), vec3(1.0F), 0.02);
}

TEST_CASE("paths: lobes of highlights send back what their albedo says", "[tracer][paths]") {
  // Seen straight on, a lobe around the mirrored ray loses nothing below the horizon.
  const auto seen = [](const scene::Finish& f) {
    SceneBuilder s(tracer::registry());
    s.scene.background = rgbft(1, 1, 1);
    s.look_straight({0, 0, -5}, {0, 0, 1});
    s.add("plane", {0, 0, 1, 0}, s.texture(plain(rgbft(1, 1, 1)), f));
    return along_paths(s.scene, 1024);
  };
  scene::Finish phong = dull();
  phong.phong_size = 30;
  phong.phong = 0.3F * (30 + 1) / 2;  // as `phong albedo 0.3` has it
  check_near(seen(phong), vec3(0.3F), 0.002);
  scene::Finish specular = dull();
  specular.roughness = 0.01F;
  specular.specular = 0.3F * 102 / (4 * (2 - std::exp2(-50.0F)));
  check_near(seen(specular), vec3(0.3F), 0.005);
  scene::Finish velvet = dull();
  velvet.brilliance = 3;
  velvet.diffuse = 0.4F * (3 + 1) / 2;
  check_near(seen(velvet), vec3(0.4F), 0.002);
}

TEST_CASE("paths: inside a glowing ball light adds up to e / (1 - a)", "[tracer][paths]") {
  SceneBuilder s(tracer::registry());
  s.look({0, 0, 0}, {0, 0, 1}, 40);
  scene::Finish f = matte(0.6F);
  f.emission = vec3(0.1F);
  s.add("sphere", {0, 0, 0, 1}, s.texture(plain(rgbft(1, 1, 1)), f));
  const bool next_event = GENERATE(true, false);
  check_near(along_paths(s.scene, 512, {.next_event = next_event}), vec3(0.25F), 0.002);
  // After so many bounces: the oracle's values with radiosity (participating-and-global §2.3).
  check_near(along_paths(s.scene, 512, {2, next_event}), vec3(0.196F), 0.002);
  check_near(along_paths(s.scene, 512, {4, next_event}), vec3(0.2306F), 0.002);
}

TEST_CASE("paths: lamps light a surface as ever", "[tracer][paths]") {
  using scene::Finish;
  const Colour colour = rgbft(0.8F, 0.4F, 0.2F);
  const std::array finishes = std::to_array<void (*)(Finish&)>({
      [](Finish& f) { f.diffuse = 0.6F; },
      [](Finish& f) { f.diffuse = 0.6F, f.brilliance = 2.5F; },
      [](Finish& f) { f.phong = 0.7F, f.phong_size = 5; },
      [](Finish& f) { f.specular = 0.7F, f.roughness = 0.1F, f.metallic = 0.6F; },
      [](Finish& f) { f.diffuse = 0.6F, f.irid = 0.35F, f.irid_thickness = 0.5F; },
      [](Finish& f) { f.diffuse = 0.3F, f.emission = vec3(0.1F); },
  });
  for (std::size_t i = 0; i < finishes.size(); ++i) {
    CAPTURE(i);
    Finish f = dull();
    finishes[i](f);
    Wall s;
    s.wall(plain(colour), f);
    check_near(along_paths(s.scene, 1), as_ever(s.scene), 1e-4);
  }
}

TEST_CASE("paths: layers, backs and both sides are lit as ever", "[tracer][paths]") {
  Wall layered;
  layered.add("plane", {0, 0, 1, 0},
              layered.layers({{plain(rgbft(0.1F, 0.2F, 0.9F)), matte(1), {}},
                              {plain(rgbft(0.8F, 0.4F, 0.2F, 0.1F, 0.5F)), matte(0.6F), {}}}));
  check_near(along_paths(layered.scene, 16), as_ever(layered.scene), 1e-4);

  SceneBuilder behind(tracer::registry());
  behind.look_straight({0, 0, -5}, {0, 0, 1});
  behind.light({0, 10, 10});
  scene::Finish both = matte(0.6F);
  both.diffuse_back = 0.3F;
  scene::Object& disc = behind.add("disc", {0, 0, 0, 0, 0, 1, 3, 0},
                                   behind.texture(plain(rgbft(1, 1, 1)), both));
  check_near(along_paths(behind.scene, 16), as_ever(behind.scene), 1e-4);
  disc.double_illuminate = true;
  check_near(along_paths(behind.scene, 16), as_ever(behind.scene), 1e-4);
}

TEST_CASE("paths: of many lamps one at a time is asked", "[tracer][paths]") {
  Wall s;
  for (int i = 0; i < 20; ++i) {
    s.light({10.0 * std::cos(i), 10.0 * std::sin(i), -3.0 - i}, vec3(0.05F * static_cast<float>(i)));
  }
  s.add("sphere", {1, 2, -2, 1}, s.texture(plain(rgbft(1, 1, 1)), dull()));
  scene::Finish f = matte(0.5F);
  f.phong = 0.5F;
  s.wall(plain(rgbft(0.1F, 0.2F, 0.1F)), f);
  check_near(along_paths(s.scene, 1024, {.max_bounces = 1}), as_ever(s.scene), 0.005);
}

TEST_CASE("paths: lamps of some extent are seen whole", "[tracer][paths]") {
  SceneBuilder s(tracer::registry());
  s.look_straight({0, 0, -5}, {0, 0, 1});
  scene::Light& lamp = s.light({0, 0, -10});
  lamp.has_area = true;
  lamp.area = {{4, 0, 0}, {0, 4, 0}, 129, 129};
  lamp.area.illumination = GENERATE(false, true);
  s.add("plane", {0, 0, 1, 0}, s.texture(plain(rgbft(1, 1, 1)), matte(1)));
  s.add("disc", {0.3, 0.2, -5, 0, 0, 1, 0.8, 0}, s.texture(plain(rgbft(0, 0, 0)), dull()));
  // The ordinary tracer's grid, as fine as it gets.
  check_near(along_paths(s.scene, 1024), as_ever(s.scene), 0.01);
}

TEST_CASE("paths: looking for light does not change how much there is", "[tracer][paths]") {
  Room room;
  SECTION("dull") {}
  SECTION("shiny") {
    scene::Finish f = matte(0.3F);
    f.specular = 3;
    f.roughness = 0.02F;
    f.phong = 2;
    f.phong_size = 20;
    room.add("sphere", {0.3, 0.5, 0.3, 0.4}, room.texture(plain(rgbft(0.9F, 0.8F, 0.2F)), f));
  }
  SECTION("in glass, in the dark of a pane") {
    room.add("sphere", {0.3, 0.5, 0.3, 0.4}, room.texture(plain(rgbft(1, 1, 1, 0, 1)), glass()));
    room.add("box", {-1, 1.5, -1, 1, 1.51, 1},
             room.texture(plain(rgbft(0.5F, 0.7F, 0.9F, 0.8F, 0.1F)), matte(0.5F)));
  }
  const vec3 looking = along_paths(room.scene, 1024);
  const vec3 waiting = along_paths(room.scene, 4096, {.next_event = false});
  CHECK(looking.x > 0.05F);
  check_near(looking, waiting, 0.02 * double{waiting.x});
}

TEST_CASE("paths: bright spots of the sky are looked for", "[tracer][paths]") {
  SceneBuilder s(tracer::registry());
  s.look_straight({0, 0, -5}, {0, 0, 1});
  scene::Pigment sun;
  sun.pattern.edit().type = s.pattern("gradient");
  sun.pattern.edit().args = {0.5, 0.6, -0.62};
  sun.entries = {{0, rgbft(0.1F, 0.2F, 0.3F)},
                 {0.97F, rgbft(0.1F, 0.2F, 0.3F)},
                 {0.97F, rgbft(40, 30, 20)},
                 {1, rgbft(40, 30, 20)}};
  s.scene.sky_sphere = scene::SkySphere();
  s.scene.sky_sphere->pigments = {sun};
  s.add("plane", {0, 0, 1, 0}, s.texture(plain(rgbft(1, 1, 1)), matte(0.8F)));
  const vec3 looking = along_paths(s.scene, 512);
  const vec3 waiting = along_paths(s.scene, 4096, {.next_event = false});
  check_near(looking, waiting, 0.01 * double{waiting.x});
}

TEST_CASE("paths: closed rooms are as bright as with radiosity", "[tracer][paths]") {
  Room room(false);
  scene::Light& lamp = room.light({0, 1.7, 0}, vec3(0.6F));
  lamp.fade_distance = 1;
  lamp.fade_power = 2;
  room.add("sphere", {0.3, 0.4, 0.4, 0.4}, room.texture(plain(rgbft(0.8F, 0.8F, 0.8F)), matte(1)));
  tracer::RenderOptions options = small_picture(24, 128);
  options.paths.max_bounces = 3;
  const vec3 paths = mean_of(tracer::render(*compiled_for_paths(room.scene), options).image);
  scene::Radiosity r;
  r.count = 200;
  r.recursion_limit = 2;
  r.error_bound = 0.3;
  r.minimum_reuse = 0.005;
  r.nearest_count = 10;
  room.scene.settings.radiosity = r;
  options.antialias = true;  // paths are not in the middles of pixels only
  options.aa_threshold = 0.01F;
  const vec3 cached = mean_of(tracer::render(*compiled(room.scene), options).image);
  for (int i = 0; i < 3; ++i) CHECK(cached[i] == Approx(paths[i]).epsilon(0.01));
}

TEST_CASE("paths: dispersed light adds up to what the bands do", "[tracer][paths]") {
  Floor s;
  scene::Interior water;
  water.ior = 1.5;
  water.dispersion = 1.2;
  water.dispersion_samples = 7;
  s.floor(plain(rgbft(1, 1, 1, 0, 1)), dull(), s.interior(water));
  scene::Pigment steps;
  steps.pattern.edit().type = s.pattern("gradient");
  steps.pattern.edit().args = {0, 0, 1};
  steps.entries = {{0, rgbft(0, 0, 0)}, {1, rgbft(1, 1, 1)}};
  s.add("plane", {0, 1, 0, -4}, s.texture(steps, luminous()));
  check_near(along_paths(s.scene, 1024), as_ever(s.scene), 0.005);
}

TEST_CASE("paths: alpha is the share that sees the background", "[tracer][paths]") {
  SceneBuilder s(tracer::registry());
  s.look_straight({0, 0, -5}, {0, 0, 1});
  s.scene.background = rgbft(0.5F, 0.25F, 0.8F, 0, 1);
  s.add("plane", {0, 0, 1, 0}, s.texture(plain(rgbft(0.9F, 0.6F, 0.3F, 0, 0.4F)), luminous()));
  const auto c = compiled_for_paths(s.scene);
  tracer::RenderOptions options = small_picture(4, 64);
  options.alpha = true;
  const auto image = tracer::render(*c, options).image;
  CHECK(image.at(1, 1)[3] == Approx(0.6).margin(0.02));
  CHECK(image.at(1, 1)[0] == Approx(0.54).margin(0.01));
}

TEST_CASE("paths: ambient light is found, not assumed", "[tracer][paths]") {
  SceneBuilder s(tracer::registry());
  s.look_straight({0, 0, -5}, {0, 0, 1});
  scene::Finish f = dull();
  f.ambient = vec3(0.5F);
  s.add("plane", {0, 0, 1, 0}, s.texture(plain(rgbft(1, 1, 1)), f));
  CHECK(along_paths(s.scene, 1) == vec3(0.0F));
  s.scene.settings.effective_version = 362;  // there it is how things glow
  CHECK(along_paths(s.scene, 1) == vec3(0.5F));
}

TEST_CASE("paths: what they cannot render is an error", "[tracer][paths]") {
  Wall s;
  scene::Finish f = dull();
  f.reflection_min = f.reflection_max = vec3(0.5F);
  f.reflection_exponent = 2;
  s.wall(plain(rgbft(1, 1, 1)), f);
  const SourceMap sources;
  Diagnostics diagnostics(sources);
  CHECK(tracer::compile(s.scene, diagnostics, 9, tracer::Integrator::path) == nullptr);
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].message.find("reflection_exponent") != std::string::npos);
  (void)compiled(s.scene);  // others can
}

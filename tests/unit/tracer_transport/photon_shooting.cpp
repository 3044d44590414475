#include "tracer/transport/photon_shooting.h"

#include <glm/geometric.hpp>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/scene_builder.h"
#include "tracer/compile.h"
#include "tracer/transport/photon_file.h"

using namespace durer;
using namespace durer::tracer;

namespace {

constexpr double pi = std::numbers::pi;

// A ball of glass above a floor, and a lamp of parallel light above both.
scene::Scene lens(double ior, const scene::Photons& settings) {
  test::SceneBuilder b(registry());
  scene::Finish matt = test::dull();
  matt.diffuse = 1;
  const scene::TextureId clear = b.texture(test::plain(test::rgbft(1, 1, 1, 0, 1)), test::dull());
  const scene::TextureId floor = b.texture(test::plain(test::rgbft(1, 1, 1)), matt);
  scene::Interior glass;
  glass.ior = ior;
  b.add("plane", {0, 1, 0, 0}, floor);
  scene::Object& ball = b.add("sphere", {0, 2, 0, 0.5}, clear, b.interior(glass));
  scene::ObjectPhotons& photons = ball.extras.edit().photons;
  photons.target = 1;
  photons.refraction = true;
  photons.collect = false;
  scene::Light& lamp = b.light({0, 10, 0}, vec3(2.0F));
  lamp.parallel = true;
  lamp.point_at = dvec3(0.0);
  b.look({0, 3, -5}, {0, 1, 0}, 50);
  b.scene.settings.photons = settings;
  return b.scene;
}

PhotonMaps shoot(const scene::Scene& scene, int threads) {
  SourceMap sources;
  Diagnostics diagnostics(sources);
  const CompiledScenePtr compiled = compile(scene, diagnostics);
  REQUIRE(compiled);
  ProgressMeter meter(0, {}, nullptr);
  std::string warning;
  return shoot_photons(*compiled, threads, meter, warning);
}

double power(const PhotonMap& map) {
  double sum = 0;
  for (std::uint32_t i = 0; i < map.size(); ++i) sum += map[i].power.x;
  return sum;
}

}  // namespace

TEST_CASE("photons: carry the lamp's light through a lens, all of it", "[tracer][photons]") {
  const double ior = GENERATE(1.0, 1.3, 1.5);
  CAPTURE(ior);
  scene::Photons settings;
  settings.spacing = 0.004;
  settings.autostop = 0;
  settings.jitter = GENERATE(0.0, 0.4, 1.0);
  CAPTURE(settings.jitter);
  const PhotonMaps maps = shoot(lens(ior, settings), 2);
  CHECK(maps.media.empty());
  const double beam = 2 * pi * 0.5 * 0.5;  // colour times area of the ball's disc
  CHECK(power(maps.surfaces) == Approx(beam).epsilon(0.01));
}

TEST_CASE("photons: their number follows the spacing, or is the one that was asked for",
          "[tracer][photons]") {
  scene::Photons settings;
  settings.spacing = 0.01;
  // One in each square of that side.
  CHECK(double(shoot(lens(1.3, settings), 1).surfaces.size()) ==
        Approx(pi * 0.25 / 1e-4).epsilon(0.02));
  settings.spacing = 0.02;
  CHECK(double(shoot(lens(1.3, settings), 1).surfaces.size()) ==
        Approx(pi * 0.25 / 4e-4).epsilon(0.02));
}

TEST_CASE("photons: are the same for any number of threads", "[tracer][photons]") {
  scene::Photons settings;
  settings.spacing = 0.01;
  const scene::Scene scene = lens(1.4, settings);
  const PhotonMaps one = shoot(scene, 1);
  const PhotonMaps many = shoot(scene, 5);
  REQUIRE(one.surfaces.size() == many.surfaces.size());
  CHECK(one.on_surfaces.radius == many.on_surfaces.radius);
  bool same = true;
  for (std::uint32_t i = 0; i < one.surfaces.size(); ++i) {
    same = same && one.surfaces[i].p == many.surfaces[i].p &&
           one.surfaces[i].power == many.surfaces[i].power;
  }
  CHECK(same);
}

TEST_CASE("photons: none without the global block, nor when `gather` takes none",
          "[tracer][photons]") {
  scene::Scene scene = lens(1.4, {});
  scene.settings.photons->spacing = 0.1;
  CHECK(!shoot(scene, 1).surfaces.empty());
  scene.settings.photons->gather_max = 0;
  CHECK(shoot(scene, 1).surfaces.empty());
  scene.settings.photons.reset();
  CHECK(shoot(scene, 1).surfaces.empty());
}

TEST_CASE("photon files: keep places, and the rest nearly", "[tracer][photons][files]") {
  PhotonLists lists;
  for (int i = 0; i < 100; ++i) {
    const dvec3 l = glm::normalize(dvec3(std::cos(i), 0.3 + std::sin(i), std::sin(2.0 * i)));
    lists.surfaces.push_back({vec3(float(i), float(i % 7), 1), vec3(0.5F, 1e-3F * float(i), 0.01F), vec3(l)});
  }
  lists.media.push_back({vec3(1, 2, 3), vec3(0.0F), vec3(0, -1, 0)});
  const auto bytes = encode_photons(lists);
  CHECK(bytes.size() == 8 + 101 * 20);
  const auto back = decode_photons(bytes);
  REQUIRE(back);
  REQUIRE(back->surfaces.size() == 100);
  REQUIRE(back->media.size() == 1);
  CHECK(back->media[0].p == vec3(1, 2, 3));
  for (const Photon& p : back->surfaces) {
    const Photon& from = lists.surfaces[static_cast<std::size_t>(p.p.x)];
    CHECK(p.p == from.p);
    for (int i = 0; i < 3; ++i) CHECK(p.power[i] == Approx(from.power[i]).margin(0.5 / 127));
    CHECK(glm::dot(p.l, from.l) > std::cos(0.06));
  }
  CHECK(!decode_photons(std::span(bytes).first(bytes.size() - 1)));
  CHECK(!decode_photons({}));
}

// Media along random paths, against closed forms.
#include <cmath>

#include "tests/unit/tracer_transport/path_test.h"
#include "tracer/shading/media.h"
#include "tracer/sobol.h"

using namespace durer;
using namespace durer::test;

namespace {

// A clear slab of thickness 2, seen straight on.
struct Slab : SceneBuilder {
  explicit Slab(const scene::Media& media) : SceneBuilder(tracer::registry()) {
    look_straight({0, 0, -5}, {0, 0, 1});
    scene::Interior inside;
    inside.media = std::vector{media};
    scene::Object& box = add("box", {-5, -5, -1, 5, 5, 1},
                             texture(plain(rgbft(1, 1, 1, 0, 1)), dull()), interior(inside));
    box.hollow = true;
  }
};

// The same density everywhere, in a way that has to be looked up.
scene::Media patterned(scene::Media media) {
  const SceneBuilder words(tracer::registry());
  scene::Pigment p;
  p.pattern.edit().type = words.pattern("gradient");
  p.pattern.edit().args = {0, 0, 1};
  p.entries = {{0, rgbft(1, 1, 1)}, {1, rgbft(1, 1, 1)}};
  media.densities = {p};
  return media;
}

}  // namespace

TEST_CASE("path media: emission and absorption are integrated exactly", "[tracer][paths][media]") {
  scene::Media m;
  m.emission = {0.5F, 0.1F, 0.2F};
  m.absorption = {1, 0.5F, 0.2F};
  const bool varies = GENERATE(false, true);
  Slab s(varies ? patterned(m) : m);
  s.scene.background = rgbft(1, 1, 1);
  const auto seen = [&](int i) {
    const float e = m.emission[i] / m.absorption[i];
    return e + (1 - e) * std::exp(-2 * m.absorption[i]);
  };
  check_near(along_paths(s.scene, 4), {seen(0), seen(1), seen(2)}, 1e-5);
}

TEST_CASE("path media: lamps are scattered once as the oracle has it", "[tracer][paths][media]") {
  scene::Media m;
  m.scattering = vec3(0.3F);
  const bool varies = GENERATE(false, true);
  Slab s(varies ? patterned(m) : m);
  scene::Light& lamp = s.light({0, 0, -100});
  lamp.parallel = true;
  lamp.point_at = {0, 0, 0};
  // The exact value of participating-and-global §1.16.
  check_near(along_paths(s.scene, 256, {.max_bounces = 1}), vec3(0.3494F), 5e-4);
}

TEST_CASE("path media: dust without loss in a white sky cannot be seen", "[tracer][paths][media]") {
  using scene::Phase;
  scene::Media m;
  m.scattering = {1.5F, 0.7F, 0.2F};
  m.phase = GENERATE(Phase::isotropic, Phase::mie_hazy, Phase::mie_murky, Phase::rayleigh,
                     Phase::henyey_greenstein);
  if (m.phase == Phase::henyey_greenstein) m.eccentricity = 0.6;
  const bool varies = GENERATE(false, true);
  SceneBuilder s(tracer::registry());
  s.look({0, 0, -4}, {0, 0, 0}, 25);
  s.scene.background = rgbft(1, 1, 1);
  scene::Interior inside;
  inside.media = std::vector{varies ? patterned(m) : m};
  scene::Object& ball = s.add("sphere", {0, 0, 0, 1},
                              s.texture(plain(rgbft(1, 1, 1, 0, 1)), dull()), s.interior(inside));
  ball.hollow = true;
  check_near(along_paths(s.scene, 512), vec3(1.0F), 0.01);
}

TEST_CASE("path media: looking for light does not change how much there is",
          "[tracer][paths][media]") {
  scene::Media m;
  m.scattering = vec3(0.4F);
  m.absorption = vec3(0.1F);
  SceneBuilder s(tracer::registry());
  s.look({0, 0, -4}, {0, 0, 0}, 40);
  s.scene.atmosphere = {m};
  s.add("sphere", {0, 0, 0, 8}, s.texture(plain(rgbft(0.5F, 0.5F, 0.5F)), matte(1)));
  s.scene.objects.back().hollow = true;
  scene::Finish bright = dull();
  bright.emission = vec3(10.0F);
  s.add("sphere", {0.5, 1, 1, 0.5}, s.texture(plain(rgbft(1, 1, 1)), bright));
  const vec3 looking = along_paths(s.scene, 512);
  const vec3 waiting = along_paths(s.scene, 4096, {.next_event = false});
  check_near(looking, waiting, 0.02 * double{waiting.x});
}

TEST_CASE("path media: fog is that of the ordinary tracer", "[tracer][paths][media]") {
  SceneBuilder s(tracer::registry());
  s.look_straight({0, 0, 0}, {0, 0, 1});
  scene::Fog fog;
  fog.distance = 20;
  fog.colour = rgbft(0.1F, 0.2F, 0.3F, 0.4F);
  s.scene.fogs = {fog};
  s.add("plane", {0, 0, 1, 10}, s.texture(plain(rgbft(0.9F, 0.6F, 0.3F)), luminous()));
  check_near(along_paths(s.scene, 1), as_ever(s.scene), 1e-5);
}

TEST_CASE("path media: phases scatter as they are weighed", "[tracer][paths][media]") {
  using scene::Phase;
  tracer::MediaProgram m;
  m.phase = GENERATE(Phase::isotropic, Phase::mie_hazy, Phase::mie_murky, Phase::rayleigh,
                     Phase::henyey_greenstein);
  if (m.phase == Phase::henyey_greenstein) m.eccentricity = GENERATE(0.5, -0.8);
  constexpr std::uint32_t count = 1 << 14;
  double even_mean = 0;
  double even_cosine = 0;
  double cosine = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    tracer::SobolSampler random(5, i);
    const double c = 2 * random.next() - 1;
    even_mean += tracer::phase_factor(m, c) / count;
    even_cosine += c * tracer::phase_factor(m, c) / count;
    cosine += tracer::phase_cosine(m, random.next2()) / count;
  }
  CHECK(tracer::mean_phase_factor(m) == Approx(even_mean).epsilon(1e-3));
  CHECK(cosine == Approx(even_cosine / even_mean).margin(0.003));
}

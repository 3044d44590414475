// Photons against random paths: two ways for light to come through glass and off mirrors.
#include "tests/unit/tracer_transport/path_test.h"

using namespace durer;
using namespace durer::test;

namespace {

// A floor below something that bends light, and what shines on it. It is dark, so that light which
// it throws back matters little. The camera looks at the part that the bent light and the shadow
// reach.
struct Bright : SceneBuilder {
  static constexpr double height = 8;    // of the lamp
  static constexpr double radius = 0.5;  // of what glows in its place
  static constexpr double fade = 0.05;
  static constexpr float colour = 100000;

  Bright() : SceneBuilder(tracer::registry()) {
    look({0, 2.2, -6}, {0, 0, 0}, 18);
    add("plane", {0, 1, 0, 0}, texture(plain(rgbft(1, 1, 1)), matte(0.04F)));
  }
  /// Black instead, it only casts its shadow.
  scene::Object& glass_ball(bool black) {
    scene::Interior inside;
    inside.ior = 1.5;
    return add("sphere", {0, 2, 0, 0.5}, texture(plain(rgbft(0, 0, 0, 0, black ? 0 : 1)), dull()),
               interior(inside));
  }
  scene::Object& mirror(bool black) {
    scene::Finish f = dull();
    f.reflection_min = f.reflection_max = vec3(black ? 0.0F : 0.8F);
    return add("box", {-0.4, 2, 1.5, 0.4, 3, 1.55}, texture(plain(rgbft(0, 0, 0)), f));
  }
  void shine_as_lamp(scene::Object& target) {
    scene::ObjectPhotons& p = target.extras.edit().photons;
    p.target = 1;
    p.refraction = p.reflection = true;
    p.collect = false;
    scene::Light& lamp = light({0, height, 0}, vec3(colour));
    lamp.fade_distance = fade;
    lamp.fade_power = 2;
    scene.settings.photons = scene::Photons{};
    scene.settings.photons->spacing = 0.002;
    scene.settings.photons->autostop = 0;
  }
  /// As much light as from the lamp: that falls off as 2 (fade/s)², this as (radius/s)².
  void shine_as_ball() {
    scene::Finish f = dull();
    f.emission = vec3(static_cast<float>(2 * colour * fade * fade / (radius * radius)));
    add("sphere", {0, height, 0, radius}, texture(plain(rgbft(1, 1, 1)), f));
  }
};

}  // namespace

TEST_CASE("paths: find the light that photons carry", "[tracer][paths][photons]") {
  scene::Object& (Bright::*const bends)(bool) = GENERATE(&Bright::glass_ball, &Bright::mirror);
  const auto with_lamp = [&](bool black) {
    Bright b;
    b.shine_as_lamp((b.*bends)(black));
    return mean_of(tracer::render(*compiled(b.scene), small_picture(48, 1)).image).x;
  };
  const auto with_ball = [&](bool black) {
    Bright b;
    (b.*bends)(black);
    b.shine_as_ball();
    return along_paths(b.scene, 16384).x;
  };
  const float dark = with_ball(true);
  const float photons = with_lamp(false) - with_lamp(true);
  const float paths = with_ball(false) - dark;
  CAPTURE(dark, with_lamp(true), photons, paths);
  CHECK(with_lamp(true) == Approx(dark).epsilon(0.01));
  // Photons lose about 1 % of the energy, as the oracle's do; the paths' noise is about 5 % here.
  CHECK(photons == Approx(paths).epsilon(0.1));
}

// The oracle's values for fog and rainbows (shading §10.5).
#include "tests/unit/tracer_shading/shading_test.h"

using namespace durer;
using namespace durer::test;

namespace {

// From the origin along z to a luminous wall at z = 10, which faces the camera.
struct Hall : SceneBuilder {
  Hall() : SceneBuilder(tracer::registry()) {
    look_straight({0, 0, 0}, {0, 0, 1});
    scene.background = rgbft(0.5F, 0.25F, 0.8F);
  }
  void wall() { add("plane", {0, 0, -1, -10}, texture(plain(rgbft(0.9F, 0.6F, 0.3F)), luminous())).hollow = true; }
  scene::Fog& fog(double distance, const Colour& colour) {
    scene::Fog f;
    f.distance = distance;
    f.colour = colour;
    scene.fogs.push_back(f);
    return scene.fogs.back();
  }
};

}  // namespace

TEST_CASE("fog: constant", "[tracer][fog]") {
  Hall s;
  s.wall();
  SECTION("plain") {
    s.fog(20, rgbft(0.1F, 0.2F, 0.3F));
    check_pixel(s.scene, {0.585229F, 0.442618F, 0.300008F});
  }
  SECTION("filter") {
    s.fog(20, rgbft(0.1F, 0.2F, 0.3F, 0.4F));
    check_pixel(s.scene, {0.388708F, 0.326162F, 0.249058F});
  }
  SECTION("transmit is the least that shines through") {
    s.fog(20, rgbft(0.1F, 0.2F, 0.3F, 0, 0.8F));
    check_pixel(s.scene, {0.740002F, 0.519997F, 0.300008F});
  }
  SECTION("two") {
    s.fog(20, rgbft(0.1F, 0.2F, 0.3F));
    s.fog(40, rgbft(0.3F, 0.1F, 0));
    check_pixel(s.scene, {0.530831F, 0.384237F, 0.259754F});
  }
  SECTION("turbulence of no extent still thins") {
    s.fog(20, rgbft(0.1F, 0.2F, 0.3F)).turbulent = true;
    s.scene.fogs[0].octaves = 3;
    check_pixel(s.scene, {0.597833F, 0.44892F, 0.300008F});
  }
}

TEST_CASE("fog: on the ground", "[tracer][fog]") {
  Hall s;
  s.wall();
  s.look_straight({0, 3, 0}, glm::normalize(dvec3(0, -0.3, 1)));
  scene::Fog& f = s.fog(20, rgbft(0.1F, 0.2F, 0.3F));
  f.kind = scene::Fog::Kind::ground;
  f.offset = 0.5;
  f.alt = 1.5;
  check_pixel(s.scene, {0.660395F, 0.480201F, 0.300008F}, 2 * oracle_step);
}

TEST_CASE("fog: none inside of solid bodies", "[tracer][fog]") {
  Hall s;
  s.wall();
  s.fog(20, rgbft(0.1F, 0.2F, 0.3F));
  scene::Object& ball = s.add("sphere", {0, 0, 0, 1}, s.texture(plain(rgbft(1, 1, 1, 0, 1)), dull()));
  const bool hollow = GENERATE(true, false);
  ball.hollow = hollow;
  CAPTURE(hollow);
  // 1 unit inside of the ball, 9 outside.
  const auto a = static_cast<float>(std::exp(-(hollow ? 10 : 9) / 20.0));
  check_pixel(s.scene, {0.1F + a * 0.8F, 0.2F + a * 0.4F, 0.3F}, 1e-5);
}

TEST_CASE("fog: weakens lamps that ask for it", "[tracer][fog]") {
  Wall s;
  scene::Finish f = dull();
  f.diffuse = 1;
  s.wall(plain(rgbft(1, 1, 1)), f).hollow = true;  // the camera is behind it
  s.scene.lights[0].position = {0, 0, -10};
  const bool on = GENERATE(true, false);
  s.scene.lights[0].media_attenuation = on;
  scene::Fog fog;
  fog.distance = 20;
  fog.colour = rgbft(0, 1, 0);
  s.scene.fogs.push_back(fog);
  const auto eye = static_cast<float>(std::exp(-5 / 20.0));
  CHECK(pixel(s.scene).x == Approx((on ? 0.6065F : 1.0F) * eye).margin(1e-4));
}

TEST_CASE("fog: hides the sky from the alpha channel", "[tracer][fog][alpha]") {
  Hall s;
  s.scene.background.transmit = 1;
  s.fog(20, rgbft(0.1F, 0.2F, 0.3F, 0, 0.25F));
  CHECK(pixel(s.scene, true).w == Approx(0.75).margin(1e-5));
}

TEST_CASE("rainbow: over the sky, up to what its map lets through", "[tracer][rainbow]") {
  Hall s;
  s.wall();
  scene::Rainbow bow;
  bow.angle_deg = 20;
  bow.width_deg = 10;
  bow.distance = 8;
  const double turn = glm::radians(18.0);
  bow.direction = {std::sin(turn), 0, std::cos(turn)};
  bow.colours = {{0, rgbft(1, 0, 0, 0, 0.2F)}, {1, rgbft(0, 0, 1, 0, 0.2F)}};
  s.scene.rainbows.push_back(bow);
  SECTION("seen") {
    // 0.3 of the way across the band; as dense as a fog of 8 over 10 units.
    const auto clear = static_cast<float>(std::exp(-10.0 / 8));
    const auto dense = 1 - clear;
    check_pixel(s.scene, {0.9F * clear + 0.7F * dense, 0.6F * clear, 0.3F});
  }
  SECTION("not outside of its band") {
    s.scene.rainbows[0].width_deg = 3;
    check_pixel(s.scene, {0.9F, 0.6F, 0.3F});
  }
}

// Media and densities, as data (participating-and-global §1.1).
#include "tests/support/catch.h"
#include "tests/unit/interpreter/support.h"

using namespace durer;
using namespace durer::interpreter::test;

namespace {

scene::Media media_of(const std::string& items, const std::string& before = {}) {
  const Run r = run(before + " media { " + items + " } sphere { 0, 1 }");
  CAPTURE(r.errors);
  REQUIRE(r.scene);
  REQUIRE(r.scene->atmosphere.size() == 1);
  return r.scene->atmosphere[0];
}

bool says(const std::string& text, const std::string& what) {
  const std::string error = error_of(text);
  CAPTURE(error);
  return error.find(what) != std::string::npos;
}

}  // namespace

TEST_CASE("media: the last of each setting counts, densities add up", "[interpreter][media]") {
  const scene::Media m = media_of(
      "absorption 1 absorption 0.5 scattering { 5, 1 eccentricity 0.3 } scattering { 2, 0.4 "
      "extinction 0.7 } samples 3, 9 intervals 4 density { rgb 0.5 } density { gradient x } collect "
      "off aa_level 5");
  CHECK(m.absorption == vec3(0.5F));
  CHECK(m.scattering == vec3(0.4F));
  CHECK(m.phase == scene::Phase::mie_hazy);
  CHECK(m.extinction == 0.7);
  CHECK(m.min_samples == 3);
  CHECK(m.max_samples == 9);
  CHECK(m.intervals == 4);
  CHECK(m.densities.size() == 2);
  CHECK_FALSE(m.collect);
  CHECK(m.aa_level == 5);
}

TEST_CASE("media: defaults are those of the version in force", "[interpreter][media]") {
  CHECK(media_of("").method == 3);
  CHECK(media_of("").min_samples == 10);
  const scene::Media old = media_of("", "#version 3.1;");
  CHECK(old.method == 1);
  CHECK(old.intervals == 10);
  CHECK(old.min_samples == 1);
}

TEST_CASE("media: a name is a copy to be changed", "[interpreter][media]") {
  const scene::Media m = media_of("M absorption 2 density { D }",
                                  "#declare D = density { gradient x } "
                                  "#declare M = media { emission 0.5 density { D } }");
  CHECK(m.emission == vec3(0.5F));
  CHECK(m.absorption == vec3(2.0F));
  CHECK(m.densities.size() == 2);
}

TEST_CASE("media: transformations move the densities before them", "[interpreter][media]") {
  const scene::Media m =
      media_of("scale 7 density { gradient x scale 2 } scale 3 density { gradient x }");
  CHECK(m.densities[0].pattern->transform->forward.x.x == 6);
  CHECK(m.densities[1].pattern->transform.is_identity());
}

TEST_CASE("media: those of an interior move with their object", "[interpreter][media]") {
  const Run r = run(
      "sphere { 0, 1 scale 5 interior { media { density { gradient x } } } scale 2 translate x }");
  REQUIRE(r.scene);
  const auto moved = r.scene->objects.back().extras->media_transform;
  CHECK(moved->forward.x.x == 2);
  CHECK(moved->forward.t.x == 1);
}

TEST_CASE("media: those of a material move with it", "[interpreter][media]") {
  const Run r = run(
      "sphere { 0, 1 material { interior { media { density { gradient x } } } scale 2 } scale 3 }");
  REQUIRE(r.scene);
  const scene::Object& ball = r.scene->objects.back();
  CHECK(ball.extras->media_transform->forward.x.x == 3);
  const scene::Media& m = r.scene->interiors[ball.interior].media->at(0);
  CHECK(m.densities[0].pattern->transform->forward.x.x == 2);
}

TEST_CASE("media: densities are black unless they say otherwise", "[interpreter][media]") {
  CHECK(media_of("density { }").densities[0].colour.rgb == vec3(0.0F));
  CHECK(media_of("density { rgb <1, 2, 3> }").densities[0].colour.rgb == vec3(1, 2, 3));
  const scene::Pigment map =
      media_of("density { gradient x density_map { [0 rgb 1] [1 gradient x scale 2] } }").densities[0];
  CHECK(map.entries.size() == 2);
  CHECK(map.children[1].pattern->exists());
}

TEST_CASE("media: what makes no sense is told", "[interpreter][media]") {
  CHECK(says("media { method 4 }", "1, 2 or 3"));
  CHECK(says("media { intervals 0 }", "at least 1"));
  CHECK(says("media { samples 3, 2 }", "a minimum and a maximum"));
  CHECK(says("media { confidence 1 }", "below 1"));
  CHECK(says("media { aa_threshold 0 }", "positive"));
  CHECK(says("media { scattering { 1, 1 eccentricity 0.2 } }", "type 5"));
  CHECK(says("media { density { gradient x pigment_map { [0 rgb 1] } } }", "pigment_map"));
  CHECK(says("media { density { checker } }", "2 densities"));
  CHECK(says("media { ammount 3 }", "ammount"));
  CHECK(run("media { scattering { 6, 1 } } sphere { 0, 1 }").warnings.size() == 1);
}

// `photons { … }` → plain scene data.
#include "support.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::interpreter::test;

namespace {

scene::Photons photons(const std::string& items) {
  const Run r = run("global_settings { photons { " + items + " } }");
  CAPTURE(r.errors);
  REQUIRE(r.scene);
  REQUIRE(r.scene->settings.photons);
  return *r.scene->settings.photons;
}

std::string flaw(const std::string& items) {
  return error_of("global_settings { photons { " + items + " } }").substr(0, 5);
}

struct Seen {
  scene::ObjectPhotons photons;
  std::size_t warnings;
};
Seen object(const std::string& items) {
  const Run r = run("sphere { 0, 1 photons { " + items + " } }");
  CAPTURE(r.errors);
  REQUIRE(r.scene);
  return {r.scene->objects[r.scene->roots.at(0).object].extras->photons, r.warnings.size()};
}

}  // namespace

TEST_CASE("photons: settings", "[interpreter][photons]") {
  CHECK(photons("") == scene::Photons{});
  const scene::Photons p = photons(
      "spacing .1 gather 10, 50 media 100, 2 jitter 0 autostop 0 expand_thresholds .3, 20 "
      "max_trace_level 7 adc_bailout .01 radius .2, 2, 0, 3");
  CHECK(p.spacing == 0.1);
  CHECK(p.count == 0);
  CHECK(p.gather_min == 10);
  CHECK(p.gather_max == 50);
  CHECK(p.media_steps == 100);
  CHECK(p.media_factor == 2);
  CHECK(p.jitter == 0);
  CHECK(p.expand_increase == 0.3);
  CHECK(p.expand_min == 20);
  CHECK(p.max_trace_level == 7);
  CHECK(p.surface_radius == 0.2);
  CHECK(p.surface_factor == 2);
  CHECK(p.media_radius == 0);
  CHECK(p.media_factor_of_radius == 3);
  CHECK(photons("count 20000").count == 20000);
  CHECK(photons("radius").surface_radius == 0);
  CHECK(photons("radius 2").surface_radius == 2);
  CHECK(photons("media 20").media_factor == 1);
}

TEST_CASE("photons: settings that cannot be", "[interpreter][photons]") {
  CHECK(flaw("gather 20, 10") == "D0302");
  CHECK(flaw("gather -1, 10") == "D0302");
  CHECK(flaw("media -1") == "D0302");
  CHECK(flaw("media 10, 0") == "D0302");
  CHECK(flaw("spacing 0") == "D0302");
  CHECK(flaw("spaceing 1") == "D0214");
  CHECK(flaw("target") == "D0214");
  CHECK(flaw("load_file \"nowhere.ph\"") == "D0601");
}

TEST_CASE("photons: of objects", "[interpreter][photons]") {
  CHECK(object("").photons == scene::ObjectPhotons{});
  const scene::ObjectPhotons o = object("target 2 reflection on refraction off collect off").photons;
  CHECK(o.target == 2);
  CHECK(o.reflection == true);
  CHECK(o.refraction == false);
  CHECK(o.collect == false);
  CHECK(object("target").photons.target == 1);
  CHECK(object("target -1").photons.target == 0);
  CHECK(object("pass_through").photons.pass_through);
}

TEST_CASE("photons: a target cannot be passed through and refract, the last word decides",
          "[interpreter][photons]") {
  const Seen passed = object("target refraction on pass_through");
  CHECK(passed.warnings == 1);
  CHECK(passed.photons.pass_through);
  CHECK(passed.photons.refraction == false);
  const Seen refracts = object("target pass_through refraction on");
  CHECK(refracts.warnings == 1);
  CHECK(!refracts.photons.pass_through);
  const Seen target = object("pass_through target");
  CHECK(target.photons.pass_through);
  CHECK(target.photons.refraction == false);
  CHECK(object("target pass_through refraction off").warnings == 0);
}

TEST_CASE("photons: of light sources and groups", "[interpreter][photons]") {
  const Run r = run(
      "light_source { y rgb 1 photons { refraction on reflection off area_light } }\n"
      "light_group { sphere { 0, 1 } photons { target } }");
  REQUIRE(r.scene);
  const scene::LightPhotons& l = r.scene->lights.at(0).photons;
  CHECK(l.refraction == true);
  CHECK(l.reflection == false);
  CHECK(l.area);
  CHECK(r.scene->objects[r.scene->roots.at(1).object].extras->photons.target == 1);
  CHECK(error_of("light_source { y rgb 1 photons { target } }").substr(0, 5) == "D0214");
}

// From a point to a colour: pipeline, maps and nesting (textures §3, §11.1).
#include "tracer/shading/pigment.h"

#include "tests/unit/tracer_shading/shading_test.h"

using namespace durer;
using namespace durer::test;
using durer::tracer::PigmentStore;
using durer::tracer::shape_wave;

namespace {

const SceneBuilder names(tracer::registry());

scene::Pigment ramp(std::vector<scene::PigmentEntry> entries) {
  scene::Pigment p;
  p.pattern.edit().type = names.pattern("gradient");
  p.pattern.edit().args = {1, 0, 0};
  p.entries = std::move(entries);
  return p;
}

scene::PigmentEntry at_key(float key, float grey) {
  return {key, rgbft(grey, grey, grey), scene::none};
}

float red(const scene::Pigment& pigment, dvec3 p, const Transform& to_world = {}) {
  PigmentStore store;
  const auto id = store.add(pigment, to_world);
  return store.at(id, p).rgb.x;
}

}  // namespace

TEST_CASE("pigment: a plain colour is the same everywhere", "[tracer][pigment]") {
  CHECK(red(plain(rgbft(0.25F, 0, 0)), {7, -3, 1e9}) == 0.25F);
}

TEST_CASE("pigment: entries blend between their keys", "[tracer][pigment]") {
  const auto p = ramp({at_key(0.25F, 0), at_key(0.75F, 1)});
  CHECK(red(p, {0.1, 0, 0}) == 0);
  CHECK(red(p, {0.5, 0, 0}) == Approx(0.5));
  CHECK(red(p, {0.9, 0, 0}) == 1);
  CHECK(red(p, {-0.5, 0, 0}) == Approx(0.5));
  CHECK(red(p, {3.375, 0, 0}) == Approx(0.25));
}

TEST_CASE("pigment: at a doubled key the first entry wins", "[tracer][pigment]") {
  const auto p = ramp({at_key(0, 0), at_key(0.5F, 0.25F), at_key(0.5F, 0.75F), at_key(1, 1)});
  CHECK(red(p, {0.5, 0, 0}) == 0.25F);
  CHECK(red(p, {0.5 + 1e-9, 0, 0}) == Approx(0.75).epsilon(1e-6));
}

TEST_CASE("pigment: maps are searched as written", "[tracer][pigment]") {
  const auto p = ramp({at_key(0.5F, 0.1F), at_key(0.2F, 0.9F), at_key(0.8F, 0.5F)});
  CHECK(red(p, {0.3, 0, 0}) == 0.1F);  // below the first key
  // Beyond the first, the out-of-order entry is the lower neighbour.
  CHECK(red(p, {0.6, 0, 0}) == Approx(0.9 + (0.6 - 0.2) / 0.6 * (0.5 - 0.9)));
}

TEST_CASE("pigment: the value 1 finds the last entry", "[tracer][pigment]") {
  const auto p = ramp({at_key(0, 0), at_key(1, 1)});
  CHECK(red(p, {1, 0, 0}) == 1);
  CHECK(red(p, {1.001, 0, 0}) == Approx(0.001));
}

TEST_CASE("pigment: frequency, phase and waves shape the value", "[tracer][pigment]") {
  auto p = ramp({at_key(0, 0), at_key(1, 1)});
  SECTION("frequency and phase") {
    p.pattern.edit().frequency = 3;
    p.pattern.edit().phase = 0.25F;
    CHECK(red(p, {0.5, 0, 0}) == Approx(std::fmod(1.75, 1.00001)));
  }
  SECTION("negative frequency wraps upwards") {
    p.pattern.edit().frequency = -1;
    CHECK(red(p, {0.25, 0, 0}) == Approx(0.75));
  }
  SECTION("frequency 0 takes the raw value and ignores phase") {
    p.pattern.edit().frequency = 0;
    p.pattern.edit().phase = 0.25F;
    CHECK(red(p, {0.5, 0, 0}) == Approx(0.5));
  }
  SECTION("sine") {
    p.pattern.edit().wave = scene::Wave::sine;
    CHECK(red(p, {0.25, 0, 0}) == Approx(1));
    CHECK(red(p, {0.75, 0, 0}) == Approx(0).margin(1e-7));
  }
  SECTION("others") {
    CHECK(shape_wave(scene::Wave::triangle, 1, 0.25) == 0.5);
    CHECK(shape_wave(scene::Wave::triangle, 1, 0.75) == 0.5);
    CHECK(shape_wave(scene::Wave::scallop, 1, 0.5) == Approx(1));
    CHECK(shape_wave(scene::Wave::cubic, 1, 0.25) == Approx(0.15625));
    CHECK(shape_wave(scene::Wave::poly, 2, 0.5) == 0.25);
  }
}

TEST_CASE("pigment: entries move with the pattern around them", "[tracer][pigment]") {
  scene::Pigment inner = ramp({at_key(0, 0), at_key(1, 1)});
  scene::Pigment outer;
  outer.pattern.edit().type = names.pattern("checker");
  outer.pattern.edit().frequency = 0;
  outer.entries = {{0, {}, 0}, at_key(1, 0.125F)};
  outer.children = {inner};
  outer.pattern.edit().transform = Transform::scale({4, 4, 4});
  CHECK(red(outer, {1, 1, 1}) == Approx(0.25));
  CHECK(red(outer, {5, 1, 1}) == 0.125F);
  CHECK(red(outer, {11, 1, 1}, Transform::translate({10, 0, 0})) == Approx(0.25));
}

TEST_CASE("pigment: colours of several points are those of each", "[tracer][pigment]") {
  scene::Pigment inner = ramp({at_key(0, 0.25F), at_key(1, 0.5F)});
  scene::Pigment p = ramp({at_key(0.25F, 0), at_key(0.75F, 1)});
  p.pattern.edit().frequency = 3;
  p.entries[1].pigment = 0;
  p.children.push_back(inner);
  PigmentStore store;
  const Transform to_world = Transform::scale({2, 1, 1}).then(Transform::translate({0.3, 0, 0}));
  const auto id = store.add(p, to_world);
  std::vector<dvec3> points;
  for (int i = 0; i < 13; ++i) points.push_back({0.37 * i - 2, 0.1 * i, 1});
  std::vector<dvec3> moved = points;
  std::vector<Colour> colours(points.size());
  store.at(id, moved, colours.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(colours[i].rgb == store.at(id, points[i]).rgb);
  }
}

TEST_CASE("pigment: opaque unless some entry lets light through", "[tracer][pigment]") {
  PigmentStore store;
  auto p = ramp({at_key(0, 0), at_key(1, 1)});
  CHECK(store.opaque(store.add(p, {})));
  p.entries[1].colour.transmit = 0.1F;
  CHECK_FALSE(store.opaque(store.add(p, {})));
  CHECK_FALSE(store.opaque(store.add(plain(rgbft(1, 1, 1, 0.1F)), {})));
}

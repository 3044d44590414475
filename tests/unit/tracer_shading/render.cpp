// The film: any number of threads, parts of a picture, progress and cancelling.
#include <algorithm>
#include <cstring>

#include "tests/unit/tracer_shading/shading_test.h"

using namespace durer;
using namespace durer::test;
using tracer::render;
using tracer::RenderOptions;

namespace {

// Mirrors, glass, shadows, layers and random numbers in one small scene.
scene::Scene busy_scene() {
  SceneBuilder s(tracer::registry());
  s.look({0, 2, -8}, {0, 0, 0}, 50);
  s.scene.background = rgbft(0.1F, 0.2F, 0.4F);
  s.light({10, 20, -30});
  s.light({-20, 10, -10}, {0.5F, 0.4F, 0.2F});
  scene::Pigment checks;
  checks.pattern.edit().type = s.pattern("checker");
  checks.pattern.edit().frequency = 0;
  checks.entries = {{0, rgbft(1, 1, 1), scene::none}, {1, rgbft(0.2F, 0, 0), scene::none}};
  scene::Finish rough;
  rough.crand = 0.1F;
  s.add("plane", {0, 1, 0, -1}, s.texture(checks, rough));
  scene::Finish shiny;
  shiny.reflection_min = shiny.reflection_max = vec3(0.4F);
  shiny.phong = 0.5F;
  const auto mirror = s.texture(plain(rgbft(0.3F, 0.5F, 0.3F)), shiny);
  const auto glass = s.texture(plain(rgbft(1, 0.9F, 0.8F, 0.7F, 0.2F)), shiny);
  scene::Interior crown;
  crown.ior = 1.5;
  const auto inside = s.interior(crown);
  for (int i = 0; i < 12; ++i) {
    const double a = i;
    s.add("sphere", {3 * std::cos(a * 2.4), 0.3 * (i % 4), 3 * std::sin(a * 2.4), 0.7},
          i % 3 == 0 ? glass : mirror, inside);
  }
  return s.scene;
}

}  // namespace

TEST_CASE("render: the picture is the same for any number of threads", "[tracer][render]") {
  const scene::Scene scene = busy_scene();
  const auto c = compiled(scene);
  RenderOptions options;
  options.width = 100;
  options.height = 75;
  options.antialias = GENERATE(false, true);
  options.threads = 1;
  const auto first = render(*c, options);
  for (const int threads : {2, 3, 7}) {
    CAPTURE(threads);
    options.threads = threads;
    const auto other = render(*c, options);
    CHECK(std::memcmp(first.image.pixels.data(), other.image.pixels.data(),
                      first.image.pixels.size() * sizeof(float)) == 0);
    CHECK(other.final.rays == first.final.rays);
  }
}

TEST_CASE("render: a part has the pixels of the whole", "[tracer][render]") {
  const scene::Scene scene = busy_scene();
  const auto c = compiled(scene);
  RenderOptions options;
  options.width = 64;
  options.height = 48;
  const auto whole = render(*c, options);
  options.first_column = 10;
  options.end_column = 30;
  options.first_row = 20;
  const auto part = render(*c, options);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool inside = x >= 10 && x < 30 && y >= 20;
      for (int i = 0; i < 4; ++i) {
        CHECK(part.image.at(x, y)[i] == (inside ? whole.image.at(x, y)[i] : 0.0F));
      }
    }
  }
  CHECK(part.final.pixels_done == 20 * 28);
  CHECK(part.final.pixels_total == 20 * 28);
}

TEST_CASE("render: progress grows to the end", "[tracer][render]") {
  const scene::Scene scene = busy_scene();
  const auto c = compiled(scene);
  RenderOptions options;
  std::uint64_t last = 0;
  const auto r = render(*c, options, [&](const tracer::Progress& p) {
    CHECK(p.pixels_done >= last);
    CHECK(p.pixels_total == 160 * 120);
    last = p.pixels_done;
  });
  CHECK(last > 0);
  CHECK(r.final.pixels_done == 160 * 120);
  CHECK(r.final.rays > r.final.pixels_done);
  CHECK_FALSE(r.cancelled);
}

TEST_CASE("render: cancelling stops early", "[tracer][render]") {
  const scene::Scene scene = busy_scene();
  const auto c = compiled(scene);
  const std::atomic<bool> cancel{true};
  const auto r = render(*c, {}, {}, &cancel);
  CHECK(r.cancelled);
  CHECK(r.final.pixels_done == 0);
}

TEST_CASE("render: taken up again, a picture is the same to the last bit", "[tracer][render]") {
  const scene::Scene scene = busy_scene();
  const auto c = compiled(scene);
  RenderOptions options;
  options.width = 200;
  options.height = 150;
  options.antialias = GENERATE(false, true);
  options.threads = 2;
  const auto whole = render(*c, options);

  std::atomic<bool> cancel{false};
  tracer::Checkpoint first(options);
  const auto half = render(*c, options, [&](const auto&) { cancel = true; }, &cancel, &first);
  REQUIRE(half.cancelled);
  const tracer::Checkpoint::State state = first.copy();
  const auto done = std::count(state.done.begin(), state.done.end(), 1);
  REQUIRE(done > 0);
  REQUIRE(static_cast<std::size_t>(done) < state.done.size());

  tracer::Checkpoint second(options);
  REQUIRE(second.restore(state));
  const auto rest = render(*c, options, {}, nullptr, &second);
  CHECK_FALSE(rest.cancelled);
  CHECK(rest.image.pixels == whole.image.pixels);
  CHECK(rest.final.pixels_total < whole.final.pixels_total);
  CHECK(half.final.pixels_done + rest.final.pixels_done == whole.final.pixels_done);
}

TEST_CASE("render: a checkpoint of another size is refused", "[tracer][render]") {
  RenderOptions options;
  const tracer::Checkpoint small(options);
  options.width += 16;
  tracer::Checkpoint large(options);
  CHECK_FALSE(large.restore(small.copy()));
}

// Pictures in passes.
#include "tracer/film/progressive.h"

#include <chrono>
#include <thread>

#include "tests/unit/tracer_transport/path_test.h"

using namespace durer;
using namespace durer::test;
using tracer::RenderOptions;

namespace {

scene::Scene some_scene() {
  SceneBuilder s(tracer::registry());
  s.look({0, 1, -5}, {0, 0, 0}, 50);
  s.scene.background = rgbft(0.5F, 0.6F, 0.8F);
  s.light({-3, 5, -4});
  s.add("plane", {0, 1, 0, -1}, s.texture(plain(rgbft(0.7F, 0.6F, 0.5F)), matte(0.8F)));
  scene::Finish f = matte(0.4F);
  f.reflection_min = f.reflection_max = vec3(0.3F);
  s.add("sphere", {0, 0, 0, 1}, s.texture(plain(rgbft(0.8F, 0.3F, 0.2F)), f));
  return s.scene;
}

}  // namespace

TEST_CASE("passes: they end at the wanted number of samples", "[tracer][paths]") {
  CHECK(tracer::pass_ends(1) == std::vector{1});
  CHECK(tracer::pass_ends(5) == std::vector{1, 2, 3, 4, 5});
  const int samples = GENERATE(64, 100, 1000, 16777216);
  const std::vector<int> ends = tracer::pass_ends(samples);
  CHECK(ends.back() == samples);
  CHECK(ends.size() <= 255);
  CHECK(std::is_sorted(ends.begin(), ends.end()));
}

TEST_CASE("passes: the picture does not depend on threads and blocks", "[tracer][paths]") {
  const scene::Scene scene = some_scene();
  const auto c = compiled_for_paths(scene);
  RenderOptions options = small_picture(40, 10);
  options.threads = 1;
  const auto one = tracer::render(*c, options);
  options.threads = 3;
  options.block_size = 7;
  const auto three = tracer::render(*c, options);
  CHECK(one.image.pixels == three.image.pixels);
  CHECK(one.final.rays == three.final.rays);
  CHECK(one.final.pixels_done == 40 * 40 * 10);
}

TEST_CASE("passes: taken up again, a picture is the same to the last bit", "[tracer][paths]") {
  const scene::Scene scene = some_scene();
  const auto c = compiled_for_paths(scene);
  RenderOptions options = small_picture(20, 10);
  options.threads = 1;
  const auto whole = tracer::render(*c, options);

  std::atomic<bool> cancel{false};
  tracer::Checkpoint first(options);
  const auto stop = [&](const tracer::Progress& p) {
    cancel = p.pixels_done > std::uint64_t{20} * 20 * 5 / 4;
    std::this_thread::sleep_for(std::chrono::milliseconds(210));  // or the next block is not told
  };
  const auto half = tracer::render(*c, options, stop, &cancel, &first);
  REQUIRE(half.cancelled);
  const tracer::Checkpoint::State state = first.copy();
  CHECK(state.done.front() == 2);
  CHECK(state.done.back() == 1);
  tracer::Checkpoint second(options);
  REQUIRE(second.restore(state));
  const auto rest = tracer::render(*c, options, {}, nullptr, &second);
  CHECK(rest.image.pixels == whole.image.pixels);
  CHECK(half.final.pixels_done + rest.final.pixels_done == whole.final.pixels_done);
}

TEST_CASE("passes: more samples are less noise", "[tracer][paths]") {
  const scene::Scene scene = some_scene();
  const auto c = compiled_for_paths(scene);
  const auto truth = tracer::render(*c, small_picture(24, 1024)).image;
  const auto noise = [&](int samples) {
    const auto image = tracer::render(*c, small_picture(24, samples)).image;
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const double e = image.pixels[i] - truth.pixels[i];
      sum += e * e;
    }
    return std::sqrt(sum);
  };
  CHECK(noise(64) < 0.5 * noise(4));
}

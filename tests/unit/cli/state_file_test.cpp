#include "cli/state_file.h"

#include "cli/scene_file.h"
#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

tracer::Checkpoint::State some_state() {
  tracer::Checkpoint::State state{{1, 0, 1}, image::Image(3, 2)};
  for (std::size_t i = 0; i < state.image.pixels.size(); ++i) {
    state.image.pixels[i] = static_cast<float>(i) / 7;
  }
  return state;
}

}  // namespace

TEST_CASE("state file: what is written can be read", "[cli][state]") {
  const test::Folder folder;
  REQUIRE_FALSE(write_state("a.state", 42, some_state()));
  const StateRead read = read_state("a.state", 42);
  REQUIRE_FALSE(read.error);
  CHECK(read.state.done == some_state().done);
  CHECK(read.state.image.width == 3);
  CHECK(read.state.image.pixels == some_state().image.pixels);
}

TEST_CASE("state file: another scene, damage and other files are refused", "[cli][state]") {
  const test::Folder folder;
  REQUIRE_FALSE(write_state("a.state", 42, some_state()));
  const auto error = [](std::uint64_t print) {
    return read_state("a.state", print).error.value_or("");
  };
  CHECK(error(43).find("another scene") != std::string::npos);
  const std::string whole = *read_file("a.state");
  folder.file("a.state", whole.substr(0, whole.size() - 9));
  CHECK(error(42).find("damaged") != std::string::npos);
  std::string bent = whole;
  bent[whole.size() / 2] ^= 1;
  folder.file("a.state", bent);
  CHECK(error(42).find("damaged") != std::string::npos);
  folder.file("a.state", std::string(200, 'x'));
  CHECK(error(42).find("not a state file") != std::string::npos);
  folder.file("a.state", "");
  CHECK(error(42).find("damaged") != std::string::npos);
  CHECK(write_state("no/such/folder/a.state", 42, some_state()));
}

TEST_CASE("state file: it stands beside the picture", "[cli][state]") {
  CHECK(state_path("d/a.png") == "d/a.png.state");
  CHECK(state_path("-").empty());
  CHECK(state_path("").empty());
}

TEST_CASE("state file: scenes and options have fingerprints", "[cli][state]") {
  const scene::Registry registry{};
  scene::Scene scene;
  tracer::RenderOptions options;
  const std::uint64_t plain = fingerprint(scene, registry, options);
  CHECK(fingerprint(scene, registry, options) == plain);
  options.threads = 7;
  CHECK(fingerprint(scene, registry, options) == plain);
  options.aa_depth = 9;  // without anti-aliasing it does not count
  CHECK(fingerprint(scene, registry, options) == plain);
  options.antialias = true;
  CHECK(fingerprint(scene, registry, options) != plain);
  options.antialias = false;
  options.width = 161;
  CHECK(fingerprint(scene, registry, options) != plain);
  options.width = 160;
  scene.camera.location.x = 1e-15;
  CHECK(fingerprint(scene, registry, options) != plain);
}

}  // namespace durer::cli

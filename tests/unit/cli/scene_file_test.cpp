#include "cli/scene_file.h"

#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

struct Read {
  Settings settings;
  bool found = false;
  std::vector<std::string> messages;
};

Read read(const std::string& name, std::vector<std::string> words = {}) {
  words.push_back("+I" + name);
  Read r{test::accepted(words), false, {}};
  SourceMap sources;
  Diagnostics diagnostics(sources);
  r.found = read_scene(r.settings, diagnostics).has_value();
  for (const Diagnostic& d : diagnostics.all()) r.messages.push_back(d.message);
  CHECK(r.found != diagnostics.has_errors());
  return r;
}

}  // namespace

TEST_CASE("scene file: the exact name, then its suffixes, then library folders", "[cli][scene]") {
  const test::Folder folder;
  folder.file("a.pov", "");
  folder.file("b.scene", "");
  folder.file("lib/c.pov", "");
  CHECK(read("a.pov").settings.input == "a.pov");
  CHECK(read("a").settings.input == "a.pov");
  CHECK(read("b").settings.input == "b.scene");
  CHECK_FALSE(read("c").found);
  CHECK(read("c", {"+Llib"}).settings.input == "lib/c.pov");
  CHECK(read("a").messages.empty());
}

TEST_CASE("scene file: another spelling is found with a warning", "[cli][scene]") {
  const test::Folder folder;
  folder.file("Scenes/Desk.pov", "");
  const auto r = read("scenes\\DESK.POV");
  CHECK(r.settings.input == "Scenes/Desk.pov");
  REQUIRE(r.messages.size() == 1);
  CHECK(r.messages[0].find("Scenes/Desk.pov") != std::string::npos);
}

TEST_CASE("scene file: what is not there, or a folder, is an error that names it", "[cli][scene]") {
  const test::Folder folder;
  folder.file("d.pov/x", "");
  for (const char* name : {"nowhere.pov", "d.pov"}) {
    const auto r = read(name);
    CHECK_FALSE(r.found);
    REQUIRE(r.messages.size() == 1);
    CHECK(r.messages[0].find(name) != std::string::npos);
  }
}

}  // namespace durer::cli

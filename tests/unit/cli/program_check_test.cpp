// `durer check`, dumps, traces and messages for programs.
#ifdef DURER_PROGRAM

#include "tests/unit/cli/program.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;
using test::has;
using test::run;
using test::scene;

}  // namespace

TEST_CASE("program: check reads and renders nothing", "[cli][program][check]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  folder.file("b.scene", scene);
  const test::Run r = run("check a.pov b.scene");
  CAPTURE(r.err);
  CHECK(r.code == 0);
  CHECK(r.out.empty());
  CHECK(has(r.err, "a.pov: 2 objects, 1 light, "));
  CHECK(has(r.err, "b.scene: 2 objects, 1 light, "));
  CHECK(has(r.err, "1 file read"));
  CHECK(has(r.err, "assumed_gamma 1"));
  CHECK_FALSE(fs::exists("a.png"));
}

TEST_CASE("program: what came to light while rendering names its object",
          "[cli][program][diagnostics]") {
  const test::Folder folder;
  folder.file("steep.pov",
              "#version 3.7; global_settings { assumed_gamma 1 }\n"
              "camera { location -3*z look_at 0 }\n"
              "#declare F = function { pattern { gradient z } }\n"
              "isosurface {\n"
              "  function { 2.5 - 5*F(x, y, z/9 + 0.5) } max_gradient 0.2 }\n");
  const test::Run text = run("+Isteep.pov +W16 +H12 -O-");
  CAPTURE(text.err);
  CHECK(has(text.err, "warning[D0501]: the function of this `isosurface` has slopes of 0.555"));
  CHECK(has(text.err, "--> steep.pov:4:1"));
  CHECK(has(text.err, "write `max_gradient 0.555`"));
  const test::Run json = run("--diagnostics=json +Isteep.pov +W16 +H12 -O-");
  CHECK(has(json.err, "\"code\":\"D0501\""));
}

TEST_CASE("program: options may stand before a command", "[cli][program][check]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  const test::Run r = run("+W80 --size 8x6 -D check a.pov");
  CAPTURE(r.err);
  CHECK(r.code == 0);
  CHECK(has(r.err, "a.pov: 2 objects"));
  CHECK_FALSE(fs::exists("a.png"));
}

TEST_CASE("program: check fails if one scene is bad, and looks at all", "[cli][program][check]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  folder.file("bad.pov", "sphere { 0, 1\n");
  const test::Run r = run("check bad.pov nowhere.pov a.pov");
  CHECK(r.code == 1);
  CHECK(has(r.err, "--> bad.pov:"));
  CHECK(has(r.err, "nowhere.pov"));
  CHECK(has(r.err, "a.pov: 2 objects"));
  CHECK(run("check").code == 1);
  CHECK(run("check a.pov --quiet").err.empty());
  CHECK(has(run("check a.pov +W0").err, "error"));
}

TEST_CASE("program: messages as JSON, one object a line", "[cli][program][json]") {
  const test::Folder folder;
  folder.file("bad.pov", "#debug \"hi\"\nsphere { 0, Nobody }\n");
  const test::Run r = run("bad.pov --diagnostics=json");
  CHECK(r.code == 1);
  std::istringstream lines(r.err);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    CAPTURE(line);
    CHECK(line.starts_with("{\"kind\":"));
    CHECK(line.ends_with("}"));
  }
  CHECK(count >= 2);
  CHECK(has(r.err, R"("file":"bad.pov","line":2,"column":13)"));
  CHECK(has(r.err, R"({"kind":"message","stream":"debug","text":"hi"})"));
  CHECK(has(run("--diagnostics=json --widht=3").err, R"("code":"D0603")"));
  folder.file("x.ini", "+W80\n  Widht=3\n");
  CHECK(has(run("--diagnostics=json x.ini").err, R"("file":"x.ini","line":2,"column":3)"));
  CHECK(run("--diagnostics=xml").code == 1);
}

TEST_CASE("program: dumps go to standard output, and there is no picture", "[cli][program][dump]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  const test::Run text = run("a.pov --dump-scene");
  CHECK(text.code == 0);
  CHECK(has(text.out, "type sphere"));
  CHECK(has(text.out, "a.pov:3:1"));
  CHECK_FALSE(fs::exists("a.png"));
  const test::Run json = run("a.pov --dump-scene=json");
  CHECK(json.out.starts_with("{\n"));
  CHECK(has(json.out, "\"type\": \"sphere\""));
  CHECK(run("check a.pov --dump-scene=json").out == json.out);
  CHECK(run("a.pov --dump-scene=xml").code == 1);
}

TEST_CASE("program: a header is read before the scene", "[cli][program]") {
  const test::Folder folder;
  folder.file("head.inc", "#declare Radius = 0.5;\n");
  folder.file("a.pov", "sphere { 0, Radius }\n");
  CHECK(run("check a.pov").code == 1);
  CHECK(run("check a.pov +HIhead.inc").code == 0);
  CHECK(run("check a.pov +HInowhere.inc").code == 1);
}

TEST_CASE("program: macro calls can be watched", "[cli][program][trace]") {
  const test::Folder folder;
  folder.file("a.pov", "#macro Knob(R) sphere { 0, R } #end\nKnob(2)\n");
  const test::Run r = run("check a.pov --trace-macros");
  CHECK(r.code == 0);
  CHECK(has(r.err, "Knob"));
  CHECK_FALSE(has(run("check a.pov").err, "Knob"));
}

}  // namespace durer::cli

#endif

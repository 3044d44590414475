// The program as a whole: files, streams and exit codes.
#ifdef DURER_PROGRAM

#include <fmt/format.h>

#include "cli/options.h"
#include "tests/unit/cli/program.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;

using test::has;
using test::run;
using test::Run;
using test::scene;

}  // namespace

TEST_CASE("program: a scene becomes a picture beside it", "[cli][program]") {
  const test::Folder folder;
  folder.file("a.scene", scene);
  const Run r = run("a.scene +W16 +H12");
  CAPTURE(r.err);
  CHECK(r.code == 0);
  CHECK(r.out.empty());
  CHECK(has(r.err, "hello\n"));
  CHECK(has(r.err, "assumed_gamma 1"));
  CHECK(has(r.err, "a.png: 16x12"));
  CHECK(read_file("a.png")->starts_with("\x89PNG"));
}

TEST_CASE("program: standard input and standard output", "[cli][program]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  REQUIRE(run("a.pov +W16 +H12").code == 0);
  const Run piped = run("- +O- --quiet --size 16x12 <a.pov");
  CHECK(piped.code == 0);
  CHECK((piped.out == *read_file("a.png")));
  CHECK(piped.err.empty());
}

TEST_CASE("program: errors end with 1 and write nothing", "[cli][program]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  folder.file("bad.pov", "sphere { 0, 1\n");
  for (const char* words :
       {"", "nowhere.pov", "bad.pov", "a.pov +W0", "a.pov --widht=3", "a.pov +THXX",
        "a.pov +Ono/such/folder.png", "a.pov +SC900", "a.pov +KLA"}) {
    const Run r = run(words);
    CAPTURE(words, r.err);
    CHECK(r.code == 1);
    CHECK(r.out.empty());
    CHECK(has(r.err, "error"));
    CHECK_FALSE(fs::exists("a.png"));
  }
  CHECK(has(run("bad.pov").err, "--> bad.pov:"));
}

TEST_CASE("program: options without effect leave the picture as it is", "[cli][program]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  REQUIRE(run("a.pov +W16 +H12 +A0.1 +Oplain.png").code == 0);
  std::string all = "a.pov +W16 +H12 +A0.1 +Oall.png";
  for (const Option& o : options()) {
    if (o.group != Group::no_effect) continue;
    all += fmt::format(" {}={}", o.keyword, o.form == Form::flag ? "on" : "3");
  }
  const Run r = run(all + " +WT3 +MI10 +RP2 +RS7 -B -D -P +SP64 +EP8 -UR +SU +HR");
  CAPTURE(r.err);
  CHECK(r.code == 0);
  CHECK((read_file("all.png") == read_file("plain.png")));
}

TEST_CASE("program: -F renders and writes nothing, --show draws", "[cli][program]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  const Run r = run("a.pov -F --show +W16 +H12 --quiet");
  CHECK(r.code == 0);
  CHECK(has(r.out, "▀"));
  CHECK_FALSE(fs::exists("a.png"));
  CHECK(run("a.pov +O- --show +W16 +H12 --quiet").out.starts_with("\x89PNG"));
}

TEST_CASE("program: parse says nothing about good files", "[cli][program]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  folder.file("bad.pov", "sphere { 0, 1\n");
  const Run good = run("parse a.pov a.pov");
  CHECK(good.code == 0);
  CHECK((good.out + good.err).empty());
  const Run bad = run("parse a.pov bad.pov");
  CHECK(bad.code == 1);
  CHECK(has(bad.err, "^"));
  CHECK(run("parse nowhere.pov").code == 1);
  CHECK(run("parse").code == 1);
}

TEST_CASE("program: the standard library is found, and explained", "[cli][program][doc]") {
  const test::Folder folder;
  std::string path = run("--print-stdlib-path").out;
  while (!path.empty() && path.back() == '\n') path.pop_back();
  CHECK(fs::exists(path + "/colors.inc"));
  CHECK(has(run("doc Round_Box").out, "macro of shapes.inc"));
  CHECK(has(run("doc torus agate '#while'").out, "directive"));
  const Run wrong = run("doc Round_Bax");
  CHECK(wrong.code == 1);
  CHECK(has(wrong.err, "did you mean `Round_Box`?"));
}

TEST_CASE("program: help and version go to standard output", "[cli][program]") {
  const test::Folder folder;
  CHECK(has(run("--version").out, "durer "));
  const Run help = run("--help");
  CHECK(help.code == 0);
  CHECK(has(help.out, "--antialias"));
}

TEST_CASE("program: gathered light is written, taken up, and nothing else is", "[cli][program]") {
  const test::Folder folder;
  folder.file("r.scene",
              "global_settings { radiosity { count 20 } } camera { location -4*z look_at 0 }\n"
              "light_source { <-4, 6, -5> rgb 1 } plane { y, -1 pigment { rgb 0.8 } }\n"
              "sphere { 0, 1 pigment { rgb <0.9, 0.5, 0.2> } }\n");
  folder.file("bad.rca", "P3 1 1\n");
  CHECK(run("r.scene +W16 +H12 +RFI +RFnone.rca").code == 1);
  const Run bad = run("r.scene +W16 +H12 +RFI +RFbad.rca");
  CHECK(bad.code == 1);
  CHECK(has(bad.err, "`bad.rca` is no file of gathered light"));
  CHECK_FALSE(read_file("r.png"));

  REQUIRE(run("r.scene +W16 +H12 +RFI +RFO").code == 0);  // the first frame of an animation
  const auto first = read_file("object.rca");
  REQUIRE(first);
  CHECK(first->starts_with("C"));
  REQUIRE(run("r.scene +W16 +H12 +RFI +RFO").code == 0);
  CHECK(read_file("object.rca")->size() >= first->size());

  // What gathers nothing leaves the file alone.
  const auto kept = read_file("object.rca");
  REQUIRE(run("r.scene +W16 +H12 +RFO --integrator path --samples 1").code == 0);
  CHECK((read_file("object.rca") == kept));

  const Run lost = run("r.scene +W16 +H12 +RFO +RFnowhere/a.rca");
  CHECK(lost.code == 0);  // the picture is there
  CHECK(has(lost.err, "cannot write `nowhere/a.rca`"));
}

}  // namespace durer::cli

#endif

// Animations and shell commands, by the program itself.
#ifdef DURER_PROGRAM

#include "tests/unit/cli/program.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;
using test::has;
using test::run;

constexpr const char* moving =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "camera { location -3*z look_at 0 } light_source { <5, 8, -6> 1 }\n"
    "sphere { clock*x, 1 pigment { rgb 1 } }\n"
    "#debug concat(\"clock=\", str(clock, 0, 3), \"\\n\")\n";

}  // namespace

TEST_CASE("program: one process renders all frames", "[cli][program][animation]") {
  const test::Folder folder;
  folder.file("a.pov", moving);
  const test::Run r = run("a.pov +W16 +H12 +KFF3 +GDdebug.txt");
  CAPTURE(r.err);
  CHECK(r.code == 0);
  CHECK(read_file("debug.txt") == "clock=0.000\nclock=0.500\nclock=1.000\n");
  CHECK(has(r.err, "frame 2 (2 of 3), clock 0.5"));
  CHECK((read_file("a1.png") != read_file("a3.png")));
  // The same picture as a still with that clock.
  REQUIRE(run("a.pov +W16 +H12 +K0.5 +Ostill.png").code == 0);
  CHECK((read_file("a2.png") == read_file("still.png")));
}

TEST_CASE("program: the first bad frame ends an animation", "[cli][program][animation]") {
  const test::Folder folder;
  folder.file("a.pov", std::string(moving) + "#if (clock > 0.4) #error \"too late\" #end\n");
  const test::Run r = run("a.pov +W16 +H12 +KFF3");
  CHECK(r.code == 1);
  CHECK(has(r.err, "too late"));
  CHECK(fs::exists("a1.png"));
  CHECK_FALSE(fs::exists("a2.png"));
  CHECK_FALSE(fs::exists("a3.png"));
}

TEST_CASE("program: frames to standard output follow each other", "[cli][program][animation]") {
  const test::Folder folder;
  folder.file("a.pov", moving);
  const test::Run r = run("a.pov +W4 +H3 +KFF3 +FP +O- --quiet");
  CHECK(r.code == 0);
  CHECK(r.out.size() == 3 * (std::string("P6\n4 3\n255\n").size() + 36));
}

TEST_CASE("program: shell commands see names and numbers", "[cli][program][shell]") {
  const test::Folder folder;
  folder.file("a.pov", moving);
  folder.file("a.ini",
              "Input_File_Name=a.pov\n+W16 +H12 +KFF2\n"
              "Pre_Scene_Command=echo begin %o %s >>log\n"
              "Post_Frame_Command=echo %o %n %k %wx%h >>log\n"
              "Post_Scene_Command=echo end >>log\n");
  CHECK(run("a.ini").code == 0);
  CHECK(read_file("log") == "begin a.png a\na1.png 1 0 16x12\na2.png 2 1 16x12\nend\n");
}

TEST_CASE("program: an error runs its command", "[cli][program][shell]") {
  const test::Folder folder;
  folder.file("bad.pov", "sphere {");
  CHECK(run("bad.pov 'Fatal_Error_Command=echo oh >log'").code == 1);
  CHECK(read_file("log") == "oh\n");
}

TEST_CASE("program: fields and odd lines are ignored, as in POV-Ray", "[cli][program]") {
  const test::Folder folder;
  folder.file("a.pov", moving);
  CHECK(run("a.pov +W16 +H12 +UF +UO +Ofields.png").code == 0);
  CHECK(run("a.pov +W16 +H12 +Owhole.png").code == 0);
  CHECK((read_file("fields.png") == read_file("whole.png")));
}

}  // namespace durer::cli

#endif

// What scenes of strangers cannot do.
#ifdef DURER_PROGRAM

#include "tests/unit/cli/program.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;
using test::has;
using test::run;
using test::scene;

}  // namespace

TEST_CASE("program: an untrusted run renders a good scene", "[cli][program][limits]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  const test::Run r = run("--untrusted a.pov +W16 +H12");
  CAPTURE(r.err);
  CHECK(r.code == 0);
  CHECK(read_file("a.png")->starts_with("\x89PNG"));
}

TEST_CASE("program: limits end a run with an error that names the option",
          "[cli][program][limits]") {
  const test::Folder folder;
  folder.file("loop.pov", "#while (1) #end\n");
  folder.file("macro.pov", "#macro M() M() #end M()\n");
  folder.file("include.pov", "#include \"include.pov\"\n");
  folder.file("a.pov", scene);
  for (const auto& [words, option] :
       {std::pair{"check loop.pov --max-loop-turns 1000", "max-loop-turns"},
        {"check loop.pov --max-seconds 0.2", "max-seconds"},
        {"check macro.pov --max-macro-depth 50", "max-macro-depth"},
        {"check include.pov --max-include-depth 5", "max-include-depth"},
        {"a.pov --max-pixels 1000 +W100 +H100", "Max_Pixels"},
        {"a.pov --max-frames 2 +KFF3", "Max_Frames"},
        {"a.pov --max-render-seconds 0.2 +W4000 +H4000 +A0 +R9", "Max_Render_Seconds"}}) {
    const test::Run r = run(words);
    CAPTURE(words, r.err);
    CHECK(r.code == 1);
    CHECK(has(r.err, "error[D0303]"));
    CHECK(has(r.err, option));
  }
}

#ifndef __SANITIZE_ADDRESS__  // which maps more memory than any limit
TEST_CASE("program: memory has a hard stop", "[cli][program][limits]") {
  const test::Folder folder;
  folder.file("grow.pov",
              "#declare S = \"0123456789\";\n#while (1) #declare S = concat(S, S); #end\n");
  const test::Run r = run("check grow.pov --max-memory 300");
  CAPTURE(r.err);
  CHECK(r.code == 1);
  CHECK(has(r.err, "error[D0303]"));
  CHECK(has(r.err, "emory"));
}
#endif

TEST_CASE("program: an untrusted run has no shell", "[cli][program][limits]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  folder.file("hostile.ini", "Input_File_Name=a.pov\nPre_Scene_Command=touch pwned\n");
  CHECK(run("--untrusted hostile.ini +W16 +H12").code == 1);
  folder.file("povray.ini", "Pre_Scene_Command=touch pwned\n");
  CHECK(run("--untrusted a.pov +W16 +H12").code == 1);
  CHECK_FALSE(fs::exists("pwned"));
}

TEST_CASE("program: an untrusted scene stays in its folder", "[cli][program][limits]") {
  const test::Folder folder;
  folder.file("secret.inc", "#declare Secret = 1;\n");
  folder.file("in/near.inc", "#declare Near = 1;\n");
  folder.file("in/good.pov", "#include \"near.inc\" sphere { 0, Near }\n");
  folder.file("in/read.pov", "#include \"../secret.inc\" sphere { 0, Secret }\n");
  folder.file("in/write.pov", "#fopen F \"out.txt\" write\nsphere { 0, 1 }\n");
  CHECK(run("check --untrusted in/good.pov").code == 0);
  CHECK(run("check in/read.pov").code == 0);
  CHECK(run("check --untrusted in/read.pov").code == 1);
  CHECK(run("check --untrusted in/write.pov").code == 1);
  CHECK_FALSE(fs::exists("out.txt"));
}

}  // namespace durer::cli

#endif

// The program as a whole: files, streams and exit codes.
#ifdef DURER_PROGRAM

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "cli/scene_file.h"
#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* scene =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "camera { location -3*z look_at 0 } light_source { <5, 8, -6> 1 }\n"
    "sphere { 0, 1 pigment { rgb 1 } }\n"
    "#debug \"hello\\n\"\n";

struct Run {
  int code = -1;
  std::string out, err;
};

Run run(const std::string& arguments) {
  const std::string command = std::string(DURER_PROGRAM) + " " + arguments + " >out 2>err";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file("out").value_or(""),
          read_file("err").value_or("")};
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

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
       {"", "nowhere.pov", "bad.pov", "a.pov +W0", "a.pov --widht=3", "a.pov +Q2",
        "a.pov +Ono/such/folder.png", "a.pov +SC900", "a.pov +KFI1 +KFF5"}) {
    const Run r = run(words);
    CAPTURE(words, r.err);
    CHECK(r.code == 1);
    CHECK(r.out.empty());
    CHECK(has(r.err, "error"));
    CHECK_FALSE(fs::exists("a.png"));
  }
  CHECK(has(run("bad.pov").err, "--> bad.pov:"));
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

TEST_CASE("program: help and version go to standard output", "[cli][program]") {
  const test::Folder folder;
  CHECK(has(run("--version").out, "durer "));
  const Run help = run("--help");
  CHECK(help.code == 0);
  CHECK(has(help.out, "--antialias"));
}

TEST_CASE("program: interrupted, it ends with 2 and leaves the older picture", "[cli][program]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  folder.file("a.png", "older");
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(::open("err", O_WRONLY | O_CREAT, 0666), STDERR_FILENO);
    ::execl(DURER_PROGRAM, "durer", "a.pov", "+W8000", "+H8000", "+A0", "+R9", nullptr);
    ::_exit(127);
  }
  for (int wait = 0; wait < 1000 && !has(read_file("err").value_or(""), "assumed_gamma"); ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // until the render has begun
  }
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 2);
  CHECK(read_file("a.png") == "older");
  CHECK(std::distance(fs::directory_iterator("."), {}) == 3);  // scene, picture, messages
}

}  // namespace durer::cli

#endif

// +C and interruptions, by the program itself.
#ifdef DURER_PROGRAM

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/unit/cli/program.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;
using test::has;
using test::run;
using test::scene;

/// Starts a render, interrupts it `wait` after it began, and returns its exit code.
int interrupted_run(std::vector<std::string> words, std::chrono::milliseconds wait) {
  words.insert(words.begin(), "durer");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  fs::remove("err");
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(::open("err", O_WRONLY | O_CREAT, 0666), STDERR_FILENO);
    ::execv(DURER_PROGRAM, arguments.data());
    ::_exit(127);
  }
  for (int i = 0; i < 1000 && !has(read_file("err").value_or(""), "assumed_gamma"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // until the render has begun
  }
  std::this_thread::sleep_for(wait);
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("program: interrupted, it ends with 2 and leaves the older picture", "[cli][program]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  folder.file("a.png", "older");
  CHECK(interrupted_run({"a.pov", "+W4000", "+H4000", "+A0", "+R9"}, {}) == 2);
  CHECK(read_file("a.png") == "older");
  CHECK(fs::exists("a.png.state"));
  CHECK(std::distance(fs::directory_iterator("."), {}) == 4);  // scene, picture, state, messages
}

TEST_CASE("program: a picture taken up again is the same to the last bit",
          "[cli][program][continue]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  const std::vector<std::string> words = {"a.pov", "+W800", "+H600", "+A0", "+R5"};
  const std::string line = "a.pov +W800 +H600 +A0 +R5";
  REQUIRE(interrupted_run(words, std::chrono::milliseconds(100)) == 2);
  REQUIRE(fs::exists("a.png.state"));
  CHECK_FALSE(fs::exists("a.png"));
  CHECK(run(line + " +C").code == 0);
  CHECK_FALSE(fs::exists("a.png.state"));
  REQUIRE(run(line + " +Owhole.png").code == 0);
  CHECK((read_file("a.png") == read_file("whole.png")));
}

TEST_CASE("program: a stopped picture of random paths is a noisy one", "[cli][program][continue]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  const std::vector<std::string> words = {"a.pov", "Size=64x48", "Integrator=path", "--samples=3000"};
  REQUIRE(interrupted_run(words, std::chrono::milliseconds(300)) == 2);
  CHECK(fs::exists("a.png.state"));
  CHECK(fs::exists("a.png"));
  CHECK(has(read_file("err").value_or(""), "of 3000 samples per pixel; `+C` takes up"));
  const std::string line = "a.pov Size=64x48 Integrator=path --samples=3000";
  CHECK(run("a.pov Size=64x48 +C").code == 1);  // belongs to other options
  CHECK(run(line + " +C").code == 0);
  CHECK_FALSE(fs::exists("a.png.state"));
  REQUIRE(run(line + " +Owhole.png").code == 0);
  CHECK((read_file("a.png") == read_file("whole.png")));
}

TEST_CASE("program: a state of other options or another scene is refused",
          "[cli][program][continue]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  REQUIRE(interrupted_run({"a.pov", "+W4000", "+H4000", "+A0", "+R9"}, {}) == 2);
  const test::Run other = run("a.pov +W16 +H12 +C");
  CHECK(other.code == 1);
  CHECK(has(other.err, "a.png.state` belongs to another scene or other options"));
  CHECK(has(other.err, "help: remove that file"));
  CHECK(fs::exists("a.png.state"));
  CHECK(run("a.pov +W16 +H12").code == 0);  // without +C it is rendered anew
  CHECK_FALSE(fs::exists("a.png.state"));
}

TEST_CASE("program: +C skips pictures that are there", "[cli][program][continue]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  folder.file("a1.png", "done");
  folder.file("a2.png", "");
  const test::Run r = run("a.pov +W16 +H12 +KFF3 +C");
  CHECK(r.code == 0);
  CHECK(has(r.err, "a1.png is already rendered"));
  CHECK(read_file("a1.png") == "done");
  CHECK(read_file("a2.png")->starts_with("\x89PNG"));
  CHECK(fs::exists("a3.png"));
  const test::Run again = run("a.pov +W16 +H12 +KFF3 --continue");
  CHECK(has(again.err, "a3.png is already rendered"));
  folder.file("a.png", "done");
  CHECK(run("a.pov +W16 +H12 +C").code == 0);
  CHECK(read_file("a.png") == "done");
}

TEST_CASE("program: an interruption runs its command", "[cli][program][shell]") {
  const test::Folder folder;
  folder.file("a.pov", scene);
  CHECK(interrupted_run(
            {"a.pov", "+W4000", "+H4000", "+A0", "+R9", "User_Abort_Command=echo %o >log"}, {}) ==
        2);
  CHECK(read_file("log") == "a.png\n");
}

}  // namespace durer::cli

#endif

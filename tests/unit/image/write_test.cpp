#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "tests/unit/image/read_back.h"

namespace durer::image {
namespace {

using test::plain;

const Format& png() { return *format_named("png"); }

/// Runs `task` in a child process, which shares no limits and signals with the tests.
template <typename Task>
int in_child(const Task& task) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(task());
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

}  // namespace

TEST_CASE("write: a folder that is not there is named with the reason", "[image][write]") {
  const test::Folder folder;
  const std::string path = folder / "missing/a.png";
  const auto error = write(plain(2, 2, 1, 1, 1), path, png(), {});
  REQUIRE(error);
  CHECK(error->find(path) != std::string::npos);
  CHECK(error->find("No such file or directory") != std::string::npos);
  CHECK(folder.files() == 0);
}

TEST_CASE("write: a folder in the place of the file is an error", "[image][write]") {
  const test::Folder folder;
  std::filesystem::create_directory(folder / "a.png");
  const auto error = write(plain(2, 2, 1, 1, 1), folder / "a.png", png(), {});
  REQUIRE(error);
  CHECK(error->find("folder") != std::string::npos);
  CHECK(folder.files() == 1);
}

TEST_CASE("write: every format reports an unwritable path", "[image][write]") {
  for (const Format* f : formats()) {
    CAPTURE(f->name);
    CHECK(write(plain(8, 2, 1, 1, 1), "/proc/no-such-file", *f, {}));
  }
}

TEST_CASE("write: a picture without pixels is an error, not a crash", "[image][write]") {
  const test::Folder folder;
  const auto error = write(Image(), folder / "a.png", png(), {});
  CHECK(error);
  CHECK(folder.files() == 0);
}

TEST_CASE("write: an older picture is replaced and nothing else is left", "[image][write]") {
  const test::Folder folder;
  REQUIRE_FALSE(write(plain(2, 2, 1, 1, 1), folder / "a.png", png(), {}));
  REQUIRE_FALSE(write(plain(5, 3, 0, 0, 0), folder / "a.png", png(), {}));
  CHECK(test::read_back(folder / "a.png").width == 5);
  CHECK(folder.files() == 1);
}

TEST_CASE("write: a link stays a link and its target is replaced", "[image][write]") {
  const test::Folder folder;
  REQUIRE_FALSE(write(plain(2, 2, 1, 1, 1), folder / "a.png", png(), {}));
  std::filesystem::create_symlink(folder / "a.png", folder / "link.png");
  REQUIRE_FALSE(write(plain(5, 3, 0, 0, 0), folder / "link.png", png(), {}));
  CHECK(std::filesystem::is_symlink(folder / "link.png"));
  CHECK(test::read_back(folder / "a.png").width == 5);
}

TEST_CASE("write: the umask decides who may read the file", "[image][write]") {
  const test::Folder folder;
  const std::string path = folder / "a.png";
  const int status = in_child([&] {
    ::umask(027);
    return write(plain(2, 2, 1, 1, 1), path, png(), {}) ? 1 : 0;
  });
  REQUIRE(status == 0);
  struct stat s {};
  REQUIRE(::stat(path.c_str(), &s) == 0);
  CHECK((s.st_mode & 0777) == 0640);
}

TEST_CASE("write: a full disk leaves the older picture and no part of the new one",
          "[image][write]") {
  const test::Folder folder;
  const std::string path = folder / "a.ppm";
  const Format& ppm = *format_named("ppm");
  REQUIRE_FALSE(write(plain(2, 2, 1, 1, 1), path, ppm, {}));
  const int status = in_child([&] {  // a limit on the size of files stands for the full disk
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto error = write(plain(200, 200, 1, 1, 1), path, ppm, {});
    return error && error->find("File too large") != std::string::npos ? 0 : 1;
  });
  CHECK(status == 0);
  CHECK(test::read_back(path).width == 2);
  CHECK(folder.files() == 1);
}

TEST_CASE("write: killed half-way, the picture under its name is still the whole old one",
          "[image][write]") {
  const test::Folder folder;
  const std::string path = folder / "a.ppm";
  const Format& ppm = *format_named("ppm");
  REQUIRE_FALSE(write(plain(2, 2, 1, 1, 1), path, ppm, {}));
  const int status = in_child([&] {  // SIGXFSZ kills in the middle of the data
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::signal(SIGXFSZ, SIG_DFL);
    return write(plain(200, 200, 1, 1, 1), path, ppm, {}) ? 1 : 0;
  });
  REQUIRE(WIFSIGNALED(status));
  CHECK(test::read_back(path).width == 2);
}

TEST_CASE("write: `-` sends the whole file to standard output", "[image][write]") {
  const test::Folder folder;
  REQUIRE_FALSE(write(plain(9, 2, .2F, .5F, .8F), folder / "a.png", png(), {}));
  const std::string piped = folder / "piped.png";
  const int status = in_child([&] {
    const int fd = ::open(piped.c_str(), O_WRONLY | O_CREAT, 0666);
    ::dup2(fd, STDOUT_FILENO);
    return write(plain(9, 2, .2F, .5F, .8F), "-", png(), {}) ? 1 : 0;
  });
  REQUIRE(status == 0);
  CHECK(test::bytes_of(piped) == test::bytes_of(folder / "a.png"));
}

TEST_CASE("write: what could not be written is known beforehand", "[image][write]") {
  const test::Folder folder;
  CHECK_FALSE(probe(folder / "a.png"));
  CHECK_FALSE(probe("-"));
  CHECK_FALSE(probe(""));
  CHECK_FALSE(probe("/dev/null"));
  CHECK(probe(folder / "missing/a.png"));
  CHECK(probe(folder / "."));
  CHECK(folder.files() == 0);
}

TEST_CASE("write: a device is written, not replaced", "[image][write]") {
  REQUIRE_FALSE(write(plain(9, 2, 1, 1, 1), "/dev/null", png(), {}));
  CHECK(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace durer::image

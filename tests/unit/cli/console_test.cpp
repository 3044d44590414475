#include "cli/console.h"

#include "cli/scene_file.h"
#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

Settings with_files(std::vector<std::string> words) {
  words.insert(words.begin(), "-GA");  // the tests' own output stays clean
  return test::accepted(words);
}

}  // namespace

TEST_CASE("console: streams are copied to their files and to the file of all", "[cli][console]") {
  const test::Folder folder;
  std::string problem;
  {
    Console console(with_files({"Debug_File=d.txt", "All_File=all.txt"}), problem);
    console.print(Stream::debug, "one\n");
    console.print(Stream::warning, "two\n");
  }
  CHECK(problem.empty());
  CHECK(read_file("d.txt") == "one\n");
  CHECK(read_file("all.txt") == "one\ntwo\n");
  {
    Console console(with_files({"Debug_File=d.txt", "+GP"}), problem);
    console.print(Stream::debug, "three\n");
  }
  CHECK(read_file("d.txt") == "one\nthree\n");
}

TEST_CASE("console: a file that cannot be written is named", "[cli][console]") {
  std::string problem;
  const Console console(with_files({"Fatal_File=/no/such/folder/x"}), problem);
  CHECK(problem.find("/no/such/folder/x") != std::string::npos);
}

TEST_CASE("console: quiet leaves the errors", "[cli][console]") {
  std::string problem;
  const Console console(test::accepted({"--quiet"}), problem);
  CHECK(console.speaks(Stream::fatal));
  for (const Stream s : {Stream::debug, Stream::render, Stream::statistic, Stream::warning}) {
    CHECK_FALSE(console.speaks(s));
  }
}

}  // namespace durer::cli

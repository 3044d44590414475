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

TEST_CASE("console: diagnostics go to two streams, without colours in files", "[cli][console]") {
  const test::Folder folder;
  const SourceMap sources;
  Diagnostics all(sources);
  for (const Severity severity : {Severity::warning, Severity::error, Severity::note}) {
    Diagnostic d;
    d.severity = severity;
    d.message = "m";
    all.report(d);
  }
  std::string problem;
  for (const char* level : {"+WL10", "+WL5", "+WL0"}) {
    Console(with_files({"Fatal_File=f.txt", "Warning_File=w.txt", level}), problem).print(all);
    CHECK(read_file("f.txt") == "error[D0101]: m\n");
    const bool none = std::string(level) == "+WL0";
    CHECK(read_file("w.txt") == (none ? "" : "warning[D0101]: m\nnote[D0101]: m\n"));
  }
  CHECK(Console(with_files({"Fatal_File=f.txt"}), problem).fail(Code::option, "x", "y") == 1);
  CHECK(read_file("f.txt")->starts_with("error[D0603]: x\n"));
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

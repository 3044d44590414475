#include "cli/limits.h"

#include "tests/unit/cli/read.h"

namespace durer::cli {

TEST_CASE("limits: a trusted run has few", "[cli][limits]") {
  const RunLimits l = limits_of(test::accepted({}));
  CHECK(l.reading.macro_depth == 1000);
  CHECK(l.reading.include_depth == 100);
  CHECK(l.reading.loop_turns == 0);
  CHECK(l.reading.seconds == 0);
  CHECK(l.reading.memory == 0);
  CHECK(l.render_seconds == 0);
  CHECK(l.pixels == 0);
  CHECK(l.frames == 0);
}

TEST_CASE("limits: an untrusted run has all of them", "[cli][limits]") {
  const RunLimits l = limits_of(test::accepted({"--untrusted"}));
  CHECK(l.reading.macro_depth == 200);
  CHECK(l.reading.include_depth == 20);
  CHECK(l.reading.loop_turns == 10'000'000);
  CHECK(l.reading.seconds == 30);
  CHECK(l.reading.memory == std::size_t{4096} << 20);
  CHECK(l.render_seconds == 600);
  CHECK(l.pixels == 40e6);
  CHECK(l.frames == 10'000);
}

TEST_CASE("limits: each has an option, which wins in either order", "[cli][limits]") {
  const std::vector<std::string> own = {"--max-macro-depth=7",      "--max-include-depth=8",
                                        "--max-loop-turns=1e9",     "--max-seconds=0.5",
                                        "--max-render-seconds=1.5", "--max-memory=100",
                                        "--max-pixels=1000",        "--max-frames=3"};
  for (const bool first : {true, false}) {
    std::vector<std::string> words = own;
    words.insert(first ? words.begin() : words.end(), "--untrusted");
    const RunLimits l = limits_of(test::accepted(words));
    CHECK(l.reading.macro_depth == 7);
    CHECK(l.reading.include_depth == 8);
    CHECK(l.reading.loop_turns == 1'000'000'000);
    CHECK(l.reading.seconds == 0.5);
    CHECK(l.reading.memory == std::size_t{100} << 20);
    CHECK(l.render_seconds == 1.5);
    CHECK(l.pixels == 1000);
    CHECK(l.frames == 3);
  }
  for (const char* keyword : {"Max_Macro_Depth", "Max_Seconds", "Max_Memory", "Max_Frames"}) {
    test::refused({std::string(keyword) + "=0"});
    test::refused({std::string(keyword) + "=x"});
  }
}

TEST_CASE("limits: size and frames are checked before work begins", "[cli][limits]") {
  const auto problem = [](const std::vector<std::string>& words) {
    return check_extent(test::accepted(words)).value_or("");
  };
  CHECK(problem({"+W65535", "+H65535"}).empty());
  CHECK(problem({"--untrusted", "+W7680", "+H4320", "+KFF10000"}).empty());
  CHECK(problem({"--untrusted", "+W10000", "+H10000"}).find("Max_Pixels") != std::string::npos);
  CHECK(problem({"--untrusted", "+KFF10001"}).find("Max_Frames") != std::string::npos);
}

TEST_CASE("limits: untrusted runs have no shell commands and no way back", "[cli][limits]") {
  CHECK(check_untrusted(test::accepted({"--untrusted", "Pre_Frame_Command=ls"})));
  CHECK(check_untrusted(test::accepted({"Fatal_Error_Command=ls", "--untrusted"})));
  CHECK_FALSE(check_untrusted(test::accepted({"Fatal_Error_Command=ls"})));
  CHECK(test::refused({"--untrusted", "Untrusted=off"}).find("trusted") != std::string::npos);
  test::accepted({"Untrusted=off"});
}

TEST_CASE("limits: INI files cannot widen an untrusted run", "[cli][limits][ini]") {
  const test::Folder folder;
  for (const char* line :
       {"Output_File_Name=/tmp/x.png", "+O/tmp/x.png", "Library_Path=/", "Create_Ini=x.ini",
        "Debug_File=x", "+GAx", "Max_Seconds=1e9", "Max_Memory=1e9", "Max_Pixels=1e12"}) {
    CAPTURE(line);
    folder.file("hostile.ini", line);
    CHECK(check_untrusted(test::accepted({"--untrusted", "hostile.ini"})));
    CHECK(check_untrusted(test::accepted({"hostile.ini", "--untrusted"})));
    CHECK_FALSE(check_untrusted(test::accepted({"hostile.ini"})));
    CHECK_FALSE(check_untrusted(test::accepted({"--untrusted", line})));
  }
  folder.file("good.ini", "+W80 +H60 +A0.3\nFinal_Frame=3");
  CHECK_FALSE(check_untrusted(test::accepted({"--untrusted", "good.ini"})));
}

}  // namespace durer::cli

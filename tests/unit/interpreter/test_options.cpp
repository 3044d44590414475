#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "support.h"
#include "tests/support/catch.h"

using namespace durer::interpreter;
using namespace durer::interpreter::test;
namespace fs = std::filesystem;

namespace {

/// A folder of its own for each test, gone at its end.
struct Folder {
  fs::path path;
  Folder() {
    static int count = 0;
    path = fs::temp_directory_path() / fmt::format("durer-options-{}-{}", getpid(), count++);
    fs::create_directories(path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    fs::create_directories((path / name).parent_path());
    std::ofstream(path / name) << text;
    return (path / name).string();
  }
};

std::string first(const std::vector<std::string>& list) { return list.empty() ? "" : list.front(); }

}  // namespace

TEST_CASE("options: the numbers of a frame have six digits", "[interpreter][options]") {
  Options o;
  o.frame = {7, 1, 12, 0.0, 1.0 / 3, 1.0 / 7};
  o.clock = 0.123456789F;
  o.clock_on = true;
  const Run r = run("#debug concat(str(frame_number,0,0),\" \",str(initial_frame,0,0),\" \","
                    "str(final_frame,0,0),\" \",str(initial_clock,0,9),\" \",str(final_clock,0,9),"
                    "\" \",str(clock_delta,0,9),\" \",str(clock,0,9),\" \",str(clock_on,0,0))",
                    true, o);
  CHECK(r.debug == "7 1 12 0.000000000 0.333333000 0.142857000 0.123456791 1");
}

TEST_CASE("options: a declared name wins over a predefined one", "[interpreter][options]") {
  Options o;
  o.declares = {{"frame_number", 3.0}, {"frame_number", 4.0}, {"Who", std::string("me")}};
  CHECK(run("#debug concat(str(frame_number,0,0), Who)", true, o).debug == "3me");
}

TEST_CASE("options: the header file is read before the scene", "[interpreter][options]") {
  const Folder folder;
  Options o;
  o.header_file = folder.write("head.inc", "#declare H = 5; #local L = 6;");
  CHECK(run("#debug concat(str(H,0,0), str(defined(L),0,0))", true, o).debug == "50");
  o.header_file = (folder.path / "none.inc").string();
  CHECK(first(run("", true, o).errors).starts_with("D0601"));
}

TEST_CASE("options: includes nest as deep as the limit says", "[interpreter][options]") {
  const Folder folder;
  const std::string self = folder.write("self.inc", "#declare N = N + 1;\n#include \"self.inc\"\n");
  Options o;
  o.limits.include_depth = 5;
  const Run r = run("#declare N = 0;\n#include \"self.inc\"", true, o, folder.path / "main.pov");
  CHECK(first(r.errors).starts_with("D0303 at 1:10: files include each other too deeply"));
  CHECK(first(r.help).find("5 files") != std::string::npos);
}

TEST_CASE("options: a confined scene reads below its folder and the library",
          "[interpreter][options]") {
  const Folder scene;
  const Folder library;
  const Folder outside;
  const std::string main = scene.path / "main.pov";
  (void)scene.write("own.inc", "#debug \"own \"");
  (void)scene.write("parts/part.inc", "#debug \"part \"");
  (void)library.write("lib.inc", "#debug \"lib \"");
  const std::string secret = outside.write("secret.inc", "#debug \"secret\"");
  fs::create_symlink(secret, scene.path / "link.inc");
  Options o;
  o.confined = true;
  o.include_paths = {library.path};
  CHECK(run("#include \"own.inc\" #include \"parts/part.inc\" #include \"lib.inc\"", true, o, main)
            .debug == "own part lib ");
  const std::string up = "../" + outside.path.filename().string() + "/secret.inc";
  for (const std::string& name : {secret, up, std::string("link.inc")}) {
    const Run include = run("#include \"" + name + "\"", true, o, main);
    CHECK(first(include.errors).starts_with("D0605 at 1:10: this scene may not read"));
    CHECK(first(run("#fopen F \"" + name + "\" read", true, o, main).errors).starts_with("D0605"));
    CHECK(run("#debug str(file_exists(\"" + name + "\"),0,0)", true, o, main).debug == "0");
  }
  o.confined = false;
  CHECK(run("#include \"link.inc\"", true, o, main).debug == "secret");
}

TEST_CASE("options: a confined scene writes named files only", "[interpreter][options]") {
  const Folder scene;
  const std::string main = scene.path / "main.pov";
  const std::string named = scene.path / "named.txt";
  const std::string other = scene.path / "other.txt";
  Options o;
  o.confined = true;
  o.writable = {named};
  for (const std::string mode : {"write", "append"}) {
    CHECK(run("#fopen F \"" + named + "\" " + mode, true, o, main).errors.empty());
    CHECK(first(run("#fopen F \"" + other + "\" " + mode, true, o, main).errors)
              .starts_with("D0605 at 1:1: this scene may not write to"));
  }
  CHECK(fs::exists(named));
  CHECK_FALSE(fs::exists(other));
}

TEST_CASE("options: an include may open what its includer closes", "[interpreter][options]") {
  const Folder folder;
  (void)folder.write("open.inc", "union { sphere { 0, 1 }");
  (void)folder.write("close.inc", "translate x }");
  const Run r = run("#include \"open.inc\"\nsphere { x, 1 } translate y }\n"
                    "union { sphere { 0, 1 } sphere { x, 1 }\n#include \"close.inc\"\n",
                    true, {}, folder.path / "main.pov");
  CHECK(first(r.errors).empty());
  REQUIRE(r.scene);
  CHECK(r.scene->roots.size() == 2);
  CHECK(first(run("#include \"open.inc\"", true, {}, folder.path / "main.pov").errors) ==
        "D0201 at 1:20: expected a modifier or `}`, found the end");
}

TEST_CASE("options: a missing file names a near one", "[interpreter][options]") {
  const Folder folder;
  (void)folder.write("colours.inc", "");
  const Run r = run("#include \"colour.inc\"", true, {}, folder.path / "main.pov");
  CHECK(first(r.errors) == "D0601 at 1:10: cannot find the file `colour.inc`");
  CHECK(first(r.help) == "did you mean `\"colours.inc\"`?");
}

TEST_CASE("options: every macro call and return is told", "[interpreter][options]") {
  std::vector<std::string> lines;
  Options o;
  o.on_trace = [&](std::string_view line) { lines.emplace_back(line); };
  CHECK(run("#macro Inner(S, A) #debug S #end\n"
            "#macro Outer(X) Inner(\"a rather long text without end\", array[2]{1,2}) X*2 #end\n"
            "#declare V = Outer(<1,2,3>);",
            true, o)
            .errors.empty());
  REQUIRE(lines.size() == 4);
  CHECK(lines[0] == "1 Outer(<1,2,3>) at test.pov:4");
  CHECK(lines[1] == "  2 Inner(\"a rather long text witho…\", array[2]) at test.pov:3");
  CHECK(lines[2] == "  2 end of Inner");
  CHECK(lines[3] == "1 end of Outer");
}

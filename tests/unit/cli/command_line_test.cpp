#include "cli/command_line.h"

#include <fstream>
#include <iterator>

#include "cli/help.h"
#include "tests/unit/cli/read.h"

namespace durer::cli {

using test::accepted;
using test::read;
using test::refused;

TEST_CASE("command line: bare words are scenes, folders or INI files", "[cli][words]") {
  const test::Folder folder;
  folder.file("small.ini", "Width=20\n");
  Settings s = accepted({"scenes/Desk.POV"});
  CHECK(s.input == "scenes/Desk.POV");
  CHECK(accepted({"a.scene"}).input == "a.scene");
  CHECK(accepted({"-"}).input == "-");
  CHECK(accepted({"+I-", "+O-"}).output == "-");
  CHECK(accepted({"textures/"}).library_paths == std::vector<std::string>{"textures/"});
  CHECK(accepted({"small"}).width == 20);
  CHECK(refused({"no-such"}).find("there is no INI file `no-such`") != std::string::npos);
}

TEST_CASE("command line: settings act in their order, whatever their form", "[cli][words]") {
  CHECK(accepted({"+W1", "--width=2", "Width=3"}).width == 3);
  CHECK(accepted({"Width=3", "+W1", "--width", "2"}).width == 2);
  CHECK(accepted({"--size=7x8", "+H9"}).height == 9);
  CHECK(accepted({"--antialias", "-A"}).antialias == false);
  CHECK(accepted({"-A", "--antialias=0.1"}).aa_threshold == 0.1);
  CHECK(accepted({"-A", "--antialias=0.1"}).antialias);
  const Settings s = accepted({"+Lone", "--include-path", "two", "Library_Path=three"});
  CHECK(s.library_paths == std::vector<std::string>{"one", "two", "three"});
}

TEST_CASE("command line: values keep blanks, brackets, equals signs and dashes", "[cli][words]") {
  CHECK(accepted({"+Ia b=c.pov"}).input == "a b=c.pov");
  CHECK(accepted({"+O-x.png"}).output == "-x.png");
  CHECK(accepted({"--output", "-"}).output == "-");
  CHECK(accepted({"--output", "[a,b].png"}).output == "[a,b].png");
  CHECK(accepted({"--output", "+Wx.png"}).output == "+Wx.png");
  CHECK(accepted({"+I\"my scene.pov\""}).input == "my scene.pov");
  CHECK(accepted({"--", "-A0.1"}).aa_threshold == 0.1);
}

TEST_CASE("command line: a command is the first word that is no option", "[cli][words]") {
  CHECK(first_bare_word({"check", "a.pov"}) == 0);
  CHECK(first_bare_word({"+W80", "--size", "8x6", "Height=9", "check"}) == 4);
  CHECK(first_bare_word({"--quiet", "check"}) == 1);
  CHECK(first_bare_word({"-"}) == 1);  // standard input
  CHECK(first_bare_word({}) == 0);
}

TEST_CASE("command line: help and version are asked for, not rendered", "[cli][words]") {
  CHECK(read({"--help"}).request == Request::help);
  CHECK(read({"+W80", "--version"}).request == Request::version);
  CHECK(read({"--print-stdlib-path"}).request == Request::stdlib_path);
  CHECK(read({"a.pov"}).request == Request::render);
}

TEST_CASE("command line: unknown words come with the nearest known one", "[cli][words]") {
  CHECK(refused({"--widht=3"}).find("did you mean `--width`?") != std::string::npos);
  CHECK(refused({"--antialas"}).find("did you mean `--antialias`?") != std::string::npos);
  CHECK(refused({"Widht=3"}).find("did you mean `Width`?") != std::string::npos);
  CHECK(refused({"-zW30"}).find("did you mean `-W`?") != std::string::npos);
  CHECK(refused({"+ZZ"}).find("there is no switch `+ZZ`") != std::string::npos);
  CHECK(refused({"--zzzzzz"}).find("there is no option `--zzzzzz`") != std::string::npos);
}

TEST_CASE("command line: GNU names with one dash are recognised as a slip", "[cli][words]") {
  CHECK(refused({"-size=3x4"}).find("did you mean `--size`?") != std::string::npos);
  CHECK(refused({"-help"}).find("did you mean `--help`?") != std::string::npos);
  CHECK(refused({"-output"}).find("did you mean `--output`?") != std::string::npos);
}

TEST_CASE("command line: missing and surplus values are errors", "[cli][words]") {
  CHECK(refused({"+W"}).find("attached") != std::string::npos);
  refused({"-o"});
  refused({"+UA1"});
  refused({"+QR"});
  refused({"--width"});
  refused({"--width=many"});
  refused({"--alpha=perhaps"});
  refused({"Antialias=maybe"});
}

TEST_CASE("command line: the help names every option", "[cli][help]") {
  const std::string help = help_text();
  const std::string page = help_markdown();
  for (const Option& o : options()) {
    CAPTURE(o.keyword);
    CHECK(help.find(std::string(o.keyword) + "=") != std::string::npos);
    CHECK(page.find("`" + std::string(o.keyword) + "=") != std::string::npos);
    if (!o.long_name.empty())
      CHECK(help.find("--" + std::string(o.long_name)) != std::string::npos);
  }
  for (const char* word : {"Exit codes", "POVINI", "--version", "durer parse"}) {
    CHECK(help.find(word) != std::string::npos);
  }
}

TEST_CASE("command line: docs/command-line.md is what --help-markdown prints", "[cli][help]") {
  std::ifstream in(DURER_DOCS "/command-line.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  INFO("renew it: durer --help-markdown > docs/command-line.md");
  CHECK((page == help_markdown()));
}

}  // namespace durer::cli

#include "tests/unit/cli/read.h"

namespace durer::cli {

using test::accepted;
using test::read;
using test::refused;

TEST_CASE("ini: keywords, switches and comments", "[cli][ini]") {
  const test::Folder folder;
  folder.file("a.ini",
              "; a comment\n"
              "# another\n"
              "  Width = 80 ; behind a value\r\n"
              "HEIGHT='60' # likewise\n"
              "+A0.1\t-J0.5 Declare=X=3\n"
              "Output_File_Name=\"my #1; picture.png\"\n"
              "\n"
              "antialias_depth=4");
  const Settings s = accepted({"a.ini"});
  CHECK(s.width == 80);
  CHECK(s.height == 60);
  CHECK(s.aa_threshold == 0.1);
  CHECK(s.jitter_amount == 0.5);
  CHECK(s.declares.size() == 1);
  CHECK(s.output == "my #1; picture.png");
  CHECK(s.aa_depth == 4);
}

TEST_CASE("ini: words with blanks stand in quotes", "[cli][ini]") {
  const test::Folder folder;
  folder.file("a.ini", "+I\"my scene.pov\" +W33\n\"other size.ini\"\n");
  folder.file("other size.ini", "+H22");
  const Settings s = accepted({"a"});
  CHECK(s.input == "my scene.pov");
  CHECK(s.width == 33);
  CHECK(s.height == 22);
}

TEST_CASE("ini: lines before the first header always count, a section when named", "[cli][ini]") {
  const test::Folder folder;
  folder.file(
      "a.ini",
      "Width=80\nHeight=60\n[Big]\nWidth=200\n[ small size ]\nWidth=20\n[big]\nHeight=99\n");
  CHECK(accepted({"a.ini"}).width == 80);
  CHECK(accepted({"a[BIG]"}).width == 200);
  CHECK(accepted({"a[BIG]"}).height == 99);
  CHECK(accepted({"a.ini[small size]"}).width == 20);
  CHECK(accepted({"a[none]"}).width == 80);
}

TEST_CASE("ini: files name further files", "[cli][ini]") {
  const test::Folder folder;
  folder.file("a.ini", "Width=90\nb.ini[x]\nInclude_Ini=c\n");
  folder.file("b.ini", "Height=1\n[x]\nHeight=33\n");
  folder.file("c.ini", "+R5");
  const Settings s = accepted({"a"});
  CHECK(s.width == 90);
  CHECK(s.height == 33);
  CHECK(s.aa_depth == 5);
  CHECK(accepted({"--ini", "b[x]"}).height == 33);
}

TEST_CASE("ini: a circle of files ends with an error", "[cli][ini]") {
  const test::Folder folder;
  folder.file("a.ini", "b\n");
  folder.file("b.ini", "a\n");
  CHECK(refused({"a"}).find("nested") != std::string::npos);
}

TEST_CASE("ini: library folders are searched", "[cli][ini]") {
  const test::Folder folder;
  folder.file("lib/a.ini", "Width=70\n");
  CHECK(accepted({"+Llib", "a"}).width == 70);
  refused({"a"});
}

TEST_CASE("ini: errors name the file and the line", "[cli][ini]") {
  const test::Folder folder;
  folder.file("a.ini", "Width=80\n  Widht=60\nAntialias=maybe\n");
  const auto r = read({"a.ini"});
  REQUIRE(r.errors.size() == 2);
  CHECK(r.errors[0].find("did you mean `Width`?") != std::string::npos);
  CHECK(r.places[0].path == "a.ini");
  CHECK(r.places[0].line == 2);
  CHECK(r.places[0].column == 3);
  CHECK(r.places[1].line == 3);
}

TEST_CASE("ini: two settings on a line are not silently one", "[cli][ini]") {
  const test::Folder folder;
  folder.file("a.ini", "Width=80 Height=60\n");
  CHECK(refused({"a"}).find("80 Height=60") != std::string::npos);
}

TEST_CASE("ini: one default file is read, POVINI before ./povray.ini", "[cli][ini]") {
  const test::Folder folder;
  folder.file("povray.ini", "Width=11\nHeight=12\n");
  folder.file("mine.ini", "Width=21\n");
  CHECK(read({}, "").settings.width == 11);
  CHECK(read({}, "mine.ini").settings.width == 21);
  CHECK(read({}, "mine.ini").settings.height == 600);
  CHECK(read({"+W5"}, "mine.ini").settings.width == 5);
  const auto missing = read({}, "nowhere.ini");
  CHECK(missing.settings.width == 11);
  REQUIRE(missing.warnings.size() == 1);
  CHECK(missing.warnings[0].find("nowhere.ini") != std::string::npos);
}

}  // namespace durer::cli

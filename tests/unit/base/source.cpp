#include "base/source.h"

#include <filesystem>
#include <fstream>

#include "tests/support/catch.h"

using namespace durer;

TEST_CASE("source: places count lines and columns from one", "[base][source]") {
  SourceMap sources;
  const FileId file = sources.add("a.pov", "one\ntwo\r\nthree");
  const Loc base = sources.base(file);
  const auto at = [&](Loc offset) {
    const Place p = sources.place(base + offset);
    return std::pair(p.line, p.column);
  };
  CHECK(at(0) == std::pair(1U, 1U));
  CHECK(at(3) == std::pair(1U, 4U));
  CHECK(at(4) == std::pair(2U, 1U));
  CHECK(at(9) == std::pair(3U, 1U));
  CHECK(at(14) == std::pair(3U, 6U));  // the end of the file is a place
  CHECK(sources.line_at(base + 5) == "two");
  CHECK(sources.line_at(base + 14) == "three");
}

TEST_CASE("source: files keep apart in the virtual text", "[base][source]") {
  SourceMap sources;
  const FileId a = sources.add("a", "abc");
  const FileId empty = sources.add("empty", "");
  const FileId b = sources.add("b", "de");
  CHECK(sources.file_of(sources.base(a) + 3) == a);
  CHECK(sources.file_of(sources.base(empty)) == empty);
  CHECK(sources.file_of(sources.base(b)) == b);
  CHECK(sources.place(sources.base(empty)).path == "empty");
  CHECK(sources.line_at(sources.base(empty)).empty());
  CHECK(sources.text(Span{sources.base(b), 2}) == "de");
}

TEST_CASE("source: a text that rests is read again for a message", "[base][source]") {
  const auto folder = std::filesystem::temp_directory_path() / "durer-source-test";
  std::filesystem::create_directories(folder);
  const std::string path = folder / "scene.inc";
  const std::string text = "one\ntwo\nthree\n";
  std::ofstream(path) << text;
  SourceMap sources;
  const FileId inc = sources.add(path, text);
  const FileId typed = sources.add("standard input", "abc\ndef");
  const Loc two = sources.base(inc) + 5;
  sources.rest(0);
  CHECK(sources.place(two).line == 2);
  CHECK(sources.place(two).column == 2);
  CHECK(sources.place(sources.base(inc)).line == 1);
  CHECK(sources.place(sources.base(inc) + 8).column == 1);
  CHECK(sources.line_at(two) == "two");
  CHECK(sources.text(typed) == "abc\ndef");
  CHECK(sources.line_at(sources.base(typed) + 4) == "def");

  sources.rest(0);
  std::ofstream(path) << "something else altogether\n";
  CHECK(sources.place(two).line == 2);
  CHECK(sources.line_at(two).empty());
  std::filesystem::remove_all(folder);
}

TEST_CASE("source: nowhere has no place", "[base][source]") {
  SourceMap sources;
  sources.add("a", "abc");
  CHECK(sources.place(0).line == 0);
  CHECK(sources.text(Span{}).empty());
  CHECK(sources.line_at(0).empty());
}

TEST_CASE("span: covers both ends, nowhere does not count", "[base][source]") {
  CHECK(Span{5, 2}.to(Span{10, 3}) == Span{5, 8});
  CHECK(Span{}.to(Span{10, 3}) == Span{10, 3});
  CHECK(Span{5, 2}.to(Span{}) == Span{5, 2});
}

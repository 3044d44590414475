#include "cli/doc.h"

#include <set>

#include "tests/support/catch.h"

using namespace durer;
using namespace durer::cli;

namespace {

std::vector<DocEntry> read(const std::string& text) {
  std::vector<DocEntry> entries;
  read_library_docs("a.inc", text, entries);
  return entries;
}

}  // namespace

TEST_CASE("doc: the docstring at the top of a file is about the file", "[cli][doc]") {
  const auto entries = read("/// Shapes.\n/// More of them.\n\n#macro A(B) #end\n");
  REQUIRE(entries.size() == 1);
  CHECK(entries[0].kind == "include");
  CHECK(entries[0].text == std::vector<std::string>{"Shapes.", "More of them."});
}

TEST_CASE("doc: macros with a docstring are told, others are helpers", "[cli][doc]") {
  const auto entries = read("/// File.\n\n/// Adds.\n/// A, B: numbers.\n#macro Sum(A, B)\n#end\n#macro Helper(A)\n#end\n");
  REQUIRE(entries.size() == 2);
  CHECK(entries[1].name == "Sum");
  CHECK(entries[1].usage == "Sum(A, B)");
  CHECK(entries[1].text.size() == 2);
}

TEST_CASE("doc: a remark behind a value does not hide its kind", "[cli][doc]") {
  const auto entries = read("/// File.\n\n#declare Eps = 1e-6;  // very small\n#declare Up = <0, 1, 0>; // not down\n");
  REQUIRE(entries.size() == 3);
  CHECK(entries[1].kind == "number");
  CHECK(entries[2].kind == "vector");
}

TEST_CASE("doc: a declaration is told with its kind and source", "[cli][doc]") {
  const auto entries = read(
      "/// File.\n#ifndef (X_Inc_Temp)\n#declare X_Inc_Temp = version;\n#declare Red = rgb <1, 0, 0>;\n"
      "#declare M = color_map {\n  [0 rgb 0]\n}\n#declare N = 5;\n#declare deprecated once \"old\"\n  T = texture {}\n");
  REQUIRE(entries.size() == 5);
  CHECK(entries[1].kind == "colour");
  CHECK(entries[1].value == "rgb <1, 0, 0>;");
  CHECK(entries[2].kind == "colour map");
  CHECK(entries[2].value == "color_map {\n  [0 rgb 0]\n}");
  CHECK(entries[3].kind == "number");
  CHECK(entries[4].name == "T");
}

TEST_CASE("doc: every function and directive of the language is told", "[cli][doc]") {
  std::set<std::string> told;
  for (const DocEntry& e : language_docs({})) told.insert(e.name);
#define DURER_WORD(id, text, kind) \
  if (std::string_view(#kind) == "function") CHECK((told.count(text) == 1));
#include "grammar/vocabulary.def"
#undef DURER_WORD
  for (const char* directive : {"declare", "local", "macro", "if", "while", "for", "switch", "include", "read", "write"}) {
    CHECK(told.count(directive) == 1);
  }
}

TEST_CASE("doc: entries are printed for people and for programs", "[cli][doc]") {
  const DocEntry entry{"Red", "colour", "colors.inc", "Red", {"The colour of blood."}, "rgb <1, 0, 0>;"};
  CHECK(doc_text(entry) == "Red\n  colour of colors.inc\n\n  The colour of blood.\n\n  rgb <1, 0, 0>;\n");
  CHECK(doc_json(std::vector{entry}).find("\"place\": \"colors.inc\"") != std::string::npos);
}

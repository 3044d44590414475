#include "tests/support/catch.h"
#include "tests/unit/grammar/dump.h"

using durer::test::diagnose;
using durer::test::dump;
using durer::test::Parsed;

TEST_CASE("tokens: numbers follow the language, not C", "[grammar][tokens]") {
  CHECK(dump("1 1. .5 1e3 1.e2 00012 1E-2") == "1 1 0.5 1000 100 12 0.01");
  CHECK(dump("1e 1e+ 2e-") == "1 1 2");
  CHECK(dump("0x10") == "0 x10");
  CHECK(dump("5.x") == "5 x");
  CHECK(dump("A.5") == "A 0.5");
  CHECK(dump("A .x") == "A.x");
  CHECK(dump("1e999") == "inf");
  CHECK(dump("123456789012345678901234567890") == "1.23457e+29");
}

TEST_CASE("tokens: a second decimal point is an error", "[grammar][tokens]") {
  CHECK(diagnose("1..2") == "D0101 1:3 a number has only one decimal point");
  CHECK(diagnose("1.5.x") == "D0101 1:4 a number has only one decimal point");
  CHECK(diagnose("1e2.5") == "D0101 1:4 a number has only one decimal point");
  CHECK(diagnose("#if (0) 1..2 #end") == "D0101 1:11 a number has only one decimal point");
}

TEST_CASE("tokens: strings keep everything but escaped quotes", "[grammar][tokens]") {
  CHECK(dump(R"("a\"b")") == R"("a"b")");
  CHECK(dump(R"("C:\\x\n")") == R"("C:\\x\n")");
  CHECK(dump("\"two\nlines\"") == "\"two\nlines\"");
  CHECK(dump("\"// no comment /* \"") == "\"// no comment /* \"");
  CHECK(dump("\"\xC3\xA9\"") == "\"\xC3\xA9\"");
}

TEST_CASE("tokens: unterminated strings and comments point at their beginning",
          "[grammar][tokens]") {
  CHECK(diagnose("a\n  \"bc\n") == "D0104 2:3 no matching `\"`");
  CHECK(diagnose(R"("C:\dir\" )") == "D0104 1:1 no matching `\"`");
  CHECK(diagnose("\"a\\\nb\"") == "D0104 1:1 no matching `\"`");
  CHECK(diagnose("x /* /* */") == "D0104 1:3 no matching `*/`");
}

TEST_CASE("tokens: comments nest and do not know strings", "[grammar][tokens]") {
  CHECK(dump("a /* x /* y */ z */ b // c\nd") == "a b d");
  CHECK(dump("a // b\rc") == "a c");
  CHECK(dump("a /* \"*/ b") == "a b");
  CHECK(dump("a /*/ b /*/ c */ */ d") == "a d");
  CHECK(dump("8/2 // 3") == "(/ 8 2)");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "/*";
  for (int i = 0; i < 100000; ++i) deep += "*/";
  CHECK(dump(deep + "a") == "a");
}

TEST_CASE("tokens: NUL and Control-Z are white space", "[grammar][tokens]") {
  CHECK(dump(std::string("a\0b\x1A", 4)) == "a b");
}

TEST_CASE("tokens: bytes that are not ASCII stand only in strings and comments",
          "[grammar][tokens]") {
  CHECK(dump("// \xE9\na") == "a");
  CHECK(diagnose("a \xC3\xA9").substr(0, 9) == "D0103 1:3");
  CHECK(diagnose("#if (0) \xE9 #end").substr(0, 9) == "D0103 1:9");
  CHECK(diagnose("a \x01").substr(0, 9) == "D0103 1:3");
}

TEST_CASE("tokens: a byte-order mark makes strings UTF-8", "[grammar][tokens]") {
  const Parsed marked("\xEF\xBB\xBF a");
  REQUIRE(marked.tree != nullptr);
  CHECK(marked.tree->utf8);
  CHECK(marked.items(marked.tree->top) == "a");
  CHECK(marked.text(marked.tree->items[0].span) == "a");
  CHECK_FALSE(Parsed("a").tree->utf8);
}

TEST_CASE("tokens: two-character marks are never two marks", "[grammar][tokens]") {
  CHECK(dump("(a<=b)") == "((<= a b))");
  CHECK(dump("(a!=b)") == "((!= a b))");
  CHECK(dump("(a>=b)") == "((>= a b))");
  CHECK(diagnose("<1,2>=3").substr(0, 9) == "D0101 1:5");
}

TEST_CASE("vocabulary: words know their class", "[grammar][vocabulary]") {
  using durer::grammar::WordClass;
  const durer::grammar::SymbolTable symbols;
  CHECK(durer::grammar::words::count_ == 498);
  const auto word_class = [&](std::string_view text) {
    return symbols.word_class(symbols.find(text));
  };
  CHECK(word_class("sphere") == WordClass::keyword);
  CHECK(word_class("normal") == WordClass::keyword);
  CHECK(word_class("red") == WordClass::keyword);
  CHECK(word_class("t") == WordClass::value);
  CHECK(word_class("version") == WordClass::value);
  CHECK(word_class("inside") == WordClass::function);
  CHECK(word_class("min_extent") == WordClass::function);
  CHECK(symbols.text(durer::grammar::words::if_) == "if");
  CHECK_FALSE(symbols.reserved(symbols.find("image_width")));
}

TEST_CASE("vocabulary: names are interned once, after the reserved words",
          "[grammar][vocabulary]") {
  durer::grammar::SymbolTable symbols;
  const auto id = symbols.intern("Varnish");
  CHECK(id == durer::grammar::additions::end_);
  CHECK(symbols.intern("Varnish") == id);
  CHECK_FALSE(symbols.reserved(id));
  CHECK(symbols.word_class(id) == durer::grammar::WordClass::identifier);
  CHECK(symbols.intern("sphere") == durer::grammar::words::sphere);
}

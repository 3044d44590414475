// What older versions did otherwise (language §4.3, §8.3), and character sets (§1.4).
#include "support.h"
#include "tests/support/catch.h"

using namespace durer::interpreter;
using namespace durer::interpreter::test;

namespace {

std::string first(const std::vector<std::string>& list) { return list.empty() ? "" : list.front(); }

std::string assumed(const std::string& text, const std::string& path = "a.pov", int version = 0) {
  std::string line;
  Options o;
  o.version = version;
  o.on_assumptions = [&](std::string_view s) { line = s; };
  (void)run(text, false, o, path);
  return line;
}

}  // namespace

TEST_CASE("versions: a missing semicolon is an error since 3.5", "[interpreter][versions]") {
  const std::string text = "#declare A = 1\n#debug str(A, 0, 0)";
  const Run r35 = run("#version 3.5; " + text, false);
  CHECK(first(r35.errors) == "D0101 at 1:24: this `#declare` of a float must end with `;`");
  const Run r34 = run("#version 3.4; " + text, false);
  CHECK(r34.debug == "1");
  CHECK(first(r34.warnings) == "D0101 at 1:24: this `#declare` of a float must end with `;`");
  const Run r30 = run("#version 3.0; " + text + " sphere { 0, 1 }", false);
  CHECK(r30.debug == "1");
  CHECK(r30.warnings.empty());
}

TEST_CASE("versions: macros need 3.1", "[interpreter][versions]") {
  CHECK(first(run("#version 3.0; #macro M() 1 #end", false).errors).substr(0, 5) == "D0306");
  CHECK(run("#version 3.0; #if (0) #macro M() 1 #end #end #debug \"ok\"", false).debug == "ok");
}

TEST_CASE("versions: the variable follows the directive", "[interpreter][versions]") {
  CHECK(run("#debug str(version,0,2) #version 3.5; #debug str(version,0,2) #declare T = version;"
            " #version 0.5; #version T + 0.1; #debug str(version,0,2)",
            false)
            .debug == "3.703.503.60");
  CHECK(run("#version unofficial 3.7; #debug str(version,0,2)", false).debug == "3.70");
}

TEST_CASE("versions: directives of old scenes have no hash", "[interpreter][versions]") {
  const Run r = run("declare A = 3;\ndeclare S = sphere { 0, A }\nobject { S }\nversion 3.6\n"
                    "default { finish { ambient 1 } }\n#debug str(A + version, 0, 1)");
  CHECK(first(r.errors).empty());
  CHECK(r.debug == "6.6");
  CHECK(r.warnings.size() == 4);
  CHECK(first(r.warnings) == "D0403 at 1:1: `declare` without `#`");
  CHECK(error_of("include \"not-there.inc\"") == "D0601 at 1:9: cannot find the file `not-there.inc`");
}

TEST_CASE("versions: character sets decide about high bytes", "[interpreter][versions]") {
  const auto codes = [](const std::string& set, const std::string& text) {
    return run("global_settings { charset " + set + " } #debug concat(str(strlen(\"" + text +
               "\"),0,0), \" \", str(asc(\"" + text + "\"),0,0))")
        .debug;
  };
  CHECK(codes("ascii", "\xC3\xA9") == "2 32");
  CHECK(codes("utf8", "\xC3\xA9") == "1 233");
  CHECK(codes("utf8", "\xF0\x9F\x98\x80") == "1 65533");
  CHECK(codes("utf8", "\xE9") == "1 65533");
  CHECK(codes("sys", "\xC3\xA9") == "1 233");
  CHECK(codes("sys", "\xE9") == "1 233");
  CHECK(run("#version 3.4; #debug str(asc(\"\xE9\"),0,0)", false).debug == "233");
  CHECK(first(run("sphere { 0, 1 } #debug \"\xE9\"").warnings).substr(0, 5) == "D0103");
  CHECK(run("\xEF\xBB\xBF#debug str(asc(\"\xC3\xA9\"),0,0)", false).debug == "233");
}

TEST_CASE("versions: what was assumed is said in one line", "[interpreter][versions]") {
  CHECK(assumed("sphere { 0, 1 }") ==
        "language 3.62 (no #version); no assumed_gamma, colours are stored as they are");
  CHECK(assumed("#version 3.7;") == "language 3.70; assumed_gamma 1 (implied)");
  CHECK(assumed("#version 3.7; global_settings { assumed_gamma 2.2 }") ==
        "language 3.70; assumed_gamma 2.2");
  CHECK(assumed("#version 3.7; global_settings { assumed_gamma srgb }") ==
        "language 3.70; assumed_gamma srgb");
  CHECK(assumed("", "a.scene") == "language 3.80 (.scene); assumed_gamma 1 (.scene)");
  CHECK(assumed("", "a.pov", 370) == "language 3.70 (option); assumed_gamma 1 (implied)");
  CHECK(assumed("global_settings { assumed_gamma 1 }") ==
        "language 3.62 (no #version); assumed_gamma 1");
}

#include "base/diagnostic.h"
#include "tests/support/catch.h"

using namespace durer;

namespace {

struct Page {
  SourceMap sources;
  FileId file;

  explicit Page(std::string text) : file(sources.add("desk.pov", std::move(text))) {}
  [[nodiscard]] Span span(std::string_view word, std::size_t from = 0) const {
    const std::size_t at = sources.text(file).find(word, from);
    return {static_cast<Loc>(sources.base(file) + at), static_cast<std::uint32_t>(word.size())};
  }
};

Diagnostic error_at(Span span, std::string message, std::string at = {}) {
  Diagnostic d;
  d.span = span;
  d.message = std::move(message);
  d.at = std::move(at);
  return d;
}

}  // namespace

TEST_CASE("diagnostic: shows claim, place, excerpt, label, help and notes", "[base][diagnostic]") {
  const Page page("\nfinish {\n  phong 0.4 difuse 0.7\n}\n\n\nVarnish()\n");
  Diagnostic d =
      error_at(page.span("difuse"), "`finish` has no setting `difuse`", "unknown setting");
  d.code = Code::unknown_setting;
  d.labels.push_back({page.span("finish"), "in this block"});
  d.help.push_back("did you mean `diffuse`?");
  d.trace.push_back({page.span("Varnish"), "in macro `Varnish`, called"});
  CHECK(render_diagnostic(d, page.sources) ==
        "error[D0214]: `finish` has no setting `difuse`\n"
        "  --> desk.pov:3:13\n"
        "   |\n"
        " 2 | finish {\n"
        "   | ------ in this block\n"
        " 3 |   phong 0.4 difuse 0.7\n"
        "   |             ^^^^^^ unknown setting\n"
        "   = help: did you mean `diffuse`?\n"
        "   = note: in macro `Varnish`, called at desk.pov:7:1\n");
}

TEST_CASE("diagnostic: labels on the same line go below, right to left", "[base][diagnostic]") {
  const Page page("sphere { <0, 0 ]");
  Diagnostic d = error_at(page.span("]"), "expected `>`", "expected `>`");
  d.labels.push_back({page.span("<"), "opened here"});
  d.labels.push_back({page.span("sphere"), "in this block"});
  CHECK(render_diagnostic(d, page.sources) ==
        "error[D0101]: expected `>`\n"
        "  --> desk.pov:1:16\n"
        "   |\n"
        " 1 | sphere { <0, 0 ]\n"
        "   | ------   -     ^ expected `>`\n"
        "   |          opened here\n"
        "   | in this block\n");
}

TEST_CASE("diagnostic: lines far apart are separated", "[base][diagnostic]") {
  std::string text = "union {\n";
  for (int i = 0; i < 120; ++i) text += "a\n";
  const Page page(text + "?");
  Diagnostic d = error_at(page.span("?"), "no matching `}`");
  d.labels.push_back({page.span("{"), "opened here"});
  CHECK(render_diagnostic(d, page.sources) ==
        "error[D0101]: no matching `}`\n"
        "   --> desk.pov:122:1\n"
        "    |\n"
        "  1 | union {\n"
        "    |       - opened here\n"
        "...\n"
        "122 | ?\n"
        "    | ^\n");
}

TEST_CASE("diagnostic: tabs and wide characters keep the caret in place", "[base][diagnostic]") {
  const Page page("\tcolor\t\"\xC3\xA9\" bad");
  CHECK(render_diagnostic(error_at(page.span("bad"), "m"), page.sources) ==
        "error[D0101]: m\n"
        "  --> desk.pov:1:13\n"
        "   |\n"
        " 1 |         color   \"\xC3\xA9\" bad\n"
        "   |                     ^^^\n");
}

TEST_CASE("diagnostic: a span over several lines is underlined on its first",
          "[base][diagnostic]") {
  const Page page("a {\n  b\n}");
  CHECK(render_diagnostic(error_at(page.span("{\n  b\n}"), "m"), page.sources) ==
        "error[D0101]: m\n"
        "  --> desk.pov:1:3\n"
        "   |\n"
        " 1 | a {\n"
        "   |   ^\n");
}

TEST_CASE("diagnostic: the end of the file has a caret", "[base][diagnostic]") {
  const Page page("a\n");
  CHECK(render_diagnostic(error_at({page.sources.base(page.file) + 2, 0}, "m"), page.sources) ==
        "error[D0101]: m\n"
        "  --> desk.pov:2:1\n"
        "   |\n"
        " 2 |\n"
        "   | ^\n");
}

TEST_CASE("diagnostic: very long lines are cut around the caret", "[base][diagnostic]") {
  const Page page(std::string(5000, '1') + " bad " + std::string(5000, '2'));
  const std::string text = render_diagnostic(error_at(page.span("bad"), "m"), page.sources);
  CHECK(text.size() < 600);
  const std::size_t bad = text.find("bad");
  const std::size_t caret = text.find("^^^");
  REQUIRE(bad != std::string::npos);
  REQUIRE(caret != std::string::npos);
  const auto column = [&](std::size_t at) { return at - text.rfind('\n', at); };
  CHECK(column(bad) == column(caret));
}

TEST_CASE("diagnostic: a label in another file has an excerpt of its own", "[base][diagnostic]") {
  Page page("Knob()\n");
  const FileId other = page.sources.add("knob.inc", "#macro Knob(a)\n#end\n");
  Diagnostic d = error_at(page.span("Knob"), "`Knob` takes 1 argument", "none given");
  d.labels.push_back({{page.sources.base(other) + 7, 4}, "declared here"});
  CHECK(render_diagnostic(d, page.sources) ==
        "error[D0101]: `Knob` takes 1 argument\n"
        "  --> desk.pov:1:1\n"
        "   |\n"
        " 1 | Knob()\n"
        "   | ^^^^ none given\n"
        "  --> knob.inc:1\n"
        "   |\n"
        " 1 | #macro Knob(a)\n"
        "   |        ---- declared here\n");
}

TEST_CASE("diagnostic: without a place only the claim is shown", "[base][diagnostic]") {
  const SourceMap sources;
  Diagnostic d = error_at({}, "cannot find `x.pov`");
  d.severity = Severity::warning;
  d.code = Code::file_not_found;
  d.help.push_back("give its path");
  CHECK(render_diagnostic(d, sources) ==
        "warning[D0601]: cannot find `x.pov`\n   = help: give its path\n");
}

TEST_CASE("diagnostic: colour adds escapes and nothing else", "[base][diagnostic]") {
  const Page page("a bad b");
  Diagnostic d = error_at(page.span("bad"), "m", "here");
  d.labels.push_back({page.span("a"), "there"});
  const std::string plain = render_diagnostic(d, page.sources);
  const std::string colour = render_diagnostic(d, page.sources, true);
  std::string stripped;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    if (colour[i] == '\x1b') {
      i = colour.find('m', i);
    } else {
      stripped += colour[i];
    }
  }
  CHECK(colour.find("\x1b[1;31m") != std::string::npos);
  CHECK(stripped == plain);
}

TEST_CASE("diagnostics: errors are counted, notes and warnings are not", "[base][diagnostic]") {
  const SourceMap sources;
  Diagnostics all(sources);
  Diagnostic d = error_at({}, "m");
  d.severity = Severity::warning;
  all.report(d);
  CHECK_FALSE(all.has_errors());
  d.severity = Severity::error;
  all.report(d);
  CHECK(all.has_errors());
  CHECK(all.all().size() == 2);
  CHECK(code_text(Code::syntax) == "D0101");
}

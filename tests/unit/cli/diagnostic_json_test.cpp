#include "cli/diagnostic_json.h"

#include "tests/support/catch.h"

namespace durer::cli {

TEST_CASE("diagnostic json: one line with everything there is", "[cli][json]") {
  SourceMap sources;
  const FileId file = sources.add("a.pov", "sphere {\n  difuse 0.7\n}\n");
  const Loc base = sources.base(file);
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = Code::unknown_setting;
  d.span = {base + 11, 6};
  d.message = "`finish` has no setting `difuse`";
  d.at = "unknown";
  d.labels.push_back({{base, 6}, "in this block"});
  d.help.emplace_back("did you mean `diffuse`?");
  d.trace.push_back({{base + 7, 1}, "in macro `M`, called here"});
  CHECK(diagnostic_json(d, sources) ==
        R"({"kind":"diagnostic","severity":"warning","code":"D0214",)"
        R"("message":"`finish` has no setting `difuse`","file":"a.pov","line":2,"column":3,)"
        R"("end":{"line":2,"column":9},"at":"unknown",)"
        R"("labels":[{"text":"in this block","file":"a.pov","line":1,"column":1,)"
        R"("end":{"line":1,"column":7}}],"help":["did you mean `diffuse`?"],)"
        R"("trace":[{"text":"in macro `M`, called here","file":"a.pov","line":1,"column":8,)"
        R"("end":{"line":1,"column":9}}]})"
        "\n");
}

TEST_CASE("diagnostic json: no place, no fields; text is escaped", "[cli][json]") {
  const SourceMap sources;
  Diagnostic d;
  d.code = Code::option;
  d.message = "a \"b\"\n\xFF";
  CHECK(diagnostic_json(d, sources) ==
        "{\"kind\":\"diagnostic\",\"severity\":\"error\",\"code\":\"D0603\","
        "\"message\":\"a \\\"b\\\"\\n\xEF\xBF\xBD\"}\n");
  CHECK(message_json("debug", "x\n") ==
        "{\"kind\":\"message\",\"stream\":\"debug\",\"text\":\"x\\n\"}\n");
}

}  // namespace durer::cli

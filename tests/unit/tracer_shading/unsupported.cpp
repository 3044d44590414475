// Features that cannot be rendered stop the scene, where they are used and only there.
#include "tests/unit/tracer_shading/shading_test.h"

using namespace durer;
using namespace durer::test;

namespace {

struct Outcome {
  bool compiled = false;
  std::vector<Diagnostic> diagnostics;
};

Outcome try_compile(const scene::Scene& scene) {
  SourceMap sources;
  sources.add("a.pov", "0123456789 pigment { bozo }\nplane { y, 0 }\n");
  Diagnostics diagnostics(sources);
  Outcome o;
  o.compiled = tracer::compile(scene, diagnostics) != nullptr;
  o.diagnostics = diagnostics.all();
  return o;
}

}  // namespace

TEST_CASE("unsupported: a used feature is an error with its place and chain", "[tracer][compile]") {
  Wall s;
  s.scene.origins.push_back({{5, 2}, 0});
  s.scene.origins.push_back({{12, 7}, 1});
  scene::Pigment outer;
  outer.pattern.edit().type = s.pattern("checker");
  outer.entries = {{0, {}, 0}, {1, {}, scene::none}};
  scene::Pigment bozo = plain(rgbft(1, 0, 0));
  bozo.unsupported = "bozo";
  bozo.origin = 2;
  outer.children = {bozo};
  s.wall(outer, {});
  s.add("sphere", {9, 9, 9, 1}, 0);  // the same texture again: reported once
  const Outcome o = try_compile(s.scene);
  CHECK_FALSE(o.compiled);
  REQUIRE(o.diagnostics.size() == 1);
  const Diagnostic& d = o.diagnostics[0];
  CHECK(d.code == Code::not_supported);
  CHECK(d.severity == Severity::error);
  CHECK(d.span == Span{12, 7});
  CHECK(d.message.find("bozo") != std::string::npos);
  REQUIRE(d.trace.size() == 1);
  CHECK(d.trace[0].span == Span{5, 2});
}

TEST_CASE("unsupported: what is only declared does no harm", "[tracer][compile]") {
  Wall s;
  s.wall(plain(rgbft(1, 1, 1)), {});
  scene::Finish f;
  f.unsupported = "subsurface";
  s.texture(plain(rgbft(1, 1, 1)), f);
  CHECK(try_compile(s.scene).compiled);
}

TEST_CASE("unsupported: finishes, layers, textures and interiors are looked at",
          "[tracer][compile]") {
  Wall s;
  scene::Finish f;
  scene::Interior i;
  const int where = GENERATE(0, 1, 2, 3);
  CAPTURE(where);
  if (where == 0) f.unsupported = "x";
  if (where == 1) i.unsupported = "x";
  s.wall(plain(rgbft(1, 1, 1)), f).interior = s.interior(i);
  if (where == 2) s.scene.textures[0].unsupported = "x";
  if (where == 3) s.scene.textures[0].layers[0].unsupported = "x";
  CHECK_FALSE(try_compile(s.scene).compiled);
}

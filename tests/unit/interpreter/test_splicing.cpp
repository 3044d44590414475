// Half blocks, half expressions, conditional heads (language §4.1, §7.4).
#include "support.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::interpreter::test;

namespace {
const scene::Object& root(const Run& r, std::size_t i = 0) {
  return r.scene->objects[r.scene->roots[i].object];
}
}  // namespace

TEST_CASE("splicing: branches that open different blocks", "[interpreter][splicing]") {
  for (const bool merge : {true, false}) {
    const Run r = run(std::string("#declare M=") + (merge ? "1" : "0") +
                      ";\n#if (M) merge { #else union { #end sphere {0,1} sphere {x,1} }");
    REQUIRE(r.scene);
    CHECK(root(r).kind == (merge ? scene::NodeKind::merge : scene::NodeKind::union_));
    CHECK(root(r).children.size() == 2);
  }
}

TEST_CASE("splicing: a wrapper opened and closed by two conditionals", "[interpreter][splicing]") {
  const Run r = run(
      "#declare C=1;\n#declare O = #if (C) union { #end sphere {0,1} #if (C) sphere {x,1} } #end\n"
      "object { O translate y }");
  REQUIRE(r.scene);
  CHECK(root(r).kind == scene::NodeKind::union_);
}

TEST_CASE("splicing: nested heads on the right of a declare", "[interpreter][splicing]") {
  const Run r =
      run("#local F=1; #local M=0;\n#local Part = #if (F) #if (M) merge { #else union { #end #end "
          "sphere {0,1} #if (F) box {0,1} } #end\n"
          "object { Part }");
  REQUIRE(r.scene);
  CHECK(root(r).kind == scene::NodeKind::union_);
  CHECK(root(r).children.size() == 2);
}

TEST_CASE("splicing: a macro opens a block that its caller closes", "[interpreter][splicing]") {
  const Run r = run("#macro Open() union { sphere {0,1} #end\nOpen() sphere {x,1} translate y }");
  REQUIRE(r.scene);
  CHECK(root(r).children.size() == 2);
  CHECK(root(r).transform->forward.t.y == 1);
}

TEST_CASE("splicing: directives between operands", "[interpreter][splicing]") {
  const Run r =
      run("#declare C=1;\nsphere { 0, 1 #if (C) +1 #end }\nsphere { <1, #if (C) 2 #else 7 #end, "
          "3>, 1 }\n"
          "sphere { 0, (1 #if (C) +2 #end) }\nsphere { 0 #declare K=4; , K }");
  REQUIRE(r.scene);
  CHECK(root(r, 0).args[3] == 2);
  CHECK(root(r, 1).args[1] == 2);
  CHECK(root(r, 2).args[3] == 3);
  CHECK(root(r, 3).args[3] == 4);
}

TEST_CASE("splicing: values made by conditionals", "[interpreter][splicing]") {
  CHECK(value_of("A", "#declare A = #if (1) 1; #else 2; #end", 0) == "1");
  CHECK(vector_of("<1, #if (0) 2 #else 7 #end, 3>", 3, "", 0) == "1 7 3");
  CHECK(value_of("P", "#declare P = (1 #if (1) +2 #end);", 0) == "3");
  CHECK(value_of("2 * #if (1) 3 #else 4 #end", "", 0) == "6");
}

TEST_CASE("splicing: macros of modifiers and of map entries", "[interpreter][splicing]") {
  const Run r = run(
      "#macro Move() translate x rotate 90*y #end\n#macro Entry(k) [k rgb k] #end\n"
      "sphere { 0, 1 Move() pigment { gradient x color_map { Entry(0) Entry(.5) Entry(1) } } }");
  REQUIRE(r.scene);
  const auto& texture = r.scene->textures[root(r).texture.texture];
  CHECK(texture.layers.back().pigment->entries.size() == 3);
  CHECK(texture.layers.back().pigment->entries[1].key == 0.5F);
}

TEST_CASE("splicing: loops that fill a block", "[interpreter][splicing]") {
  const Run r = run("union { #for (I,1,100) sphere { I*x, .4 } #end rotate y }");
  REQUIRE(r.scene);
  CHECK(root(r).children.size() == 100);
}

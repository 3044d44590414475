// The examples of language §9.5, each verified with POV-Ray, and the rule by extension.
#include "cli/output_name.h"

#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

std::string name(std::vector<std::string> words, const std::string& scene = "d/s.pov") {
  words.push_back("+I" + scene);
  return output_of(test::accepted(words)).path;
}

}  // namespace

TEST_CASE("output name: derived from the scene and beside it", "[cli][output]") {
  CHECK(name({}) == "d/s.png");
  CHECK(name({}, "s.scene") == "s.png");
  CHECK(name({}, "/abs/a.b.pov") == "/abs/a.b.png");
  CHECK(name({"+FJ"}) == "d/s.jpg");
  CHECK(name({"+FT"}) == "d/s.tga");
  CHECK(name({"+FC"}) == "d/s.tga");
  CHECK(name({"+FP"}) == "d/s.ppm");
  CHECK(name({"+FB"}) == "d/s.bmp");
  CHECK(name({"+FE"}) == "d/s.exr");
  CHECK(name({"+FH"}) == "d/s.hdr");
  CHECK(name({"--format", "tiff"}) == "d/s.tif");
  CHECK(name({}, "-") == "stdin.png");
}

TEST_CASE("output name: a given type keeps foreign extensions", "[cli][output]") {
  CHECK(name({"+Oout.jpg", "+FN"}) == "out.jpg.png");
  CHECK(name({"+Oout.png", "+FT"}) == "out.png.tga");
  CHECK(name({"+Oout.png", "+FN"}) == "out.png");
  CHECK(name({"+OA.jpg", "+FJ"}) == "A.jpg");
  CHECK(name({"+OA.JPG", "+FJ"}) == "A.JPG.jpg");
  CHECK(name({"+Oout", "+FN"}) == "out.png");
  CHECK(name({"+O.jpg", "+FN"}) == ".jpg.png");
}

TEST_CASE("output name: without a type, the extension of the name decides", "[cli][output]") {
  for (const char* given :
       {"out.exr", "out.jpeg", "out.tiff", "out.tif", "a.b.ppm", "OUT.PNG", "x/o.hdr"}) {
    CHECK(name({std::string("+O") + given}) == given);
  }
  CHECK(output_of(test::accepted({"a.pov", "+Oout.exr"})).format->name == "exr");
  CHECK(output_of(test::accepted({"a.pov", "--output", "o.Jpeg"})).format->name == "jpeg");
  CHECK(name({"+O.jpg"}) == "s.jpg");
}

TEST_CASE("output name: no name, a folder, or only the extension", "[cli][output]") {
  CHECK(name({"+Oo/"}) == "o/s.png");
  CHECK(name({"+Oo/.png"}) == "o/s.png");
  CHECK(name({"+O.png"}) == "s.png");
  CHECK(name({"+O.png", "+FN"}) == "s.png");
  CHECK(name({"Output_File_Name="}) == "d/s.png");
}

TEST_CASE("output name: a given name without a folder goes to the working folder",
          "[cli][output]") {
  CHECK(name({"+Oout"}) == "out.png");
  CHECK(name({"+Oout."}) == "out.png");
  CHECK(name({"+Oo/out"}) == "o/out.png");
  CHECK(name({"+Oout.v2"}) == "out.v2.png");
}

TEST_CASE("output name: standard output and no output", "[cli][output]") {
  CHECK(name({"+O-"}) == "-");
  CHECK(name({"+Ostdout"}) == "-");
  CHECK(name({"-F"}).empty());
  CHECK(name({"-F", "+Oout"}).empty());
  CHECK(output_of(test::accepted({"a.pov", "+O-", "+FE"})).format->name == "exr");
}

}  // namespace durer::cli

// The pattern `function`, and patterns and pigments as functions. Values are the oracle's.
#include "functions/builder.h"
#include "functions/evaluate.h"
#include "tests/support/catch.h"
#include "tests/support/scene_builder.h"
#include "tracer/compile.h"
#include "tracer/pigment_queries.h"
#include "tracer/shading/pigment.h"

using namespace durer;
using namespace durer::tracer;
using functions::FunctionBuilder;

namespace {

scene::Pigment function_pigment(FunctionBuilder& builder, functions::Value value) {
  const test::SceneBuilder names(registry());
  scene::Pigment pigment;
  pigment.pattern.edit().type = names.pattern("function");
  pigment.pattern.edit().function = std::make_shared<const functions::Function>(builder.finish(value));
  pigment.entries = {{0, test::rgbft(0, 0, 0), scene::none},
                     {0.5F, test::rgbft(1, 2, 3), scene::none},
                     {1, test::rgbft(1, 1, 1, 0.5F, 0.25F), scene::none}};
  return pigment;
}

functions::Function pattern_of(const scene::Pigment& pigment) {
  return functions::make_external_function(
      make_pigment_queries()->pattern_function(scene::Scene{}, pigment));
}
double at(const functions::Function& f, dvec3 p) {
  functions::Workspace w;
  return functions::evaluate(f, std::array{p.x, p.y, p.z}, w);
}

}  // namespace

TEST_CASE("function pattern: values above 1 and below 0 wrap", "[tracer][patterns][functions]") {
  FunctionBuilder b(3);
  scene::Pigment pigment = function_pigment(b, b.parameter(0));
  const functions::Function f = pattern_of(pigment);
  CHECK(at(f, {0.3, 9, 9}) == 0.3);
  CHECK(at(f, {1, 9, 9}) == 1);
  CHECK(at(f, {2.3, 0, 0}) == Approx(0.3));
  CHECK(at(f, {-0.3, 0, 0}) == Approx(0.7));
}

TEST_CASE("function pattern: transforms, frequency, phase and wave follow",
          "[tracer][patterns][functions]") {
  FunctionBuilder b(3);
  scene::Pigment pigment = function_pigment(b, b.op(functions::Op::square, b.parameter(0)));
  pigment.pattern.edit().transform = Transform::scale(dvec3(2));
  pigment.pattern.edit().frequency = 3;
  pigment.pattern.edit().phase = 0.2F;
  pigment.pattern.edit().wave = scene::Wave::triangle;
  const functions::Function f = pattern_of(pigment);
  CHECK(at(f, {0.3, 0.1, 0.1}) == Approx(0.535).epsilon(1e-6));
  CHECK(at(f, {-1.3, 1, 1}) == Approx(0.93498).epsilon(1e-6));
  CHECK(at(f, {2.3, 0, 0}) == Approx(0.33498).epsilon(1e-6));
}

TEST_CASE("pigment functions: five components in single precision, captured by value",
          "[tracer][pigments][functions]") {
  functions::Function f;
  {
    FunctionBuilder b(3);
    const scene::Pigment pigment = function_pigment(b, b.parameter(0));
    f = functions::make_external_function(
        make_pigment_queries()->pigment_function(scene::Scene{}, pigment));
  }
  std::array<double, 5> c{};
  functions::Workspace w;
  functions::evaluate(f, std::array{0.3, 0.0, 0.0}, c, w);
  CHECK(c == std::array<double, 5>{0.6F, 1.2F, static_cast<float>(1.8), 0, 0});
  functions::evaluate(f, std::array{1.0, 0.0, 0.0}, c, w);
  CHECK(c == std::array<double, 5>{1, 1, 1, 0.5, 0.25});
}

TEST_CASE("colours between map entries have the oracle's last bits", "[tracer][pigments][oracle]") {
  // color_map { [0 rgb 0] [.5 rgb <1,2,3>] } at 0.3: 3 · 0.6 in single precision is 1.8000001.
  FunctionBuilder b(3);
  const scene::Pigment pigment = function_pigment(b, b.constant(0.3));
  PigmentStore store;
  const Colour c = store.at(store.add(pigment, {}), {0, 0, 0});
  CHECK(c.rgb.z == static_cast<float>(1.8));
}

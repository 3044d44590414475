#include "functions/builder.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/parametric_shape.h"

namespace durer::tracer {
namespace {

/// Two samples: a saddle, and a ball cut by its container.
std::vector<scene::Object> samples() {
  using functions::Op;
  const auto whole = [](auto make) {
    functions::FunctionBuilder b(2);
    return std::make_shared<const functions::Function>(
        b.finish(make(b, b.parameter(0), b.parameter(1))));
  };
  scene::Parametric saddle;
  saddle.functions = {whole([](auto&, auto u, auto) { return u; }),
                      whole([](auto&, auto, auto v) { return v; }),
                      whole([](auto& b, auto u, auto v) { return b.op(Op::multiply, u, v); })};
  saddle.from = dvec2(-0.9);
  saddle.to = dvec2(0.8);
  scene::Parametric ball = saddle;
  ball.functions = {
      whole([](auto& b, auto u, auto v) {
        return b.op(Op::multiply, b.op(Op::sine, u), b.op(Op::cosine, v));
      }),
      whole([](auto& b, auto, auto v) { return b.op(Op::sine, v); }),
      whole([](auto& b, auto u, auto v) {
        return b.op(Op::multiply, b.op(Op::cosine, u), b.op(Op::cosine, v));
      })};
  ball.from = {0, -1.5};
  ball.to = {6.28, 1.5};
  ball.container.hi = {1, 0.8, 1};
  std::vector<scene::Object> all(2);
  all[0].extras.edit().parametric = std::make_shared<const scene::Parametric>(saddle);
  all[1].extras.edit().parametric = std::make_shared<const scene::Parametric>(ball);
  return all;
}

constexpr PrimitiveType parametric_type() {
  PrimitiveType type;
  type.name = "parametric";
  type.doc = "The points that three functions of u and v give, inside a box or sphere.";
  type.is_patch = true;
  type.make_stores = [] { return make_type_stores<ParametricShape>(); };
  type.place_whole = [](TypeStores& stores, const scene::Object& object,
                        const Surroundings& around, const Transform& to_world,
                        bool) -> std::optional<ShapeRef> {
    const dvec2 range = object.extras->parametric->to - object.extras->parametric->from;
    if (range.x == 0 || range.y == 0) return std::nullopt;  // a line or a point
    // Without an inside there is nothing that could be inverted (objects §8.5).
    return std::optional(place_shape(
        stores, ParametricShape(shared_parametric_data(object.extras->parametric, around.noise_generator)),
        to_world, false));
  };
  type.sample_objects = &samples;
  type.samples = [] { return std::vector<std::vector<double>>{}; };
  return type;
}

}  // namespace

extern constinit const PrimitiveType parametric_primitive = parametric_type();

}  // namespace durer::tracer

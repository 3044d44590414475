#include "functions/builder.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/isosurface_shape.h"

namespace durer::tracer {
namespace {

/// Two samples: a wavy ball in a box that cuts it, and an open one in a sphere.
std::vector<scene::ObjectExtras> samples() {
  using functions::Op;
  functions::FunctionBuilder b(3);
  const auto x = b.parameter(0);
  const auto y = b.parameter(1);
  const auto z = b.parameter(2);
  const auto wave = b.op(Op::sine, b.op(Op::multiply, x, b.constant(7)));
  const auto squares = b.op(Op::add, b.op(Op::add, b.op(Op::square, x), b.op(Op::square, y)),
                            b.op(Op::square, z));
  const auto ripple = b.op(Op::multiply, wave, b.constant(0.2));
  const auto f = std::make_shared<const functions::Function>(b.finish(b.op(Op::add, squares, ripple)));
  scene::Isosurface boxed;
  boxed.function = f;
  boxed.threshold = 0.8;
  boxed.accuracy = 1e-7;
  boxed.container.lo = {-1, -0.7, -1};
  scene::Isosurface round = boxed;
  round.container.kind = scene::Container::Kind::sphere;
  round.container.radius = 0.9;
  round.open = true;
  std::vector<scene::ObjectExtras> all(2);
  all[0].isosurface = std::make_shared<const scene::Isosurface>(boxed);
  all[1].isosurface = std::make_shared<const scene::Isosurface>(round);
  return all;
}

constexpr PrimitiveType isosurface_type() {
  PrimitiveType type;
  type.name = "isosurface";
  type.doc = "Where a function of x, y and z has a certain value, inside a box or sphere.";
  type.make_stores = [] { return make_type_stores<IsosurfaceShape>(); };
  type.place_extras = [](TypeStores& stores, const scene::ObjectExtras& extras,
                         const Surroundings& around, const Transform& to_world, bool inverted) {
    return std::optional(place_shape(
        stores, IsosurfaceShape(shared_isosurface_data(extras.isosurface, around.noise_generator)),
        to_world, inverted));
  };
  type.sample_extras = &samples;
  type.samples = [] { return std::vector<std::vector<double>>{}; };
  return type;
}

}  // namespace

extern constinit const PrimitiveType isosurface_primitive = isosurface_type();

}  // namespace durer::tracer

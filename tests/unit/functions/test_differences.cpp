// Values along the axes, without what does not change.
#include "functions/differences.h"

#include "functions/builder.h"
#include "tests/support/catch.h"

namespace durer::functions {
namespace {

/// sin(x) cos(y) + z² y, with z <= 0 taken as 0 if `bounded`.
FunctionRef sample(bool bounded) {
  FunctionBuilder b(3);
  const Value x = b.parameter(0);
  const Value y = b.parameter(1);
  Value z = b.parameter(2);
  if (bounded) z = b.op(Op::maximum, z, b.constant(0));
  const Value wave = b.op(Op::multiply, b.op(Op::sine, x), b.op(Op::cosine, y));
  const Value f = b.op(Op::add, wave, b.op(Op::multiply, b.op(Op::square, z), y));
  return std::make_shared<const Function>(b.finish(f));
}

}  // namespace

TEST_CASE("differences: the bits of four evaluations", "[functions][differences]") {
  const FunctionRef f = sample(GENERATE(false, true));
  const Differences differences(f);
  Workspace w;
  for (int i = 0; i < 100; ++i) {
    const dvec3 p(0.13 * i - 3, 0.07 * i, 1 - 0.05 * i);
    const double step = 1e-3;
    const std::array<double, 4> v = differences(p, step, w);
    CHECK(v[0] == evaluate(*f, std::array{p.x, p.y, p.z}, w));
    CHECK(v[1] == evaluate(*f, std::array{p.x + step, p.y, p.z}, w));
    CHECK(v[2] == evaluate(*f, std::array{p.x, p.y + step, p.z}, w));
    CHECK(v[3] == evaluate(*f, std::array{p.x, p.y, p.z + step}, w));
  }
}

}  // namespace durer::functions

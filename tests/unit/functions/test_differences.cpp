// Values along the axes, without what does not change.
#include "functions/differences.h"

#include "functions/builder.h"
#include "functions/waves.h"
#include "tests/support/catch.h"
#include "tests/unit/functions/parse_function.h"

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

TEST_CASE("differences: at eight points the differences of each", "[functions][differences]") {
  const std::string body = GENERATE(
      "sin(12*x)*cos(12*y)+sin(12*y)*cos(12*z)+sin(12*z)*cos(12*x)", "y", "z*z-3",
      "sin(1e6*x)+cos(y)+sin(z)*cos(2*z)+sin(x*z)", "select(x, y*sin(z), cos(y)+z)",
      "select(y-x, y, 0, z*z)+sum(i, 1, 3+x, i*z)", "f_noise3d(x,y,z)*f_torus(x,y,z,0.9,0.3)",
      "select(x, sum(i, 0, y, select(z, i, z)), prod(j, 1, 3, j+z))");
  const auto f = std::make_shared<const Function>(with_waves(parse_function(body)));
  const Differences differences(f);
  Workspace w;
  CAPTURE(body);
  for (int i = 0; i < 20; ++i) {
    std::array<Pack, 3> p, v;
    const auto point = [&](int lane) {
      const double t = i * Pack::lanes + lane;
      return dvec3(0.13 * t - 3, 0.07 * t - 1, 1 - 0.05 * t);
    };
    for (int lane = 0; lane < Pack::lanes; ++lane) {
      for (int k = 0; k < 3; ++k) p[static_cast<std::size_t>(k)].v[lane] = point(lane)[k];
    }
    const double step = 1e-3;
    differences({p[0].v.data(), p[1].v.data(), p[2].v.data()}, step,
                {v[0].v.data(), v[1].v.data(), v[2].v.data()}, w);
    for (int lane = 0; lane < Pack::lanes; ++lane) {
      const dvec3 q = point(lane);
      const std::array<double, 4> alone = differences(q, step, w);
      for (std::size_t k = 0; k < 3; ++k) CHECK(v[k].v[lane] == alone[k + 1] - alone[0]);
      CHECK(alone[0] == evaluate(*f, std::array{q.x, q.y, q.z}, w));
      CHECK(alone[1] == evaluate(*f, std::array{q.x + step, q.y, q.z}, w));
      CHECK(alone[2] == evaluate(*f, std::array{q.x, q.y + step, q.z}, w));
      CHECK(alone[3] == evaluate(*f, std::array{q.x, q.y, q.z + step}, w));
    }
  }
}

}  // namespace durer::functions

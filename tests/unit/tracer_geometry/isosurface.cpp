// Isosurfaces and parametric surfaces: no root is lost, and none found where there is none.
#include <cmath>

#include "functions/builder.h"
#include "tests/unit/tracer_geometry/scenes.h"
#include "tracer/primitives/isosurface_shape.h"
#include "tracer/primitives/parametric_shape.h"

namespace durer::tracer::test {
namespace {

using functions::FunctionBuilder;
using functions::Op;
using functions::Value;

/// A function of `parameters` parameters; make(builder, p) gives its value.
template <typename Make>
functions::FunctionRef function(int parameters, Make make) {
  FunctionBuilder b(parameters);
  std::vector<Value> p;
  for (int i = 0; i < parameters; ++i) p.push_back(b.parameter(i));
  return std::make_shared<const functions::Function>(b.finish(make(b, p)));
}
/// sin x cos y + sin y cos z + sin z cos x, with coordinates times k.
functions::FunctionRef gyroid(double k) {
  return function(3, [&](FunctionBuilder& b, const std::vector<Value>& p) {
    const auto wave = [&](Op op, std::size_t i) {
      return b.op(op, b.op(Op::multiply, p[i], b.constant(k)));
    };
    const auto term = [&](std::size_t i, std::size_t j) {
      return b.op(Op::multiply, wave(Op::sine, i), wave(Op::cosine, j));
    };
    return b.op(Op::add, b.op(Op::add, term(0, 1), term(1, 2)), term(2, 0));
  });
}
functions::FunctionRef radius() {
  return function(3, [](FunctionBuilder& b, const std::vector<Value>& p) {
    const auto sum = b.op(Op::add, b.op(Op::add, b.op(Op::square, p[0]), b.op(Op::square, p[1])),
                          b.op(Op::square, p[2]));
    return b.op(Op::square_root, sum);
  });
}
IsosurfaceShape shape_of(functions::FunctionRef f, double threshold, double half = 1) {
  auto s = std::make_shared<scene::Isosurface>();
  s->function = std::move(f);
  s->threshold = threshold;
  s->container.lo = dvec3(-half);
  s->container.hi = dvec3(half);
  return IsosurfaceShape(shared_isosurface_data(s, 2));
}

}  // namespace

TEST_CASE("isosurface: a ball has the roots of a ball", "[tracer][isosurface]") {
  const IsosurfaceShape ball = shape_of(radius(), 0.7);
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const dvec3 o = point_in_cube(random, 3);
    const dvec3 d = glm::normalize(point_in_cube(random, 0.8) - o);
    const double middle = -glm::dot(o, d);
    const dvec3 miss = o + middle * d;
    const double h2 = 0.49 - glm::dot(miss, miss);
    if (std::abs(h2) < 1e-6) continue;  // tangent
    Crossings all;
    ball.crossings({o, d}, all);
    CAPTURE(h2);
    REQUIRE(all.size() == (h2 > 0 ? 2U : 0U));
    if (h2 < 0) continue;
    CHECK(all[0].t == Approx(middle - std::sqrt(h2)).margin(1e-9));
    CHECK(all[1].t == Approx(middle + std::sqrt(h2)).margin(1e-9));
  }
}

TEST_CASE("isosurface: no crossing of a gyroid is lost", "[tracer][isosurface]") {
  const double k = GENERATE(4.0, 17.0);
  const functions::FunctionRef f = gyroid(k);
  const IsosurfaceShape shape = shape_of(f, 0.1);
  functions::Workspace w;
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const dvec3 o = point_in_cube(random, 1);
    const dvec3 d = glm::normalize(point_in_cube(random, 1) - o);
    Crossings all;
    shape.crossings({o, d}, all);
    // Signs along the line must be those that the crossings tell.
    std::size_t next = 0;
    bool inside = false;
    for (int s = -2000; s < 2000; ++s) {
      const double t = s * 1.73e-3;
      const dvec3 p = o + t * d;
      while (next < all.size() && all[next].t <= t) inside = all[next++].side == Side::enter;
      const bool in_box = Bounds3{dvec3(-1), dvec3(1)}.contains(p);
      const double g = functions::evaluate(*f, std::array{p.x, p.y, p.z}, w) - 0.1;
      if (std::abs(g) < 1e-5) continue;
      REQUIRE(inside == (in_box && g <= 0));
    }
  }
}

TEST_CASE("isosurface: roots do not depend on where the search begins", "[tracer][isosurface]") {
  const IsosurfaceShape shape = shape_of(gyroid(9), 0);
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const dvec3 o = point_in_cube(random, 2);
    const Ray ray{o, glm::normalize(point_in_cube(random, 1) - o)};
    Crossings all;
    shape.crossings(ray, all);
    for (const Crossing& c : all) {
      const auto hit = shape.nearest(ray, c.t - 1e-4, 100);
      REQUIRE(hit.has_value());
      CHECK(hit->t == c.t);
    }
  }
}

TEST_CASE("isosurface: the normal is a difference over one accuracy", "[tracer][isosurface]") {
  // The oracle's reference hit of x² + y² + z² - 0.5 at <0, 0, -0.7060> (objects §10.13).
  const IsosurfaceShape ball = shape_of(
      function(3,
               [](FunctionBuilder& b, const std::vector<Value>& p) {
                 return b.op(Op::add,
                             b.op(Op::add, b.op(Op::square, p[0]), b.op(Op::square, p[1])),
                             b.op(Op::square, p[2]));
               }),
      0.5);
  const dvec3 n = glm::normalize(ball.normal({0, 0, -0.706054688}, 0));
  CHECK(n.x == Approx(0.000708662).margin(1e-8));
  CHECK(n.z == Approx(-0.9999995).margin(1e-7));
}

TEST_CASE("isosurface: a function from outside is sampled, and its slope told",
          "[tracer][isosurface]") {
  functions::External e;
  e.name = "steep";
  e.point = [](const void*, const functions::Context&, const double* p, double* out) {
    *out = 5 * p[2] - 1;
  };
  const IsosurfaceShape shape =
      shape_of(std::make_shared<const functions::Function>(functions::make_external_function(e)), 0);
  const auto hit = shape.nearest({{0.1, 0.2, -3}, {0, 0, 1}}, 0, 100);
  REQUIRE(hit.has_value());
  CHECK(hit->t == Approx(2.0));  // the container's face: it is solid below
  const auto root = shape.nearest({{0.1, 0.2, 3}, {0, 0, -1}}, 0, 100);
  REQUIRE(root.has_value());
  CHECK(root->t == Approx(2.8).margin(1e-9));
  CHECK(shape.doubt().first.find("slopes of 5.000") != std::string::npos);
  CHECK(shape.doubt().second == "write `max_gradient 5.000`");
}

TEST_CASE("parametric: hits lie on the surface, and are all there", "[tracer][parametric]") {
  auto s = std::make_shared<scene::Parametric>();
  s->functions = {function(2, [](FunctionBuilder&, const std::vector<Value>& p) { return p[0]; }),
                  function(2, [](FunctionBuilder&, const std::vector<Value>& p) { return p[1]; }),
                  function(2, [](FunctionBuilder& b, const std::vector<Value>& p) {
                    return b.op(Op::multiply, p[0], p[1]);
                  })};
  s->from = dvec2(-0.9);
  s->to = dvec2(0.9);
  const ParametricShape saddle(shared_parametric_data(s, 2));
  Random random(6);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const dvec3 o = point_in_cube(random, 3);
    const dvec3 d = glm::normalize(point_in_cube(random, 0.9) - o);
    // z = x y along the line: a quadratic.
    const double a = d.x * d.y;
    const double b = o.x * d.y + o.y * d.x - d.z;
    const double c = o.x * o.y - o.z;
    const double disc = b * b - 4 * a * c;
    std::vector<double> expected;
    bool close_call = std::abs(disc) < 1e-4;
    for (const int side : {-1, 1}) {
      const double t = (-b + side * std::sqrt(std::max(disc, 0.0))) / (2 * a);
      const dvec3 p = o + t * d;
      const double edge = std::max(std::abs(p.x), std::abs(p.y)) - 0.9;
      close_call = close_call || std::abs(edge) < 1e-6;
      if (disc > 0 && edge < 0) expected.push_back(t);
    }
    if (close_call) continue;
    std::sort(expected.begin(), expected.end());
    Crossings all;
    saddle.crossings({o, d}, all);
    std::sort(all.begin(), all.end(), [](auto& x, auto& y) { return x.t < y.t; });
    std::vector<double> found;
    for (const Crossing& x : all) {
      if (found.empty() || x.t - found.back() > 1e-7) found.push_back(x.t);
    }
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(found[k] == Approx(expected[k]).margin(1e-7));
      const dvec2 uv = saddle.uv(o + found[k] * d, all[k].part);
      CHECK(uv.x == Approx(o.x + found[k] * d.x).margin(1e-6));
      ++hits;
    }
  }
  CHECK(hits > 1000);
}

}  // namespace durer::tracer::test

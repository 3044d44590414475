// Sixteen lines that walk through a function's cells together, against the same lines one by one.
#include <cmath>
#include <limits>

#include "functions/builder.h"
#include "tests/unit/tracer_geometry/scenes.h"
#include "tracer/primitives/container.h"
#include "tracer/primitives/field_packet.h"
#include "tracer/primitives/isosurface_shape.h"

namespace durer::tracer::test {
namespace {

using functions::FunctionBuilder;
using functions::Op;
using functions::Value;
using scene::Container;

/// Sine and cosine of coordinates times k.
struct Waves {
  Waves(FunctionBuilder& b, double k) {
    for (int i = 0; i < 3; ++i) {
      const Value angle = b.op(Op::multiply, b.parameter(i), b.constant(k));
      sine.push_back(b.op(Op::sine, angle));
      cosine.push_back(b.op(Op::cosine, angle));
    }
  }
  std::vector<Value> sine, cosine;
};
Value gyroid(FunctionBuilder& b) {
  const Waves w(b, 6);
  const auto term = [&](std::size_t i, std::size_t j) {
    return b.op(Op::multiply, w.sine[i], w.cosine[j]);
  };
  return b.op(Op::add, b.op(Op::add, term(0, 1), term(1, 2)), term(2, 0));
}
Value sheet(FunctionBuilder& b) {  // with edges where it is not smooth
  return b.op(Op::subtract, b.op(Op::absolute, gyroid(b)), b.constant(0.15));
}
Value ball(FunctionBuilder& b) {
  const auto squares =
      b.op(Op::add, b.op(Op::square, b.parameter(0)), b.op(Op::square, b.parameter(1)));
  const auto r = b.op(Op::square_root, b.op(Op::add, squares, b.op(Op::square, b.parameter(2))));
  return b.op(Op::subtract, r, b.constant(0.8));
}
Value steps(FunctionBuilder& b) {  // jumps, but not at faces
  const auto stair = b.op(Op::floor, b.op(Op::multiply, b.parameter(0), b.constant(2.9)));
  return b.op(Op::subtract,
              b.op(Op::add, b.parameter(1), b.op(Op::multiply, stair, b.constant(0.2))),
              b.constant(0.1));
}
Value half_defined(FunctionBuilder& b) {  // not a number where x < 0, which takes long
  return b.op(Op::subtract, b.op(Op::square_root, b.parameter(0)), b.constant(0.5));
}
Value everywhere(FunctionBuilder& b) { return b.constant(-1); }
Value nowhere(FunctionBuilder& b) { return b.constant(1); }

struct Sample {
  std::shared_ptr<scene::Isosurface> surface = std::make_shared<scene::Isosurface>();
  std::shared_ptr<const IsosurfaceData> data;
  IsosurfaceShape shape;

  Sample(Value (*make)(FunctionBuilder&), Container::Kind kind, bool open)
      : data(shared_isosurface_data(fill(make, kind, open), 2)), shape(data) {}

  std::shared_ptr<scene::Isosurface> fill(Value (*make)(FunctionBuilder&), Container::Kind kind,
                                          bool open) {
    FunctionBuilder b(3);
    surface->function = std::make_shared<const functions::Function>(b.finish(make(b)));
    surface->open = open;
    surface->container.kind = kind;
    surface->container.lo = {-1, -0.8, -1};
    surface->container.hi = {1, 0.9, 1.2};
    surface->container.centre = {0.1, 0, 0};
    surface->container.radius = 1.1;
    return surface;
  }
};

struct TestRay {
  Ray ray;
  double t_from, t_to;
};
using Answers = std::vector<std::optional<Nearest>>;

PacketRays packet_of(const std::vector<TestRay>& rays) {
  PacketRays packet;
  for (const TestRay& r : rays) packet.add(r.ray, r.t_from, r.t_to);
  packet.fill_up();
  return packet;
}
Answers answers(const PacketHits& hits, std::size_t count) {
  Answers all(count);
  for (std::size_t i = 0; i < count; ++i) {
    if ((hits.met >> i & 1) != 0) all[i] = Nearest{hits.t[i], hits.part[i]};
  }
  CHECK(hits.met >> count == 0);
  return all;
}
Answers ask(const IsosurfaceShape& shape, const std::vector<TestRay>& rays, bool any) {
  PacketHits hits;
  shape.nearest(packet_of(rays), any, hits);
  return answers(hits, rays.size());
}

/// Rays from about one place in about one direction; some begin inside, end early, or run along an
/// axis or a face of the box.
std::vector<TestRay> bundle(Random& random) {
  std::vector<TestRay> rays;
  const bool from_inside = random() % 3 == 0;
  const dvec3 o = from_inside ? point_in_cube(random, 0.8) : 4.0 * direction(random);
  const dvec3 d = from_inside ? direction(random) : point_in_cube(random, 1) - o;
  const double spread = random() % 2 == 0 ? 0.02 : 0.5;
  const double unit = random() % 2 == 0 ? 1 : 3.7;  // |d| is anything
  const std::size_t count = 1 + random() % most_in_packet;
  for (std::size_t i = 0; i < count; ++i) {
    TestRay r{{o, unit * glm::normalize(d + point_in_cube(random, spread))}, 1e-7, 1e7};
    if (random() % 8 == 0) r.t_to = uniform(random, 0.1, 5) / unit;
    if (random() % 8 == 0) r.t_from = uniform(random, 0.1, 4) / unit;
    if (random() % 16 == 0) r.ray = {{uniform(random, -1.1, 1.1), -3, 0.3}, {0, unit, -0.0}};
    if (random() % 16 == 0) r.ray = {{-1, 0.2, -3}, {random() % 2 == 0 ? 0.0 : -0.0, 0, unit}};
    rays.push_back(r);
  }
  return rays;
}

bool known(const Sample& sample, const TestRay& ray, double t) {
  functions::Workspace w;
  const dvec3 p = ray.ray.at(t);
  return std::abs(functions::evaluate(*sample.surface->function, std::array{p.x, p.y, p.z}, w)) >
         1e-4;
}

}  // namespace

TEST_CASE("field packet: the same as one by one", "[tracer][isosurface][packet]") {
  const auto make = GENERATE(gyroid, sheet, ball, steps, half_defined, everywhere, nowhere);
  const auto kind = GENERATE(Container::Kind::box, Container::Kind::sphere);
  const bool open = GENERATE(false, true);
  const Sample sample(make, kind, open);
  REQUIRE(sample.data->field.has_bounds());
  Random random(11);
  std::size_t asked = 0;
  std::size_t unlike = 0;
  for (int round = 0; round < (make == half_defined ? 3 : 200); ++round) {
    const std::vector<TestRay> rays = bundle(random);
    const Answers hits = ask(sample.shape, rays, false);
    const Answers shadows = ask(sample.shape, rays, true);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto alone = sample.shape.nearest(rays[i].ray, rays[i].t_from, rays[i].t_to);
      ++asked;
      CHECK(shadows[i].has_value() == hits[i].has_value());
      const double t = glm::length(rays[i].ray.d) *
                       std::abs((alone ? alone->t : 0) - (hits[i] ? hits[i]->t : 0));
      if (alone.has_value() == hits[i].has_value() && t < 1e-6) {
        if (alone) CHECK(alone->part == hits[i]->part);
        continue;
      }
      // Lines that graze the surface may meet it or not, as long as what comes before is one side.
      ++unlike;
      const auto& first = alone && (!hits[i] || alone->t < hits[i]->t) ? alone : hits[i];
      CAPTURE(round, i, alone ? alone->t : -1, hits[i] ? hits[i]->t : -1);
      CHECK_FALSE(known(sample, rays[i], first->t));
    }
  }
  CAPTURE(asked);
  CHECK(unlike < asked / 500 + 2);
}

TEST_CASE("field packet: the same bits with all instruction sets", "[tracer][isosurface][packet]") {
  const auto make = GENERATE(gyroid, sheet, ball, steps, half_defined);
  const bool any = GENERATE(false, true);
  const Sample sample(make, Container::Kind::box, false);
  Random random(12);
  for (int round = 0; round < (make == half_defined ? 3 : 200); ++round) {
    const std::vector<TestRay> rays = bundle(random);
    const PacketRays packet = packet_of(rays);
    std::vector<Answers> all;
    for (const FieldWalkVersion walk : field_walks()) {
      PacketHits hits;
      FieldPacket(sample.data->field, *sample.surface, 1e-5, any, packet, hits).run(walk);
      all.push_back(answers(hits, rays.size()));
    }
    for (const Answers& answer : all) {
      for (std::size_t i = 0; i < rays.size(); ++i) {
        REQUIRE(answer[i].has_value() == all[0][i].has_value());
        if (!answer[i]) continue;
        CHECK(answer[i]->t == all[0][i]->t);
        CHECK(answer[i]->part == all[0][i]->part);
      }
    }
  }
}

TEST_CASE("field packet: an answer does not depend on neighbours", "[tracer][isosurface][packet]") {
  const Sample sample(gyroid, Container::Kind::sphere, true);
  Random random(13);
  for (int round = 0; round < 100; ++round) {
    const std::vector<TestRay> rays = bundle(random);
    const Answers hits = ask(sample.shape, rays, false);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto alone = ask(sample.shape, {rays[i]}, false).front();
      REQUIRE(alone.has_value() == hits[i].has_value());
      if (alone) CHECK(alone->t == hits[i]->t);
    }
  }
}

TEST_CASE("field packet: normals side by side have the bits of each",
          "[tracer][isosurface][packet]") {
  const auto make = GENERATE(gyroid, sheet, ball, everywhere);
  const auto kind = GENERATE(Container::Kind::box, Container::Kind::sphere);
  const Sample sample(make, kind, false);
  Random random(14);
  for (int round = 0; round < 50; ++round) {
    PacketPoints points;
    const std::size_t count = 1 + random() % most_in_packet;
    for (std::size_t i = 0; i < count; ++i) {
      const auto side = static_cast<std::uint32_t>(1 + random() % 6);
      const std::uint32_t face = kind == Container::Kind::box ? side : sphere_part;
      points.add(point_in_cube(random, 1), random() % 4 == 0 ? face : 0);
    }
    points.fill_up();
    PacketVectors normals;
    sample.shape.normals(points, normals);
    for (std::size_t i = 0; i < count; ++i) {
      CHECK(normals[i] == sample.shape.normal(points.p[i], points.part[i]));
    }
    normalize(normals, count);
    for (std::size_t i = 0; i < count; ++i) {
      CHECK(normals[i] == glm::normalize(sample.shape.normal(points.p[i], points.part[i])));
    }
  }
}

TEST_CASE("field packet: rays that make no sense meet nothing", "[tracer][isosurface][packet]") {
  const Sample sample(ball, Container::Kind::box, false);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::vector<TestRay> rays{
      {{{nan, 0, 0}, {0, 0, 1}}, 0, 10}, {{{0, 0, -3}, {nan, 0, 1}}, 0, 10},
      {{{0, 0, -3}, {0, 0, 0}}, 0, 10},  {{{0, inf, -3}, {0, 0, 1}}, 0, 10},
      {{{0, 0, -3}, {0, 0, 1}}, 5, 4},   {{{0.1, 0.2, -3}, {0, 0, 1}}, 0, 10}};
  const Answers hits = ask(sample.shape, rays, false);
  for (std::size_t i = 0; i + 1 < rays.size(); ++i) CHECK_FALSE(hits[i].has_value());
  CHECK(hits.back().has_value());
}

}  // namespace durer::tracer::test

// Plain points that are lit side by side, against the same points one by one.
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/catch.h"
#include "tracer/random.h"
#include "tracer/transport/plain_lanes.h"

namespace durer::tracer {
namespace {

using Mask = PlainPoints::Mask;

dvec3 in_ball(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  const double x = number(random);
  const double y = number(random);
  return {x, y, number(random)};
}
void put(const dvec3& v, PlainPoints::Vectors<double>& to, std::size_t i) {
  for (std::size_t k = 0; k < 3; ++k) to[k][i] = v[static_cast<int>(k)];
}
dvec3 at(const PlainPoints::Vectors<double>& v, std::size_t i) {
  return {v[0][i], v[1][i], v[2][i]};
}

/// Seeded points; `count` of them count.
PlainPoints some_points(const Finish& finish, std::size_t count) {
  std::mt19937 random(7);
  PlainPoints points;
  points.finish = &finish;
  points.count = count;
  for (std::size_t i = 0; i < PlainPoints::size; ++i) {
    put(3.0 * in_ball(random), points.p(), i);
    const dvec3 d = glm::normalize(in_ball(random));
    const dvec3 n = glm::normalize(in_ball(random));
    put(d, points.d, i);
    put(glm::dot(n, d) > 0 ? -n : n, points.n, i);
    for (std::size_t k = 0; k < 3; ++k) {
      points.pigment[k][i] = static_cast<float>(random() % 100) / 100;
      points.lit[k][i] = static_cast<float>(k);
    }
    points.noise[i] = static_cast<std::uint32_t>(i);
  }
  return points;
}

/// One point as Tracer::shade_from() lights it.
vec3 one_by_one(const PlainPoints& points, const Light& lamp, const PlainBeam& beam,
                std::size_t i) {
  const Finish& f = *points.finish;
  const dvec3 n = at(points.n, i);
  const dvec3 d = at(points.d, i);
  const vec3 pigment(points.pigment[0][i], points.pigment[1][i], points.pigment[2][i]);
  const Incidence in = incidence(lamp, at(points.p(), i));
  const vec3 light = beam.shares != nullptr ? beam.colour * beam.shares[i] : beam.colour;
  const double cosine = glm::dot(n, in.l);
  vec3 sum(0.0F);
  if (beam.diffuse > 0) {
    float intensity = static_cast<float>(f.brilliance.of(std::abs(cosine))) * beam.diffuse;
    std::uint32_t noise = points.noise[i];
    if (f.crand > 0) intensity -= random_unit(noise) * f.crand;
    sum = intensity * pigment * light;
  }
  if (f.highlights && beam.highlights) sum += highlight(f, d, n, in.l, pigment) * light;
  if (f.irid > 0) sum *= iridescence(f, at(points.p(), i), cosine, glm::dot(n, d));
  return vec3(points.lit[0][i], points.lit[1][i], points.lit[2][i]) + sum;
}

scene::Finish finish_number(int number) {
  scene::Finish f;
  if (number == 1) f.phong = 0.4F;
  if (number == 2) f.phong = 0.4F, f.phong_size = 70.5F, f.metallic = 0.8F, f.brilliance = 2.5F;
  if (number == 3) f.specular = 0.5F, f.roughness = 0.05F, f.crand = 0.3F, f.brilliance = 3;
  if (number == 4) f.phong = 0.2F, f.specular = 0.5F, f.roughness = 0.3F, f.irid = 0.4F;
  if (number == 5) f.diffuse = 0, f.specular = 1, f.roughness = 0.5F;
  return f;
}

void check(const Finish& finish, std::size_t count, const Light& lamp, const PlainBeam& beam,
           Mask lit) {
  const PlainPoints before = some_points(finish, count);
  for (const PlainLanes& lanes : plain_lanes()) {
    PlainPoints points = before;
    lanes.aim(points, lamp);
    lanes.shade(points, beam, lit);
    for (std::size_t i = 0; i < count; ++i) {
      CAPTURE(i);
      const Incidence in = incidence(lamp, at(points.p(), i));
      CHECK(at(points.l(), i) == in.l);
      CHECK(points.distance[i] == in.distance);
      CHECK((points.apart >> i & 1) == 1);
      CHECK((points.facing >> i & 1) == (glm::dot(at(points.n, i), in.l) < epsilon ? 0 : 1));
      const vec3 seen(points.lit[0][i], points.lit[1][i], points.lit[2][i]);
      const bool is_lit = (lit >> i & 1) != 0;
      CHECK(seen == (is_lit ? one_by_one(before, lamp, beam, i) : vec3(0, 1, 2)));
    }
  }
}

}  // namespace

TEST_CASE("plain lanes: points are lit as one by one, to the last bit", "[tracer][finish]") {
  const int number = GENERATE(range(0, 6));
  const bool parallel = GENERATE(false, true);
  CAPTURE(number, parallel);
  const Finish finish = compile_finish(finish_number(number), vec3(1), {0.7F, 0.52F, 0.48F});
  scene::Light in;
  in.position = {5, 6, -7};
  in.point_at = {0, 1, 0};
  in.parallel = parallel;
  const Light lamp = compile_light(in);
  PlainPoints::PerPoint<float> shares;
  for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = static_cast<float>(i) / 10;
  const vec3 colour(1, 0.7F, 0.3F);
  check(finish, 16, lamp, {colour, nullptr, finish.diffuse, true}, 0xFFFF);
  check(finish, 11, lamp, {colour, shares.data(), finish.diffuse, true}, 0x5D3);
  check(finish, 3, lamp, {colour, nullptr, 0.2F, false}, 7);
}

TEST_CASE("plain lanes: a lamp at a point does not light it", "[tracer][finish]") {
  const Finish finish = compile_finish({}, vec3(1), vec3(1));
  for (const PlainLanes& lanes : plain_lanes()) {
    PlainPoints points = some_points(finish, 5);
    Light lamp;
    lamp.position = at(points.p(), 2);
    lanes.aim(points, lamp);
    CHECK((points.apart & 31) == 27);
  }
}

}  // namespace durer::tracer

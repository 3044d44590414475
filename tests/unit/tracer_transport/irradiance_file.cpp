#include "tracer/transport/irradiance_file.h"

#include <glm/geometric.hpp>

#include "tests/support/catch.h"

using namespace durer;
using namespace durer::tracer;

namespace {
// As POV-Ray 3.7 writes them.
constexpr std::string_view oracle_lines =
    "C2\t-2.9\t1.69058\t-2.7381\tfe7f7f\t0.0365\t0.0324\t0.0264\t0.287688\t0.1666\t9d7f04\n"
    "C1\t-0.270706\t1.60059\t1.45966\ta7e9b7\t0.0000\t0.0000\t0.0000\t1.7775\t1.3021\t7afe86\n";
}  // namespace

TEST_CASE("gathered light: the oracle's lines are read", "[tracer][radiosity]") {
  const auto samples = decode_samples(oracle_lines);
  REQUIRE(samples);
  REQUIRE(samples->size() == 2);
  const IrradianceSample& s = samples->front();
  CHECK(s.depth == 1);
  CHECK(s.p.y == Approx(1.69058));
  CHECK(s.n.x == Approx(1));
  CHECK(s.light.x == Approx(0.0365));
  CHECK(s.radius == Approx(0.287688));
  CHECK(s.nearest == Approx(0.1666));
  CHECK(glm::length(s.to_nearest) == Approx(1));
  CHECK(s.quality == 1);
  CHECK(samples->back().depth == 0);
}

TEST_CASE("gathered light: what is written again is the same text", "[tracer][radiosity]") {
  const auto samples = decode_samples(oracle_lines);
  REQUIRE(samples);
  const auto again = decode_samples(encode_samples(*samples));
  REQUIRE(again);
  REQUIRE(again->size() == 2);
  CHECK(again->front().p == samples->front().p);
  CHECK(again->front().light == samples->front().light);
  CHECK(again->front().radius == samples->front().radius);
  CHECK(glm::distance(again->front().to_nearest, samples->front().to_nearest) < 0.02);
}

TEST_CASE("gathered light: anything else is refused", "[tracer][radiosity]") {
  CHECK(decode_samples("")->empty());
  CHECK_FALSE(decode_samples("P3\n1 1\n255\n"));
  CHECK_FALSE(decode_samples("C1\t0\t0\n"));
  CHECK_FALSE(decode_samples(std::string(oracle_lines) + "C1\t0"));
  CHECK_FALSE(decode_samples("C0\t0\t0\t0\tfe7f7f\t0\t0\t0\t1\t1\t9d7f04\n"));
  CHECK_FALSE(decode_samples("C1\tnan\t0\t0\tfe7f7f\t0\t0\t0\t1\t1\t9d7f04\n"));
}

#include "tracer/transport/photon_map.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "tests/support/catch.h"
#include "tracer/random.h"

using namespace durer;
using namespace durer::tracer;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// Some in a plane, some in a knot, some alone.
std::vector<Photon> photons(std::size_t count) {
  std::uint32_t random = 5;
  const auto next = [&] { return static_cast<float>(next_random(random)); };
  std::vector<Photon> all;
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 p(next(), next(), next());
    const vec3 at = i % 3 == 0 ? vec3(p.x, 0, p.z) : i % 3 == 1 ? vec3(0.5F) + 0.01F * p : p;
    all.push_back({at, vec3(1.0F), vec3(0, 1, 0)});
  }
  return all;
}

double measured(const Photon& photon, const PhotonQuery& q) {
  const dvec3 v = dvec3(photon.p) - q.p;
  return std::sqrt(glm::dot(v, v) * (1 + 16 * std::abs(glm::dot(v, q.n))));
}

std::vector<double> by_asking_all(const PhotonMap& map, const PhotonQuery& q) {
  std::vector<double> all;
  for (std::uint32_t i = 0; i < map.size(); ++i) {
    if (const double d = measured(map[i], q); d < q.radius) all.push_back(d);
  }
  std::sort(all.begin(), all.end());
  if (all.size() > q.most) all.resize(q.most);
  return all;
}

std::vector<std::uint32_t> answer(const PhotonMap& map, const PhotonQuery& query,
                                  FoundPhotons& found) {
  map.nearest(query, found);
  return {found.photons().begin(), found.photons().end()};
}

}  // namespace

TEST_CASE("photon map: finds whom a look at every photon finds", "[tracer][photons]") {
  const std::size_t count = GENERATE(1, 7, 8, 9, 100, 3000);
  const std::size_t most = GENERATE(1, 20, 100);
  const double radius = GENERATE(0.05, 0.3, 5.0, endless);
  const dvec3 n = GENERATE(dvec3(0.0), dvec3(0, 1, 0));
  CAPTURE(count, most, radius, n.y);
  const PhotonMap map(photons(count));
  REQUIRE(map.size() == count);
  FoundPhotons found;
  for (const dvec3 p : {dvec3(0.5, 0, 0.5), dvec3(0.5), dvec3(2, 2, 2)}) {
    const PhotonQuery query{p, n, most, radius};
    const std::vector<std::uint32_t> all = answer(map, query, found);
    const std::vector<double> expected = by_asking_all(map, query);
    REQUIRE(all.size() == expected.size());
    CHECK(std::is_sorted(all.begin(), all.end()));
    std::vector<double> distances;
    for (std::size_t i = 0; i < all.size(); ++i) {
      distances.push_back(std::sqrt(found.distances2[i]));
      CHECK(distances.back() == Approx(measured(map[all[i]], query)).epsilon(1e-4).margin(1e-6));
    }
    std::sort(distances.begin(), distances.end());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CHECK(distances[i] == Approx(expected[i]).epsilon(1e-4).margin(1e-6));
    }
    CHECK(found.radius <= radius);
    if (all.size() < most) CHECK(found.radius == radius);
  }
}

TEST_CASE("photon map: answers do not depend on what was asked before", "[tracer][photons]") {
  const PhotonMap map(photons(5000));
  const float remembered = GENERATE(0.0F, 1e-6F, 0.01F, 0.2F, 1e6F);
  const double radius = GENERATE(0.05, 0.4, endless);
  CAPTURE(remembered, radius);
  FoundPhotons used;
  for (FoundPhotons::Hint& hint : used.hints) hint.radius = remembered;
  used.last_radius = remembered;
  std::uint32_t random = 77;
  for (int i = 0; i < 300; ++i) {
    const dvec3 p(next_random(random), i % 2 == 0 ? 0 : next_random(random), next_random(random));
    const PhotonQuery query{p, i % 3 == 0 ? dvec3(0.0) : dvec3(0, 1, 0), 60, radius};
    FoundPhotons unused;
    const std::vector<std::uint32_t> expected = answer(map, query, unused);
    CHECK(answer(map, query, used) == expected);
    CHECK(used.radius == unused.radius);
  }
}

TEST_CASE("photon map: of those equally far the first ones are taken", "[tracer][photons]") {
  std::vector<Photon> all;
  for (int i = 0; i < 400; ++i) {  // a knot, and rings around it
    const float r = static_cast<float>(i / 100);
    const vec3 p = i % 2 == 0 ? vec3(r, 0, 0) : vec3(0, 0, r);
    all.push_back({p, vec3(1.0F), vec3(0, 1, 0)});
  }
  const PhotonMap map(all);
  const std::size_t most = GENERATE(1, 50, 100, 130, 250);
  const PhotonQuery query{dvec3(0.0), dvec3(0.0), most, 10};
  FoundPhotons found;
  const std::vector<std::uint32_t> taken = answer(map, query, found);
  REQUIRE(taken.size() == most);
  std::vector<std::pair<double, std::uint32_t>> sorted;
  for (std::uint32_t i = 0; i < map.size(); ++i) sorted.emplace_back(measured(map[i], query), i);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> expected;
  for (std::size_t i = 0; i < most; ++i) expected.push_back(sorted[i].second);
  std::sort(expected.begin(), expected.end());
  CHECK(taken == expected);
}

TEST_CASE("photon map: nothing is found in an empty one", "[tracer][photons]") {
  const PhotonMap map;
  FoundPhotons found;
  CHECK(answer(map, {dvec3(0.0), dvec3(0.0), 10, 1}, found).empty());
  CHECK(found.radius == 1);
  CHECK(usual_radius(map, 10, true) == 0);
}

TEST_CASE("photon map: photons at one place do no harm", "[tracer][photons]") {
  const PhotonMap map(std::vector<Photon>(500, Photon{vec3(1.0F), vec3(1.0F), vec3(0, 1, 0)}));
  FoundPhotons found;
  CHECK(answer(map, {dvec3(1.0), dvec3(0.0), 100, 1}, found).size() == 100);
  CHECK(found.radius == 0);
  CHECK(usual_radius(map, 100, true) == 0);
}

TEST_CASE("gathering: a wider search counts where photons stay as dense, or are few",
          "[tracer][photons]") {
  std::vector<Photon> all;
  for (int i = 0; i < 200; ++i) {  // evenly around the origin, outside of a hole
    const double angle = i * 2.4;
    const double r = 0.5 + 0.1 * std::sqrt(i);
    all.push_back({vec3(dvec3(r * std::cos(angle), 0, r * std::sin(angle))), vec3(1.0F),
                   vec3(0, 1, 0)});
  }
  const PhotonMap map(all);
  PhotonGathering how;
  how.radius = 0.4;
  how.least = 5;
  how.expand_increase = 0;
  FoundPhotons found;
  SECTION("too many of them: the first search stands") {
    gather(map, how, dvec3(0.0), dvec3(0, 1, 0), found);
    CHECK(found.photons().empty());
    CHECK(found.radius == Approx(0.4));
  }
  SECTION("few enough: they count") {
    how.expand_min = 1000;
    gather(map, how, dvec3(0.0), dvec3(0, 1, 0), found);
    CHECK(!found.photons().empty());
    CHECK(found.radius == Approx(1.2));
  }
}

TEST_CASE("usual radius: holds the wanted number where photons are even", "[tracer][photons]") {
  std::uint32_t random = 9;
  std::vector<Photon> all;
  for (int i = 0; i < 20000; ++i) {
    const auto x = static_cast<float>(next_random(random));
    const auto z = static_cast<float>(next_random(random));
    all.push_back({vec3(x, 0, z), vec3(1.0F), vec3(0, 1, 0)});
  }
  const double r = usual_radius(PhotonMap(all), 100, true);
  const double even = std::sqrt(100 / (20000 * 3.14159265358979));
  // Those near the edges see fewer around them, which widens it a little.
  CHECK(r > 0.9 * even);
  CHECK(r < 4 * even);
}

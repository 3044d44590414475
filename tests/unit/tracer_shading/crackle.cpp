// Crackle against a search of all the cubes, and its wide inner loop against the narrow one.
#include "tracer/patterns/crackle.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "functions/noise.h"
#include "tests/support/catch.h"
#include "tracer/patterns/patterns.h"

using namespace durer;
using namespace durer::tracer;
using functions::simd::Smallest3;

namespace {

const PatternType& crackle() {
  const auto types = pattern_types();
  return **std::find_if(types.begin(), types.end(),
                        [](const PatternType* type) { return type->name == "crackle"; });
}

double evaluate(double metric, dvec3 form, double offset, dvec3 p) {
  const std::vector<double> args{0, form.x, form.y, form.z, metric, metric, metric, offset};
  PatternState state;
  crackle().prepare(args, {}, state);
  return crackle().evaluate(state, p, nullptr);
}

// Textures §5.1, word by word.
double expected(double metric, dvec3 form, double offset, dvec3 p) {
  std::vector<double> powers;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        if ((std::abs(x) == 2) + (std::abs(y) == 2) + (std::abs(z) == 2) > 1) continue;
        const int c[3] = {static_cast<int>(std::floor(p.x - 1e-10)) + x,
                          static_cast<int>(std::floor(p.y - 1e-10)) + y,
                          static_cast<int>(std::floor(p.z - 1e-10)) + z};
        const auto s = static_cast<unsigned>(functions::hash3(c[0], c[1], c[2]));
        double sum = 0;
        for (unsigned i = 0; i < 3; ++i) {
          sum += std::pow(std::abs(c[i] + functions::uniform_table(s + i) - p[static_cast<int>(i)]),
                          metric);
        }
        powers.push_back(sum);
      }
    }
  }
  std::sort(powers.begin(), powers.end());
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    sum += form[i] * std::pow(powers[static_cast<std::size_t>(i)] + std::pow(offset, metric),
                              1 / metric);
  }
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace

TEST_CASE("crackle: cells that are kept and cubes left out change no value",
          "[tracer][patterns][crackle]") {
  std::mt19937 random(5);
  const double metric = GENERATE(0.6, 1.0, 1.5, 2.0, 3.0, 4.0, 8.0, 9.0, 40.0);
  const double offset = GENERATE(0.0, 0.25);
  const dvec3 form = GENERATE(dvec3(-1, 1, 0), dvec3(0.4, 0, 0), dvec3(0, 0, 0.5),
                              dvec3(0.7, -0.9, 0.4));
  std::uniform_real_distribution<double> uniform(-30, 30);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    dvec3 p{uniform(random), uniform(random), uniform(random)};
    if (i % 9 == 0) p = glm::dvec3(std::round(p.x), std::round(p.y), p.z);
    // Twice: the second time the cell is known.
    for (int k = 0; k < 2; ++k, p += dvec3(0.01, 0, -0.02)) {
      worst = std::max(worst, std::abs(evaluate(metric, form, offset, p) -
                                       expected(metric, form, offset, p)));
    }
  }
  CAPTURE(metric, offset, form.x, form.y, form.z);
  CHECK(worst < 1e-12);
}

TEST_CASE("nearest points: every instruction set gives the same bits",
          "[tracer][patterns][crackle]") {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int i = 0; i < 500; ++i) {
    std::vector<double> c[3];
    for (auto& axis : c) {
      for (int k = 0; k < 28; ++k) axis.push_back(uniform(random));
    }
    const functions::simd::PointList points{c[0].data(), c[1].data(), c[2].data(), 4 * (i % 8)};
    const dvec3 p{uniform(random), uniform(random), uniform(random)};
    const int exponent = 1 + i % 5;
    const Smallest3 before{0.1, i % 2 == 0 ? 0.2 : 1e9, 1e9};
    const Smallest3 narrow = smallest_distances(points, p, exponent, before, 0);
    CHECK(narrow == smallest_distances(points, p, exponent, before, 1));
    CHECK(std::is_sorted(narrow.begin(), narrow.end()));

    functions::simd::FourPoints four;
    for (dvec3& q : four) q = {uniform(random), uniform(random), uniform(random)};
    const auto found = smallest_distances(points, four, exponent, 0);
    CHECK(found == smallest_distances(points, four, exponent, 1));
    for (std::size_t k = 0; k < four.size(); ++k) {
      CHECK(found[k] == smallest_distances(points, four[k], exponent));
    }
  }
}

TEST_CASE("crackle: several points at a time have the values of each, bit for bit",
          "[tracer][patterns][crackle]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-3, 3);
  const double metric = GENERATE(1.0, 1.5, 2.0, 3.0);
  const bool solid = GENERATE(false, true);
  const std::vector<double> args{solid ? 1.0 : 0.0, -1, 1, 0.2, metric, metric, metric, 0.1};
  PatternState state;
  crackle().prepare(args, {}, state);
  for (std::size_t count = 1; count < 12; ++count) {
    std::vector<dvec3> points(count);
    for (std::size_t i = 0; i < count; ++i) {
      const bool beside = i % 5 != 0;
      points[i] = beside ? points[i - 1] + 0.05 * dvec3(uniform(random), uniform(random), 0)
                         : dvec3(uniform(random), uniform(random), uniform(random));
    }
    std::vector<double> values(count);
    crackle().evaluate_all(state, points, values.data());
    for (std::size_t i = 0; i < count; ++i) {
      CHECK(values[i] == crackle().evaluate(state, points[i], nullptr));
    }
  }
}

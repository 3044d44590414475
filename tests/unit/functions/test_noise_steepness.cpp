// How steep noise can be at all: the bounds that interval evaluation relies on.
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>
#include <set>
#include <vector>

#include "functions/noise.h"
#include "functions/noise_cell.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::functions;

namespace {

using Row = std::array<double, 4>;

/// All values and gradients that a lattice point of the generator may have.
std::vector<Row> rows_of(NoiseGenerator generator) {
  std::mt19937 rng(21);
  std::uniform_real_distribution<double> u(-2000, 2000);
  std::set<Row> rows;
  for (int i = 0; i < 20000; ++i) {
    const dvec3 p(u(rng), u(rng), u(rng));
    const Cell cell = generator == 3 ? gradient_cell(gradient_lattice(), p.x, p.y, p.z)
                                     : table_cell(p.x, p.y, p.z);
    for (const double* r : cell.row) rows.insert({r[0], r[1], r[2], r[3]});
  }
  return {rows.begin(), rows.end()};
}

/// A place in a cell and a direction.
struct Look {
  dvec3 f;
  dvec3 u;
};

/// The greatest slope along u, and second derivative, that any eight rows at the corners give.
NoiseSteepness greatest(const std::vector<Row>& rows, const Look& look) {
  std::array<std::array<double, 2>, 3> w;   // weights of the lower and the upper corner,
  std::array<std::array<double, 2>, 3> w1;  // and their derivatives
  std::array<std::array<double, 2>, 3> w2;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double f = look.f[i];
    const double s = smooth_step(f);
    const double first = 6 * f * (1 - f) * look.u[i];
    const double second = (6 - 12 * f) * look.u[i] * look.u[i];
    w[k] = {1 - s, s};
    w1[k] = {-first, first};
    w2[k] = {-second, second};
  }
  Interval slope;
  Interval bend;
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      for (std::size_t c = 0; c < 2; ++c) {
        const double weight = w[0][a] * w[1][b] * w[2][c];
        const double first = w1[0][a] * w[1][b] * w[2][c] + w[0][a] * w1[1][b] * w[2][c] +
                             w[0][a] * w[1][b] * w1[2][c];
        const double second = w2[0][a] * w[1][b] * w[2][c] + w[0][a] * w2[1][b] * w[2][c] +
                              w[0][a] * w[1][b] * w2[2][c] +
                              2 * (w1[0][a] * w1[1][b] * w[2][c] + w1[0][a] * w[1][b] * w1[2][c] +
                                   w[0][a] * w1[1][b] * w1[2][c]);
        const dvec3 q = look.f - dvec3(a, b, c);
        Interval one;
        Interval two;
        bool begun = false;
        for (const Row& r : rows) {
          const double value = r[0] + r[1] * q.x + r[2] * q.y + r[3] * q.z;
          const double along = r[1] * look.u.x + r[2] * look.u.y + r[3] * look.u.z;
          const Interval v1(first * value + weight * along);
          const Interval v2(second * value + 2 * first * along);
          one = begun ? hull(one, v1) : v1;
          two = begun ? hull(two, v2) : v2;
          begun = true;
        }
        slope += one;
        bend += two;
      }
    }
  }
  return {std::max(-slope.lo, slope.hi), std::max(-bend.lo, bend.hi)};
}

/// Climbs from random places to the greatest `part` that can be found.
double climb(const std::vector<Row>& rows, double NoiseSteepness::*part) {
  std::mt19937 rng(22);
  std::uniform_real_distribution<double> u(0, 1);
  std::normal_distribution<double> n;
  const auto step = [&](double size) { return size * dvec3(n(rng), n(rng), n(rng)); };
  double best = 0;
  for (int start = 0; start < 12; ++start) {
    Look at{{u(rng), u(rng), u(rng)}, glm::normalize(step(1))};
    double height = greatest(rows, at).*part;
    double size = 0.4;
    for (int i = 0; i < 150; ++i) {
      const Look next{glm::clamp(at.f + step(size), 0.0, 1.0), glm::normalize(at.u + step(size))};
      const double h = greatest(rows, next).*part;
      if (h > height) {
        height = h;
        at = next;
      } else {
        size *= 0.94;
      }
    }
    best = std::max(best, height);
  }
  return best;
}

}  // namespace

TEST_CASE("noise: no choice of lattice points is steeper than the bounds", "[functions][noise]") {
  for (const NoiseGenerator generator : {1, 2, 3}) {
    const std::vector<Row> rows = rows_of(generator);
    const double scale = noise_scale(generator).scale;
    const NoiseSteepness bound = steepest_noise(generator);
    CAPTURE(generator);
    const double slope = scale * climb(rows, &NoiseSteepness::slope);
    const double bend = scale * climb(rows, &NoiseSteepness::bend);
    CHECK(slope <= bound.slope);
    CHECK(bend <= bound.bend);
    CHECK(slope > 0.97 * bound.slope);  // the bounds are not slack
    CHECK(bend > 0.97 * bound.bend);
  }
}

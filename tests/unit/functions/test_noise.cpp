#include <glm/common.hpp>
#include <random>
#include <vector>

#include "functions/noise.h"
#include "functions/noise_tables.h"
#include "functions/simd/noise_bound_kernel.h"
#include "functions/simd/noise_kernels.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::functions;

namespace {

const dvec3 check_points[3] = {{0.1, 0.2, 0.3}, {-1.5, 2.25, 7.75}, {123.4, -56.7, 8.9}};

Approx digits12(double v) { return Approx(v).epsilon(0).margin(6e-13); }

std::vector<dvec3> random_points(std::size_t n, double size) {
  std::mt19937 g(11);
  std::uniform_real_distribution<double> u(-size, size);
  std::vector<dvec3> p(n);
  for (dvec3& v : p) v = {u(g), u(g), u(g)};
  return p;
}

}  // namespace

TEST_CASE("noise tables: first and last entries", "[functions][noise]") {
  const int t[12] = {2291, 2574, 3654, 1557, 1196, 3388, 2637, 1820, 2436, 762, 2037, 3527};
  for (int i = 0; i < 12; ++i) CHECK(permutation[i] == t[i]);
  CHECK(permutation[4095] == 3088);
  const int p[8] = {0, 1, 386, 3, 649, 1576, 1405, 7};
  for (int i = 0; i < 8; ++i) CHECK(gradient_lattice().p[i] == p[i]);
  CHECK(gradient_lattice().gradients[0].c[1] == digits12(0.604425069426));
  CHECK(gradient_lattice().gradients[0].c[2] == digits12(0.705260289544));
  CHECK(gradient_lattice().gradients[0].c[3] == digits12(0.370510808805));
}

TEST_CASE("uniform table: Mersenne twister with the standard seed", "[functions][noise]") {
  CHECK(uniform_table(0) == digits12(0.814723691903));
  CHECK(uniform_table(1) == digits12(0.135477004107));
  CHECK(uniform_table(2) == digits12(0.905791934114));
  CHECK(uniform_table(3) == digits12(0.835008589784));
  CHECK(uniform_table(32767) == digits12(0.752209920669));
  CHECK(uniform_table(32768) == uniform_table(0));
}

TEST_CASE("hash: known values, negative arguments too", "[functions][noise]") {
  CHECK(hash3(0, 0, 0) == 3687);
  CHECK(hash3(-1, 2, -3) == 3458);
}

TEST_CASE("noise: check values of all generators", "[functions][noise]") {
  const double expected[3][3] = {{0.299242909010, 0.417192032657, 0.652260853720},
                                 {0.324719039551, 0.429671663473, 0.623888866084},
                                 {0.102779435589, 0.320953256784, 0.460078517156}};
  for (int i = 0; i < 3; ++i) {
    for (int g = 1; g <= 3; ++g) {
      CAPTURE(i, g);
      CHECK(noise(check_points[i], g) == digits12(expected[i][g - 1]));
    }
  }
}

TEST_CASE("vnoise: check values", "[functions][noise]") {
  const dvec3 expected[3] = {{-0.200757090990, -0.100724383174, -0.461230458496},
                             {-0.175280960449, 0.033901849878, -0.117005760156},
                             {-0.397220564411, -0.065571654142, -0.329987775662}};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) CHECK(vnoise(check_points[i])[k] == digits12(expected[i][k]));
  }
}

TEST_CASE("turbulence: check values of six octaves", "[functions][noise]") {
  const double scalar[3] = {0.997346010735, 0.808932377841, 0.743147486132};
  const dvec3 vector[3] = {{-0.049192391674, -0.207178327197, -0.554875161470},
                           {-0.241507788574, 0.000522428003, -0.242394110156},
                           {-0.308654986813, -0.086675639287, -0.329594954677}};
  for (int i = 0; i < 3; ++i) {
    CHECK(turbulence(check_points[i], {}, 2) == digits12(scalar[i]));
    for (int k = 0; k < 3; ++k)
      CHECK(vturbulence(check_points[i], {})[k] == digits12(vector[i][k]));
  }
}

TEST_CASE("wave sources: the first three", "[functions][noise]") {
  const auto s = wave_sources(3);
  REQUIRE(s.size() == 3);
  const auto near = [](double v) { return Approx(v).epsilon(0).margin(6e-9); };
  CHECK(s[0].centre.x == near(-0.60437821));
  CHECK(s[0].centre.y == near(0.49204841));
  CHECK(s[0].frequency == near(0.91911588));
  CHECK(s[1].centre.z == near(-0.79631017));
  CHECK(s[1].frequency == near(0.96004120));
  CHECK(s[2].centre.x == near(-0.44455109));
  CHECK(s[2].frequency == near(0.43316965));
  CHECK(wave_sources(0).size() == 1);
}

TEST_CASE("periodic helpers: sine and triangle of period 1", "[functions][noise]") {
  for (const double v : {-2.75, -0.3, 0.0, 0.1, 0.5, 0.9, 3.25}) {
    CAPTURE(v);
    CHECK(cycloidal(v) == Approx(std::sin(2 * std::numbers::pi * v)).margin(1e-12));
    CHECK(triangle(v) >= 0);
    CHECK(triangle(v) <= 1);
  }
  CHECK(triangle(0.25) == Approx(0.5));
  CHECK(triangle(0.75) == Approx(0.5));
  CHECK(triangle(-0.25) == Approx(0.5));
}

TEST_CASE("noise: integers and the places around them are continuous", "[functions][noise]") {
  for (int g = 1; g <= 3; ++g) {
    for (int n = -3; n <= 3; ++n) {
      const double below = noise({n - 1e-9, 0.3, 0.6}, g);
      const double at = noise({static_cast<double>(n), 0.3, 0.6}, g);
      CHECK(at == Approx(below).margin(1e-8));
    }
  }
}

TEST_CASE("noise: every instruction set and the batch form give the same bits",
          "[functions][noise]") {
  auto points = random_points(5000, 60.0);
  points.push_back({1e10, 0, 0});
  points.push_back({-3e9, 1e300, 0.5});
  points.push_back({-0.0, -1e-11, 7});
  const simd::NoiseKernels& base = simd::baseline_kernels();
  const simd::NoiseKernels* wide = simd::avx2_kernels();
  if (wide == nullptr) {
    WARN("no AVX2 here: only the baseline ran");
    wide = &base;
  }
  const auto same = [](double a, double b) { return a == b || (a != a && b != b); };
  for (int g = 1; g <= 3; ++g) {
    std::vector<double> many(points.size());
    noise(points, g, many);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double v = base.noise(points[i].x, points[i].y, points[i].z, g);
      if (!same(v, wide->noise(points[i].x, points[i].y, points[i].z, g)) || !same(v, many[i]) ||
          !same(base.turbulence(points[i], {}, g), wide->turbulence(points[i], {}, g))) {
        CAPTURE(g, i);
        FAIL("differs");
      }
    }
  }
  std::vector<dvec3> many(points.size());
  vnoise(points, many);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const dvec3 v = base.vnoise(points[i]);
      if (!same(v[k], wide->vnoise(points[i])[k]) || !same(v[k], many[i][k]) ||
          !same(base.vturbulence(points[i], {})[k], wide->vturbulence(points[i], {})[k])) {
        CAPTURE(i, k);
        FAIL("differs");
      }
    }
  }
}

TEST_CASE("noise: turbulence of several points is that of each, to the last bit",
          "[functions][noise]") {
  const auto points = random_points(203, 60.0);
  const Octaves octaves{GENERATE(1, 3, 4, 6), 0.45, 2.1};
  const std::size_t n = GENERATE(1, 2, 3, 4, 5, 203);
  const std::span some = std::span(points).first(n);
  std::vector<dvec3> many(n);
  vturbulence(some, octaves, many);
  std::vector<dvec3> baseline(n);
  simd::baseline_kernels().vturbulence_many(some.data(), n, octaves, baseline.data());
  std::vector<dvec3> in_place(some.begin(), some.end());
  vturbulence(in_place, octaves, in_place);
  for (std::size_t i = 0; i < n; ++i) {
    const dvec3 one = vturbulence(some[i], octaves);
    CAPTURE(n, i, octaves.count);
    REQUIRE(many[i] == one);
    REQUIRE(baseline[i] == one);
    REQUIRE(in_place[i] == one);
  }
}

TEST_CASE("noise: neighbours that share cells have the bits that they have alone",
          "[functions][noise]") {
  const double step = GENERATE(0.0, 1e-4, 0.004, 0.06, 0.7, 40.0);
  const std::size_t n = GENERATE(1, 2, 3, 4, 7, 16);
  const Octaves octaves{GENERATE(1, 6, 9), 0.45, 2.1};
  for (const dvec3& start : random_points(40, 60.0)) {
    std::vector<dvec3> points;
    for (std::size_t i = 0; i < n; ++i) {
      points.push_back(start + step * static_cast<double>(i) * dvec3(0.7, -0.4, 0.2));
    }
    std::vector<double> values(n);
    std::vector<dvec3> vectors(n);
    std::vector<double> several(40);
    for (const simd::NoiseKernels* k : {&simd::kernels(), &simd::baseline_kernels()}) {
      for (int g = 1; g <= 3; ++g) {
        k->noise_many(points.data(), n, g, values.data());
        for (std::size_t i = 0; i < n; ++i) REQUIRE(values[i] == noise(points[i], g));
        k->turbulence_many(points.data(), n, octaves, g, values.data());
        for (std::size_t i = 0; i < n; ++i) REQUIRE(values[i] == turbulence(points[i], octaves, g));
        const auto few = std::min<std::size_t>(n, 4);
        k->four_octaves(points.data(), static_cast<int>(few), octaves.lambda, octaves.count, g,
                        several.data());
        for (std::size_t i = 0; i < few; ++i) {
          double alone[12];
          noise_octaves(points[i], octaves.lambda, octaves.count, g, alone);
          for (int o = 0; o < octaves.count; ++o) REQUIRE(several[4 * o + i] == alone[o]);
        }
      }
      k->vnoise_many(points.data(), n, vectors.data());
      for (std::size_t i = 0; i < n; ++i) REQUIRE(vectors[i] == vnoise(points[i]));
      k->vturbulence_many(points.data(), n, octaves, vectors.data());
      for (std::size_t i = 0; i < n; ++i) REQUIRE(vectors[i] == vturbulence(points[i], octaves));
      k->vfolded_many(points.data(), n, octaves.count, vectors.data());
      for (std::size_t i = 0; i < n; ++i) {
        REQUIRE(vectors[i] == folded_vnoise(points[i], octaves.count));
      }
    }
  }
}

TEST_CASE("noise: octaves together are the octaves one by one, to the last bit",
          "[functions][noise]") {
  const double lambda = GENERATE(2.0, 1.7, 0.3);
  const int count = GENERATE(1, 2, 4, 5, 6, 10);
  for (const dvec3& p : random_points(300, 50.0)) {
    for (int g = 1; g <= 3; ++g) {
      double values[12];
      noise_octaves(p, lambda, count, g, values);
      double frequency = 1;
      for (int i = 0; i < count; ++i, frequency *= lambda) {
        if (values[i] != noise(frequency * p, g)) FAIL("octave " << i << " of generator " << g);
      }
    }
    dvec3 sum(0.0);
    double weight = 1;
    for (int i = 0; i < count; ++i, weight /= 2) sum += weight * glm::abs(vnoise(p / weight));
    if (sum != folded_vnoise(p, count)) FAIL("folded");
    dvec3 stirred(0.0);
    double frequency = 1;
    weight = 1;
    for (int i = 0; i < count; ++i, frequency *= lambda, weight *= 0.6) {
      stirred += weight * vnoise(frequency * p);
    }
    if (stirred != vturbulence(p, {count, 0.6, lambda})) FAIL("vector turbulence");
  }
}

TEST_CASE("noise: intervals enclose sampled points and are tight for small boxes",
          "[functions][noise][interval]") {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> u(0, 1);
  for (int g = 1; g <= 3; ++g) {
    double width = 0;
    double spread = 0;
    for (const dvec3& p : random_points(1500, 20.0)) {
      const double size = std::pow(10.0, -3.0 + 3.5 * u(rng));
      const Interval r = noise(Interval(p.x, p.x + size), {p.y, p.y + size}, {p.z, p.z + size}, g);
      double lo = 1;
      double hi = 0;
      for (int k = 0; k < 30; ++k) {
        const double v = noise(p + size * dvec3(u(rng), u(rng), u(rng)), g);
        lo = std::min(lo, v);
        hi = std::max(hi, v);
      }
      if (lo < r.lo || hi > r.hi) {
        CAPTURE(g, p.x, p.y, p.z, size, r.lo, r.hi, lo, hi);
        FAIL("a value outside");
      }
      if (size < 0.1) {
        width += r.hi - r.lo;
        spread += hi - lo;
      }
    }
    CAPTURE(g, width, spread);
    CHECK(width < 3 * spread);
  }
}

TEST_CASE("noise: gradients agree with differences", "[functions][noise][gradient]") {
  for (int g = 1; g <= 3; ++g) {
    for (const dvec3& p : random_points(200, 20.0)) {
      const Dual d = noise(Dual(p.x, {1, 0, 0}), Dual(p.y, {0, 1, 0}), Dual(p.z, {0, 0, 1}), g);
      CHECK(d.v == noise(p, g));
      for (int k = 0; k < 3; ++k) {
        dvec3 h{0.0};
        h[k] = 1e-4;  // generator 3 rounds positions to 2e-9
        const double difference = (noise(p + h, g) - noise(p - h, g)) / 2e-4;
        if (std::abs(d.d[k] - difference) > 1e-4)
          FAIL("gradient " << d.d[k] << " for " << difference);
      }
    }
  }
}

TEST_CASE("noise: every instruction set gives the same bounds", "[functions][noise][interval]") {
  std::mt19937 rng(21);
  std::uniform_real_distribution<double> u(0, 1);
  for (const dvec3& p : random_points(2000, 60.0)) {
    simd::Ball box[3];
    for (simd::Ball& b : box) {
      b.m = u(rng);
      b.r = u(rng) * std::min(b.m, 1 - b.m);
    }
    const Cell cell = table_cell(p.x, p.y, p.z);
    const simd::NoiseBound a = simd::noise_bound(cell, box, 0);
    const simd::NoiseBound b = simd::noise_bound(cell, box, 1);
    bool same = a.lo == b.lo && a.hi == b.hi;
    for (int k = 0; k < 3; ++k) {
      same = same && a.slope_lo[k] == b.slope_lo[k] && a.slope_hi[k] == b.slope_hi[k];
    }
    REQUIRE(same);
  }
}

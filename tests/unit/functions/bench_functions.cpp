// Nanoseconds per point of what textured and function scenes do most. Fixed seed; best of 40 runs,
// in processor time of the thread, so that other programs do not count.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

#include "functions/evaluate.h"
#include "functions/noise.h"
#include "functions/simd/noise_kernels.h"
#include "functions/simd/tape_lanes.h"
#include "functions/waves.h"
#include "tests/unit/functions/parse_function.h"

using namespace durer;
using namespace durer::functions;

namespace {

constexpr std::size_t n = 4096;

struct Points {
  std::vector<dvec3> p;
  std::vector<double> x, y, z;
};
Points make_points() {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> u(-5, 5);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    points.p.push_back({u(rng), u(rng), u(rng)});
    points.x.push_back(points.p[i].x);
    points.y.push_back(points.p[i].y);
    points.z.push_back(points.p[i].z);
  }
  return points;
}

double sink = 0;  // what keeps the work from being optimised away

double now_ns() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
}

template <class F>
void measure(const char* name, F f) {
  std::vector<double> times;
  for (int run = 0; run < 40; ++run) {
    const double start = now_ns();
    sink += f();
    times.push_back((now_ns() - start) / n);
  }
  std::sort(times.begin(), times.end());
  std::printf("%-44s %9.1f ns\n", name, times.front());
}

void measure_function(const std::string& body, const Points& points) {
  const Function f = parse_function(body);
  Workspace w;
  measure((body.substr(0, 30) + "  point").c_str(), [&] {
    double sum = 0;
    Evaluator<double> at(f, w);
    for (const dvec3& p : points.p) sum += at(std::array{p.x, p.y, p.z});
    return sum;
  });
  std::vector<double> out(n);
  const std::array<const double*, 3> columns{points.x.data(), points.y.data(), points.z.data()};
  measure("  batch", [&] {
    evaluate_batch(f, columns, n, out.data(), w);
    return out[17];
  });
  if (body.find("sin") != std::string::npos) {
    const Function waves = with_waves(f);
    measure("  batch, waves together", [&] {
      evaluate_batch(waves, columns, n, out.data(), w);
      return out[17];
    });
  }
  measure("  interval", [&] {
    double sum = 0;
    Evaluator<Interval> over(f, w);
    for (const dvec3& p : points.p) {
      const std::array<Interval, 3> box{Interval(p.x, p.x + 0.01), Interval(p.y, p.y + 0.01),
                                        Interval(p.z, p.z + 0.01)};
      sum += over(box).hi;
    }
    return sum;
  });
  measure("  gradient", [&] {
    double sum = 0;
    for (const dvec3& p : points.p) sum += evaluate_gradient(f, p, w).d.x;
    return sum;
  });
}

void measure_noise(const Points& points) {
  std::vector<double> out(n);
  std::vector<dvec3> vectors(n);
  for (const int g : {1, 2, 3}) {
    measure(("noise, generator " + std::to_string(g)).c_str(), [&] {
      double sum = 0;
      for (const dvec3& p : points.p) sum += noise(p, g);
      return sum;
    });
    measure("  many points", [&] {
      noise(points.p, g, out);
      return out[3];
    });
    measure("  many points, baseline instructions", [&] {
      simd::baseline_kernels().noise_many(points.p.data(), n, g, out.data());
      return out[3];
    });
  }
  measure("vnoise", [&] {
    double sum = 0;
    for (const dvec3& p : points.p) sum += vnoise(p).x;
    return sum;
  });
  for (const int g : {2, 3}) {
    measure(("turbulence, 6 octaves, generator " + std::to_string(g)).c_str(), [&] {
      double sum = 0;
      for (const dvec3& p : points.p) sum += turbulence(p, {}, g);
      return sum;
    });
  }
  measure("  baseline instructions, generator 2", [&] {
    double sum = 0;
    for (const dvec3& p : points.p) sum += simd::baseline_kernels().turbulence(p, {}, 2);
    return sum;
  });
  measure("vturbulence, 6 octaves", [&] {
    double sum = 0;
    for (const dvec3& p : points.p) sum += vturbulence(p, {}).x;
    return sum;
  });
}

// What lies under the pixels of a row: `step` pattern units from one to the next.
void measure_rows(double step) {
  std::printf("neighbours %.4f apart\n", step);
  std::vector<dvec3> row;
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<double>(i);
    row.push_back(at * step * dvec3(0.81, 0.33, 0.48) + dvec3(-7.3, 4.1, 2.2));
  }
  std::vector<double> out(n);
  std::vector<dvec3> vectors(n);
  const auto groups = [&](const auto& visit) {
    for (std::size_t i = 0; i < n; i += 16) visit(std::span(row).subspan(i, 16), i);
  };
  measure("turbulence, 8 octaves", [&] {
    for (std::size_t i = 0; i < n; ++i) out[i] = turbulence(row[i], {8, 0.5, 2}, 2);
    return out[3];
  });
  measure("  many points", [&] {
    groups([&](std::span<const dvec3> some, std::size_t i) {
      turbulence(some, {8, 0.5, 2}, 2, std::span(out).subspan(i, some.size()));
    });
    return out[3];
  });
  measure("vturbulence, 6 octaves", [&] {
    for (std::size_t i = 0; i < n; ++i) vectors[i] = vturbulence(row[i], {});
    return vectors[3].x;
  });
  measure("  many points", [&] {
    groups([&](std::span<const dvec3> some, std::size_t i) {
      vturbulence(some, {}, std::span(vectors).subspan(i, some.size()));
    });
    return vectors[3].x;
  });
  measure("folded vnoise, 10 octaves", [&] {
    for (std::size_t i = 0; i < n; ++i) vectors[i] = folded_vnoise(row[i], 10);
    return vectors[3].x;
  });
  measure("  many points", [&] {
    groups([&](std::span<const dvec3> some, std::size_t i) {
      folded_vnoise(some, 10, std::span(vectors).subspan(i, some.size()));
    });
    return vectors[3].x;
  });
}

// Eight points at a time, by each instruction set.
void measure_lanes(const std::string& body, const Points& points) {
  const Function f = with_waves(parse_function(body));
  Workspace w;
  std::vector<std::array<Pack, 3>> packs(n / Pack::lanes);
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) packs[i / Pack::lanes][k].v[i % Pack::lanes] = points.p[i][k];
  }
  const simd::TapeLanes* best = simd::best_tape_lanes;
  int set = 0;
  for (const simd::TapeLanes* lanes : simd::all_tape_lanes()) {
    simd::best_tape_lanes = lanes;
    measure((body.substr(0, 30) + "  set " + std::to_string(set++)).c_str(), [&] {
      double sum = 0;
      Evaluator<Pack> at(f, w);
      for (const auto& p : packs) sum += at(p).v[3];
      return sum;
    });
  }
  simd::best_tape_lanes = best;
}

}  // namespace

int main() {
  const Points points = make_points();
  for (const double step : {0.0005, 0.003, 0.02, 3.7}) measure_rows(step);
  measure_noise(points);
  const char* const gyroid = "sin(12*x)*cos(12*y)+sin(12*y)*cos(12*z)+sin(12*z)*cos(12*x)";
  measure_lanes(gyroid, points);
  measure_lanes("sqrt(x*x+y*y+z*z)-floor(y)*abs(z)", points);
  measure_function(gyroid, points);
  measure_function("x*x*x-3*x*y*y+z*z*(2*x-y)-0.7*x*y*z+pow(y,4)-1.2", points);
  measure_function("f_torus(x,y,z,0.9,0.3)", points);
  measure_function("f_torus(x,y,z,0.9,0.3)-f_noise3d(x*10,y*10,z*10)*0.1", points);
  measure_function("f_heart(x,y,z,-1)", points);
  measure_function("f_ridged_mf(x,y,z,0.1,3,7,0.7,0.7,2)", points);
  measure_function("f_superellipsoid(x,y,z,0.3,0.6)", points);
  measure_function("select(x,sin(y)*z,cos(y)+z)+sum(i,1,4,i*x)", points);
  return sink == 1 ? 1 : 0;
}

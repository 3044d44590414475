// Ranges of values and slopes over boxes, against points and differences.
#include <random>

#include "functions/evaluate.h"
#include "functions/internals.h"
#include "tests/support/catch.h"
#include "tests/unit/functions/parse_function.h"

using namespace durer;
using namespace durer::functions;

namespace {

using Box = std::array<Interval, 3>;

Box random_box(std::mt19937& rng) {
  std::uniform_real_distribution<double> u(0, 1);
  Box box;
  const double size = std::pow(10.0, -4 + 4.5 * u(rng));
  for (Interval& axis : box) {
    const double lo = 4 * u(rng) - 2;
    axis = {lo, lo + size * (0.5 + u(rng))};
  }
  return box;
}

std::array<double, 3> point_in(const Box& box, std::mt19937& rng) {
  std::uniform_real_distribution<double> u(0, 1);
  std::array<double, 3> p{};
  for (std::size_t i = 0; i < 3; ++i) p[i] = box[i].lo + u(rng) * (box[i].hi - box[i].lo);
  return p;
}

/// How often values leave the range, or differences the slopes, for some pairs of points.
template <typename Value>
int escapes(const Trend& t, const Box& box, std::mt19937& rng, Value value) {
  int escaped = 0;
  for (int k = 0; k < 8; ++k) {
    const auto p = point_in(box, rng);
    const auto q = point_in(box, rng);
    const double vp = value(p);
    const double vq = value(q);
    if (!t.range().contains(vp)) ++escaped;
    if (t.nan() || vp != vp || vq != vq) continue;
    Interval change;
    for (std::size_t i = 0; i < 3; ++i) change += t.slope(i) * Interval(q[i] - p[i]);
    const double slack = 1e-9 * (1 + std::abs(vp) + std::abs(vq));
    if (!Interval{change.lo - slack, change.hi + slack, change.nan}.contains(vq - vp)) ++escaped;
  }
  return escaped;
}

}  // namespace

TEST_CASE("trend: ranges hold values and slopes hold differences", "[functions][trend]") {
  Workspace w;
  std::mt19937 rng(11);
  for (const char* body :
       {"x*y - z/3", "x/(y+5)", "abs(x*y) - 0.3", "min(x, y*y, z)", "max(abs(x), abs(y)) - 1",
        "sqrt(x*x + y*y + z*z)", "pow(abs(x), 1.5) + pow(y, 3)", "sin(5*x)*cos(3*y) + tan(z/3)",
        "exp(x)*ln(y + 3) - log(z + 4)", "atan2(y, x)", "mod(x, 0.7)", "floor(3*x) + ceil(y)",
        "select(x - y, x*x, y*y)", "select(x, y, z, 2)", "(x < y)*z", "sum(i, 1, 4, sin(i*x)/i)",
        "asin(x/4) + acos(y/3) + atan(z)", "sinh(x) - cosh(y) + tanh(z)",
        "asinh(x) + acosh(y + 4) + atanh(z/3)", "pow(x + 3, y)", "int(4*x)", "div(x, 0.3)"}) {
    const Function f = parse_function(body);
    for (int repeat = 0; repeat < 400; ++repeat) {
      const Box box = random_box(rng);
      const Trend t = evaluate_trend(f, box, w);
      const int escaped =
          escapes(t, box, rng, [&](const auto& p) { return evaluate(f, p, w); });
      if (escaped > 0) {
        CAPTURE(body, box[0].lo, box[0].hi, box[1].lo, box[1].hi, box[2].lo, box[2].hi);
        CHECK(escaped == 0);
        break;
      }
    }
  }
}

TEST_CASE("trend: internal functions keep their promise", "[functions][trend][internals]") {
  std::mt19937 rng(12);
  std::uniform_real_distribution<double> u(0.2, 2.5);
  for (int number = 0; number < static_cast<int>(internal_functions.size()); ++number) {
    const InternalInfo& info = internal_functions[static_cast<std::size_t>(number)];
    for (int repeat = 0; repeat < 60; ++repeat) {
      std::vector<double> extra(static_cast<std::size_t>(info.extra));
      for (double& e : extra) e = u(rng);
      const Box box = random_box(rng);
      std::vector<Trend> arguments;
      for (std::size_t i = 0; i < 3; ++i) arguments.push_back(Trend::coordinate(box[i], i));
      arguments.insert(arguments.end(), extra.begin(), extra.end());
      const Trend t = internal_value(number, arguments.data(), Context{});
      const int escaped = escapes(t, box, rng, [&](const auto& p) {
        std::vector<double> a(p.begin(), p.end());
        a.insert(a.end(), extra.begin(), extra.end());
        return internal_value(number, a.data(), Context{});
      });
      if (escaped > 0) {
        CAPTURE(info.name, extra, box[0].lo, box[0].hi, box[1].lo, box[1].hi, box[2].lo, box[2].hi);
        CHECK(escaped == 0);
        break;
      }
    }
  }
}

TEST_CASE("trend: small boxes away from kinks know their slopes well", "[functions][trend]") {
  Workspace w;
  const Function f = parse_function("sin(3*x)*y + sqrt(x*x + z*z)");
  const Box box{Interval{0.5, 0.501}, Interval{0.2, 0.201}, Interval{0.7, 0.701}};
  const Trend t = evaluate_trend(f, box, w);
  const Dual d = evaluate_gradient(f, {0.5005, 0.2005, 0.7005}, w);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(t.slope(i).contains(d.d[static_cast<int>(i)]));
    CHECK(t.slope(i).hi - t.slope(i).lo < 0.02);
  }
}

// Ranges of values and slopes over boxes, against points and differences.
#include <random>

#include "functions/box_trends.h"
#include "functions/evaluate.h"
#include "functions/internals.h"
#include "functions/simd/trend_lanes.h"
#include "functions/waves.h"
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
  for (const char* body : {"x*y - z/3",
                           "x/(y+5)",
                           "abs(x*y) - 0.3",
                           "min(x, y*y, z)",
                           "max(abs(x), abs(y)) - 1",
                           "sqrt(x*x + y*y + z*z)",
                           "pow(abs(x), 1.5) + pow(y, 3)",
                           "sin(5*x)*cos(3*y) + tan(z/3)",
                           "exp(x)*ln(y + 3) - log(z + 4)",
                           "atan2(y, x)",
                           "mod(x, 0.7)",
                           "floor(3*x) + ceil(y)",
                           "select(x - y, x*x, y*y)",
                           "select(x, y, z, 2)",
                           "(x < y)*z",
                           "sum(i, 1, 4, sin(i*x)/i)",
                           "asin(x/4) + acos(y/3) + atan(z)",
                           "sinh(x) - cosh(y) + tanh(z)",
                           "asinh(x) + acosh(y + 4) + atanh(z/3)",
                           "pow(x + 3, y)",
                           "int(4*x)",
                           "div(x, 0.3)"}) {
    const Function f = parse_function(body);
    for (int repeat = 0; repeat < 400; ++repeat) {
      const Box box = random_box(rng);
      const Trend t = evaluate_trend(f, box, w);
      const int escaped = escapes(t, box, rng, [&](const auto& p) { return evaluate(f, p, w); });
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

TEST_CASE("trend: along a line ranges hold values, and the slope differences",
          "[functions][trend][noise]") {
  Workspace w;
  std::mt19937 rng(16);
  std::uniform_real_distribution<double> u(-1, 1);
  for (const char* body :
       {"x*y - z/3", "sqrt(x*x + y*y + z*z) - abs(x)", "sin(5*x)*cos(3*y) + tan(z/3)",
        "f_noise3d(x, y, z)", "f_noise_generator(3*x, 2*y, z, 1)",
        "f_noise_generator(x + y, y*z, z, 2)", "f_noise_generator(7*x, y, z - x, 3)",
        "f_ridged_mf(x, y, z, 0.1, 3.1, 8, 0.7, 0.8, 2)",
        "f_ridged_mf(x, y, z, 0.9, 2.3, 6, 1.1, 1.7, 1) - z",
        "f_hetero_mf(x, y, z, 0.5, 2.2, 5, 0.6, 1, 3)",
        "f_ridge(x, y, z, 2, 4, 0.5, 0.6, 0.4, 2)"}) {
    const Function f = parse_function(body);
    int escaped = 0;
    for (int repeat = 0; repeat < 3000 && escaped == 0; ++repeat) {
      const dvec3 o(6 * u(rng), 6 * u(rng), 6 * u(rng));
      const dvec3 d(u(rng), repeat % 3 == 0 ? 0.0 : u(rng), repeat % 5 == 0 ? 0.0 : u(rng));
      const double from = u(rng);
      const Interval t{from, from + std::pow(10.0, -4.5 + 2.5 * (u(rng) + 1))};
      const Trend along = evaluate_along(f, o, d, t, w);
      const auto value = [&](double s) {
        const dvec3 p = o + s * d;
        return evaluate(f, std::array{p.x, p.y, p.z}, w);
      };
      double last = value(t.lo);
      constexpr int steps = 12;
      for (int i = 1; i <= steps; ++i) {
        const double v = value(t.lo + (t.hi - t.lo) * i / steps);
        const Interval change = along.slope(0) * Interval((t.hi - t.lo) / steps);
        // Generator 3 adds 10^7 to coordinates: it sees them in steps of 2e-9.
        const double slack = 1e-8 * (1 + std::abs(v));
        escaped += along.range().contains(v) ? 0 : 1;
        escaped += v - last >= change.lo - slack && v - last <= change.hi + slack ? 0 : 1;
        last = v;
      }
      CAPTURE(body, o.x, o.y, o.z, d.x, d.y, d.z, t.lo, t.hi);
      CHECK(escaped == 0);
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

TEST_CASE("circle: sines and cosines are those of the C library, nearly", "[base][circle]") {
  std::mt19937 rng(13);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const double a = u(rng) * std::pow(10.0, 6 * std::abs(u(rng)) - 0.1);
    const double b = std::round(a) * 1.5707963267948966 + u(rng) * 1e-9;
    if (!fits_circle(a) || !fits_circle(b)) continue;
    const PairOnCircle c = on_circle(DoublePair{a, b});
    CAPTURE(a, b);
    CHECK(std::abs(c.sine[0] - std::sin(a)) <= 4e-16);
    CHECK(std::abs(c.cosine[0] - std::cos(a)) <= 4e-16);
    CHECK(std::abs(c.sine[1] - std::sin(b)) <= 4e-16);
    CHECK(std::abs(c.cosine[1] - std::cos(b)) <= 4e-16);
  }
}

TEST_CASE("circle: ranges hold the sines and cosines in them, and not much else",
          "[base][circle]") {
  std::mt19937 rng(14);
  std::uniform_real_distribution<double> u(0, 1);
  for (int i = 0; i < 5000; ++i) {
    const double lo = 40 * u(rng) - 20;
    const Interval a{lo, lo + std::pow(10.0, 4 * u(rng) - 3)};
    const Circle c = circle_of(a);
    Interval sines = std::sin(a.lo);
    Interval cosines = std::cos(a.lo);
    for (int k = 0; k <= 1000; ++k) {
      const double v = a.lo + (a.hi - a.lo) * (k / 1000.0);
      sines = hull(sines, std::sin(v));
      cosines = hull(cosines, std::cos(v));
    }
    CAPTURE(a.lo, a.hi);
    REQUIRE((c.sine.lo <= sines.lo && c.sine.hi >= sines.hi));
    REQUIRE((c.cosine.lo <= cosines.lo && c.cosine.hi >= cosines.hi));
    CHECK(sines.lo - c.sine.lo + c.sine.hi - sines.hi < 1e-4);
    CHECK(cosines.lo - c.cosine.lo + c.cosine.hi - cosines.hi < 1e-4);
  }
}

TEST_CASE("waves: taken together they are what they were alone", "[functions][waves]") {
  Workspace w;
  std::mt19937 rng(15);
  std::uniform_real_distribution<double> u(-3, 3);
  for (const char* body : {"sin(12*x)*cos(12*y) + sin(12*y)*cos(12*z) + sin(12*z)*cos(12*x)",
                           "sin(x)", "cos(x + sin(y + cos(z)))*sin(x) + sin(1e9*x)",
                           "sin(x)*f_noise3d(cos(x), y, sin(z + cos(x)))"}) {
    const Function f = parse_function(body);
    const Function g = with_waves(f);
    CAPTURE(body);
    CHECK(g.code.size() <= f.code.size());
    for (int i = 0; i < 300; ++i) {
      const std::array p{u(rng), u(rng), u(rng)};
      const double at_p = evaluate(g, p, w);
      CHECK(at_p == Approx(evaluate(f, p, w)).margin(1e-7));
      const double* const columns[] = {&p[0], &p[1], &p[2]};
      double batch = 0;
      evaluate_batch(g, columns, 1, &batch, w);
      CHECK(batch == at_p);
      const Box box{Interval{p[0] - 0.1, p[0] + 0.2}, {p[1], p[1] + 0.01}, {p[2], p[2]}};
      CHECK(evaluate_interval(g, box, w).contains(at_p));
      CHECK(escapes(evaluate_trend(g, box, w), box, rng,
                    [&](const auto& q) { return evaluate(g, q, w); }) == 0);
    }
  }
}

TEST_CASE("box trends: what is remembered of the last box changes no bit", "[functions][trend]") {
  Workspace w;
  std::mt19937 rng(16);
  const auto share = [](const char* body) {
    return std::make_shared<const Function>(with_waves(parse_function(body)));
  };
  const std::array functions{share("sin(3*x)*y + f_noise3d(x, 0, z) - cos(z)"),
                             share("select(x - y, x*x, y*z)")};
  const BoxTrends first(functions[0]);
  const BoxTrends second(functions[1]);
  BoxTrends::Memory memory;  // of one thread, whatever the function
  Box box = random_box(rng);
  for (int i = 0; i < 500; ++i) {
    const Box fresh = random_box(rng);
    for (std::size_t k = 0; k < 3; ++k) {
      if (rng() % 2 == 0) box[k] = fresh[k];
    }
    const std::size_t which = rng() % 4 == 0 ? 1 : 0;
    const std::array centre{box[0].mid(), box[1].mid(), box[2].mid()};
    const Trend t = (which == 0 ? first : second)(box, centre, w, memory);
    const Trend expected = evaluate_trend(*functions[which], box, w);
    const auto same = [](const Interval& a, const Interval& b) {
      return a.lo == b.lo && a.hi == b.hi && a.nan == b.nan;
    };
    REQUIRE(same(t.range(), expected.range()));
    for (std::size_t k = 0; k < 3; ++k) REQUIRE(same(t.slope(k), expected.slope(k)));
  }
}

namespace {

bool same_bits(const Interval& a, const Interval& b) {
  return a.lo == b.lo && a.hi == b.hi && a.nan == b.nan;
}
bool same_bits(const Trend& a, const Trend& b) {
  bool same = same_bits(a.range(), b.range()) && a.is_bounded() == b.is_bounded();
  for (std::size_t k = 0; k < 3; ++k) same = same && same_bits(a.slope(k), b.slope(k));
  return same;
}
/// Of any size, round zero or beside it; now and then a point, infinite or not a number.
Trend random_trend(std::mt19937& rng) {
  std::uniform_real_distribution<double> u(-1, 1);
  const auto range = [&] {
    const double middle = std::exp(6 * u(rng)) * u(rng);
    const double radius = rng() % 4 == 0 ? 0 : std::exp(6 * u(rng));
    Interval r{middle - radius, middle + radius};
    if (rng() % 50 == 0) r.hi = std::numeric_limits<double>::infinity();
    if (rng() % 50 == 0) r.lo = -std::numeric_limits<double>::max();
    return r;
  };
  Interval value = range();
  value.nan = rng() % 20 == 0;
  return {value, Trend::Slopes{range(), range(), range()}};
}
Trend plainly(Op op, const Trend& a, const Trend& b) {
  switch (op) {
    case Op::negate: return -a;
    case Op::square: return sqr(a);
    case Op::absolute: return abs(a);
    case Op::add: return a + b;
    case Op::subtract: return a - b;
    case Op::multiply: return a * b;
    case Op::minimum: return min(a, b);
    default: return max(a, b);
  }
}

}  // namespace

TEST_CASE("trend lanes: the bits of plain trends on every instruction set", "[functions][trend]") {
  std::mt19937 rng(17);
  for (const simd::TrendLanes lanes : simd::all_trend_lanes()) {
    for (const Op op : {Op::negate, Op::square, Op::absolute, Op::add, Op::subtract, Op::multiply,
                        Op::minimum, Op::maximum, Op::divide}) {
      Function f;
      f.code = {{op, 0, 2, 0, 1}};
      int done = 0;
      for (int i = 0; i < 2000; ++i) {
        std::array<Trend, 3> r{random_trend(rng), random_trend(rng), Trend()};
        const Trend expected = plainly(op, r[0], r[1]);
        if (lanes(f, r.data(), 0, 1) == 0) continue;  // left to plain trends
        ++done;
        REQUIRE(same_bits(r[2], expected));
      }
      CHECK((op == Op::divide ? done == 0 : done > 1000));
    }
    Function f;
    f.operands = {0, 1};
    f.code = {{Op::waves, 4, 2, 0, 0}};
    int done = 0;
    for (int i = 0; i < 2000; ++i) {
      std::array<Trend, 6> r{random_trend(rng), random_trend(rng)};
      if (lanes(f, r.data(), 0, 1) == 0) continue;
      ++done;
      for (std::size_t k = 0; k < 2; ++k) {
        REQUIRE(same_bits(r[2 + 2 * k], sin(r[k])));
        REQUIRE(same_bits(r[3 + 2 * k], cos(r[k])));
      }
    }
    CHECK(done > 1000);
  }
}

TEST_CASE("box trends: what is remembered of the last point changes no bit", "[functions][trend]") {
  Workspace w;
  std::mt19937 rng(18);
  std::uniform_real_distribution<double> u(-3, 3);
  const auto f = std::make_shared<const Function>(
      with_waves(parse_function("sin(3*x)*cos(y) + f_noise3d(x, 0, z) - cos(1e7*z)*sin(y + z)")));
  const BoxTrends trends(f);
  BoxTrends::Memory memory;
  std::array<double, 3> p{};
  for (int i = 0; i < 500; ++i) {
    for (double& c : p) {
      if (rng() % 2 == 0) c = u(rng);
    }
    const double value = trends(p, w, memory);
    BoxTrends::Memory fresh;
    REQUIRE(value == trends(p, w, fresh));
    CHECK(value == Approx(evaluate(*f, p, w)).margin(1e-12));
  }
}

TEST_CASE("box trends: ranges that are narrowed hold values", "[functions][trend]") {
  Workspace w;
  std::mt19937 rng(19);
  for (const char* body :
       {"abs(sin(3*x)*cos(3*y) + sin(3*y)*cos(3*z) + sin(3*z)*cos(3*x)) - 0.2",
        "min(x*y - z, max(x - y*z, sqrt(abs(x*x - y*y))))", "min(sin(x)*cos(x), abs(y - z*z))",
        "x/(0.1 + x*x - y*z) + abs(y - x)"}) {
    const auto f = std::make_shared<const Function>(with_waves(parse_function(body)));
    const BoxTrends trends(f);
    BoxTrends::Memory memory;
    Box box = random_box(rng);
    for (int i = 0; i < 2000; ++i) {
      const Box other = random_box(rng);
      for (std::size_t k = 0; k < 3; ++k) {
        if (rng() % 2 == 0) box[k] = other[k];
      }
      const std::array centre{box[0].mid(), box[1].mid(), box[2].mid()};
      const Trend t = trends(box, centre, w, memory);
      BoxTrends::Memory fresh;
      REQUIRE(same_bits(t, trends(box, centre, w, fresh)));
      const Interval plain = evaluate_trend(*f, box, w).range();
      CHECK((t.nan() || (t.range().lo >= plain.lo && t.range().hi <= plain.hi)));
      REQUIRE(escapes(t, box, rng, [&](const auto& p) { return evaluate(*f, p, w); }) == 0);
    }
  }
}

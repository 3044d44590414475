#include "functions/builder.h"
#include "functions/evaluate.h"
#include "functions/spline.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::functions;

namespace {

Spline checked(SplineKind kind) {
  const Spline::Entry entries[] = {{4, {9, 9}}, {0, {0, 0}}, {1, {1, 2}},
                                   {2, {4, 1}}, {3, {9, 5}}, {1, {1, 2}}};
  return Spline(kind, 2, std::span(entries).subspan(1));
}

}  // namespace

TEST_CASE("spline: check values of the four kinds", "[functions][spline]") {
  const auto check = [](SplineKind kind, double t, double x, double y) {
    const SplineValue v = checked(kind).at(t);
    CHECK(v[0] == Approx(x).margin(1e-12));
    CHECK(v[1] == Approx(y).margin(1e-12));
  };
  check(SplineKind::linear, 1.5, 2.5, 1.5);
  check(SplineKind::quadratic, 1.5, 2.25, 1.875);
  check(SplineKind::cubic, 1.5, 2.25, 1.375);
  check(SplineKind::natural, 1.5, 2.2, 1.35);
  check(SplineKind::quadratic, 0.5, 0.25, 1.375);
}

TEST_CASE("spline: another kind on demand, constant outside", "[functions][spline]") {
  const Spline s = checked(SplineKind::linear);
  CHECK(s.at(1.5, SplineKind::natural)[0] == Approx(2.2));
  for (const auto kind : {SplineKind::linear, SplineKind::quadratic, SplineKind::natural}) {
    CHECK(s.at(-1, kind)[0] == 0);
    CHECK(s.at(7, kind)[1] == 5);
    CHECK(s.at(0, kind)[0] == 0);
    CHECK(s.at(3, kind)[0] == 9);
  }
  CHECK(s.at(0.5, SplineKind::cubic)[1] == 2);
  CHECK(s.at(2.5, SplineKind::cubic)[1] == 1);
}

TEST_CASE("spline: few entries", "[functions][spline]") {
  const Spline::Entry entries[] = {{2, {1, 3}}, {1, {5, 5}}};
  const Spline one(SplineKind::natural, 2, std::span(entries).first(1));
  CHECK(one.at(-3)[1] == 3);
  const Spline two(SplineKind::cubic, 2, entries);
  CHECK(two.at(9)[0] == 3);
  CHECK(two.at(1.5, SplineKind::quadratic)[0] == 3);
  CHECK(two.at(1.5, SplineKind::natural)[1] == 4);
}

TEST_CASE("spline: equal keys replace, but not the largest one", "[functions][spline]") {
  const Spline::Entry entries[] = {{0, {1, 1}}, {1, {2, 2}}, {0, {7, 7}}, {1, {8, 8}}};
  const Spline s(SplineKind::linear, 2, entries);
  REQUIRE(s.entries().size() == 2);
  CHECK(s.at(0)[0] == 7);
  CHECK(s.at(1)[0] == 2);
}

TEST_CASE("spline: as a function of one parameter", "[functions][spline]") {
  const auto s = std::make_shared<const Spline>(checked(SplineKind::natural));
  const Function f = make_spline_function(s);
  CHECK(f.parameters == 1);
  REQUIRE(f.components() == 2);
  Workspace w;
  double out[2];
  const double t = 1.5;
  evaluate(f, {&t, 1}, out, w);
  CHECK(out[0] == Approx(2.2));
  CHECK(out[1] == Approx(1.35));
}

TEST_CASE("spline: values of the reference program, keys at any distance", "[functions][spline]") {
  const Spline::Entry entries[] = {
      {-0.5, {0.3, 0.1}}, {0.2, {1, 2}}, {1.7, {-4, 1}}, {2.1, {2, 5}}, {4, {3, -1}}};
  const Spline s(SplineKind::natural, 3, entries);
  const double t[] = {-1, 0, 0.5, 1, 1.9, 2.5, 3, 3.9};
  const double x[][4] = {
      // linear, quadratic, cubic, natural
      {0.3, 0.3, 1, 0.3},
      {0.8, 0.996969696969697, 1, 1.3472489569150483},
      {0, 0.7090909090909090, -0.0239999999999997, -0.7286632323771558},
      {-1.6666666666666665, -0.5636363636363636, -3.11437037037037, -4.6047305606480284},
      {-1.0000000000000018, -1.3859649122807065, -1.0964912280701777, -1.1659383586056782},
      {2.2105263157894735, 5.9862700228833106, 2, 6.1933681035727908},
      {2.4736842105263159, 8.1372997711670649, 2, 7.5693788507785023},
      {2.9473684210526314, 4.0800915331808056, 2, 3.6502228541908663}};
  const SplineKind kinds[] = {SplineKind::linear, SplineKind::quadratic, SplineKind::cubic,
                              SplineKind::natural};
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 4; ++k) {
      CAPTURE(t[i], k);
      CHECK(s.at(t[i], kinds[k])[0] == Approx(x[i][k]).epsilon(1e-14));
    }
  }
}

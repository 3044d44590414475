// Shafts never lose what a ray inside of them would meet.
#include "tracer/accel/shaft.h"

#include <random>

#include "tests/support/catch.h"
#include "tracer/accel/box_tree.h"

using namespace durer;
using namespace durer::tracer;

namespace {

struct Dice {
  std::mt19937 engine{7};
  double operator()(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine);
  }
  dvec3 point(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
};

}  // namespace

TEST_CASE("shaft: holds every ray to its area", "[accel][shaft]") {
  Dice dice;
  constexpr double begin = 1e-3;
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const dvec3 apex = dice.point(3);
    const dvec3 centre = dice.point(5);
    const dvec3 u = i % 7 == 0 ? dvec3(0.0) : dice.point(1);
    const dvec3 v = i % 11 == 0 ? u : dice.point(1);
    const Shaft shaft(apex, centre, u, v, begin);
    const dvec3 lo = dice.point(4);
    const Bounds3 box{lo, lo + dvec3(dice(0, 1), dice(0, 1), dice(0, 1))};
    for (int k = 0; k < 20; ++k) {
      const dvec3 to = centre + dice(-1, 1) * u + dice(-1, 1) * v - apex;
      const double length = glm::length(to);
      const Ray ray{apex, to / length};
      double from = begin;
      double until = length;
      if (!BoxTree::clip(box, ray.o, 1.0 / ray.d, from, until)) continue;
      ++met;
      REQUIRE(shaft.meets(box));
    }
  }
  CHECK(met > 200);  // the test is about something
}

TEST_CASE("shaft: leaves out what is aside or behind", "[accel][shaft]") {
  const Shaft shaft({0, 0, 0}, {0, 10, 0}, {1, 0, 0}, {0, 0, 1}, 1e-3);
  CHECK(shaft.meets({{-0.1, 5, -0.1}, {0.1, 6, 0.1}}));
  CHECK_FALSE(shaft.meets({{1, 5, -0.1}, {2, 6, 0.1}}));
  CHECK_FALSE(shaft.meets({{-1, 11, -1}, {1, 12, 1}}));
  // The ground that the lit point lies on.
  CHECK_FALSE(shaft.meets({{-100, -100, -100}, {100, 1e-9, 100}}));
}

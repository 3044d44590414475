// Ray directions of the cameras (shading §10.7).
#include "tracer/cameras/orthographic.h"
#include "tracer/cameras/perspective.h"
#include "tracer/cameras/user_defined.h"

#include "functions/builder.h"
#include "tests/support/catch.h"

using namespace durer;
using durer::tracer::OrthographicCamera;
using durer::tracer::PerspectiveCamera;

namespace {

// Column i, row j of an 8x6 picture, as u and v.
dvec2 at(int i, int j) { return {(i + 0.5) / 8 - 0.5, 0.5 - (j + 0.5) / 6}; }

void check_direction(dvec3 d, dvec3 expected) {
  for (int i = 0; i < 3; ++i) CHECK(d[i] == Approx(expected[i]).margin(6e-5));
}

}  // namespace

TEST_CASE("camera: perspective rays go through pixel centres", "[tracer][camera]") {
  scene::Camera c;
  SECTION("default") {
    const PerspectiveCamera camera(c);
    check_direction(camera.ray(at(2, 1).x, at(2, 1).y).d, {-0.2352, 0.2357, 0.9429});
    check_direction(camera.ray(at(5, 4).x, at(5, 4).y).d, {0.2352, -0.2357, 0.9429});
  }
  SECTION("angle 40") {
    c.direction = {0, 0, 1.33 / (2 * std::tan(0.349065850399))};
    const PerspectiveCamera camera(c);
    check_direction(camera.ray(at(2, 1).x, at(2, 1).y).d, {-0.1340, 0.1344, 0.9818});
  }
}

TEST_CASE("camera: orthographic rays are parallel and start side by side", "[tracer][camera]") {
  // location <0,0,-6> look_at 0 angle 40 right x up y, as resolved: half width 6 tan 20.
  scene::Camera c;
  const double width = 12 * std::tan(0.349065850399);
  c.location = {0, 0, -6};
  c.direction = {0, 0, 2.5};
  c.right = {width, 0, 0};
  c.up = {0, width, 0};
  const OrthographicCamera camera(c);
  const Ray first = camera.ray(0.5 / 4 - 0.5, 0);
  CHECK(first.o.x == Approx(-1.6378).margin(1e-4));
  CHECK(first.d == dvec3(0, 0, 1));
  CHECK(camera.ray(1.5 / 4 - 0.5, 0).o.x == Approx(-0.5458).margin(1e-3));
}

TEST_CASE("camera: user_defined rays follow its functions and transformations",
          "[tracer][camera]") {
  functions::FunctionBuilder b(2);
  const auto u = std::make_shared<const functions::Function>(b.finish(b.parameter(0)));
  functions::FunctionBuilder one(2);
  const auto constant = std::make_shared<const functions::Function>(one.finish(one.constant(1)));
  scene::Camera c;
  c.kind = scene::Camera::Kind::user_defined;
  c.location = {0, 0, -5};
  c.transform = SharedTransform(Transform::translate({0, 3, 0}));
  SECTION("functions for both") {
    c.location_functions = {u, u, constant};
    c.direction_functions = {constant, constant, constant};
    tracer::UserDefinedCamera camera(c, 2);
    const Ray ray = camera.ray(0.25, -0.5);
    CHECK(ray.o == dvec3(0.25, 3.25, 1));
    check_direction(ray.d, dvec3(1, 1, 1) / std::sqrt(3.0));
  }
  SECTION("no functions: perspective") {
    tracer::UserDefinedCamera camera(c, 2);
    CHECK(camera.ray(0, 0).o == dvec3(0, 0, -5));
    check_direction(camera.ray(0, 0).d, {0, 0, 1});
  }
}

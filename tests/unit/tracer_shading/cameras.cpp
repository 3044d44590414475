// Ray directions of the cameras (shading §10.7).
#include "tracer/cameras/camera.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "functions/builder.h"
#include "tests/support/catch.h"
#include "tracer/film/pinhole.h"
#include "tracer/film/sample_seed.h"

using namespace durer;
using Kind = scene::Camera::Kind;

namespace {

struct Looked {
  bool found = false;
  Ray ray;
};

// Through u and v of the picture.
Looked look(const scene::Camera& c, double u, double v) {
  const tracer::Camera camera(c);
  functions::Workspace workspace;
  workspace.context.noise_generator = 2;
  tracer::CameraRay out;
  Looked looked;
  looked.found = camera.ray({u, v, 0, 0, 1, 1, 0}, workspace, out);
  looked.ray = {out.ray.o, glm::normalize(out.ray.d)};
  return looked;
}

// Through the centre of column i, row j of an 8x6 picture.
dvec3 direction(const scene::Camera& c, int i, int j) {
  const Looked looked = look(c, (i + 0.5) / 8 - 0.5, 0.5 - (j + 0.5) / 6);
  CHECK(looked.found);
  return looked.ray.d;
}

void check_direction(dvec3 d, dvec3 expected) {
  CAPTURE(d.x, d.y, d.z);
  for (int i = 0; i < 3; ++i) CHECK(d[i] == Approx(expected[i]).margin(1e-4));
}

void check_two(const scene::Camera& c, dvec3 at_2_1, dvec3 at_5_4) {
  check_direction(direction(c, 2, 1), at_2_1);
  check_direction(direction(c, 5, 4), at_5_4);
}

scene::Camera camera(Kind kind, double angle_deg = 90) {
  scene::Camera c;
  c.kind = kind;
  c.angle_deg = angle_deg;
  return c;
}

}  // namespace

TEST_CASE("camera: perspective rays go through pixel centres", "[tracer][camera]") {
  scene::Camera c;
  SECTION("default") { check_two(c, {-0.2352, 0.2357, 0.9429}, {0.2352, -0.2357, 0.9429}); }
  SECTION("angle 40") {
    c.direction = {0, 0, 1.33 / (2 * std::tan(glm::radians(20.0)))};
    check_two(c, {-0.1340, 0.1344, 0.9818}, {0.1340, -0.1344, 0.9818});
  }
}

TEST_CASE("camera: orthographic rays are parallel and start side by side", "[tracer][camera]") {
  // location <0,0,-6> look_at 0 angle 40 right x up y, as resolved: half width 6 tan 20.
  scene::Camera c = camera(Kind::orthographic);
  const double width = 12 * std::tan(glm::radians(20.0));
  c.location = {0, 0, -6};
  c.direction = {0, 0, 2.5};
  c.right = {width, 0, 0};
  c.up = {0, width, 0};
  const Ray first = look(c, 0.5 / 4 - 0.5, 0).ray;
  CHECK(first.o.x == Approx(-1.6378).margin(1e-4));
  CHECK(first.d == dvec3(0, 0, 1));
  CHECK(look(c, 1.5 / 4 - 0.5, 0).ray.o.x == Approx(-0.5458).margin(1e-3));
}

TEST_CASE("camera: user_defined rays follow its functions and transformations",
          "[tracer][camera]") {
  functions::FunctionBuilder b(2);
  const auto u = std::make_shared<const functions::Function>(b.finish(b.parameter(0)));
  functions::FunctionBuilder one(2);
  const auto constant = std::make_shared<const functions::Function>(one.finish(one.constant(1)));
  scene::Camera c = camera(Kind::user_defined);
  c.location = {0, 0, -5};
  c.transform = SharedTransform(Transform::translate({0, 3, 0}));
  SECTION("functions for both") {
    c.location_functions = {u, u, constant};
    c.direction_functions = {constant, constant, constant};
    const Ray ray = look(c, 0.25, -0.5).ray;
    CHECK(ray.o == dvec3(0.25, 3.25, 1));
    check_direction(ray.d, dvec3(1, 1, 1) / std::sqrt(3.0));
  }
  SECTION("no functions: perspective") {
    CHECK(look(c, 0, 0).ray.o == dvec3(0, 0, -5));
    check_direction(look(c, 0, 0).ray.d, {0, 0, 1});
  }
}

TEST_CASE("camera: wide lenses see what the oracle's see", "[tracer][camera]") {
  SECTION("fisheye") {
    check_two(camera(Kind::fisheye, 170), {-0.6118, 0.6133, 0.4996}, {0.6118, -0.6133, 0.4996});
  }
  SECTION("ultra_wide_angle") {
    check_two(camera(Kind::ultra_wide_angle, 120), {-0.3786, 0.3795, 0.8441},
              {0.3786, -0.3795, 0.8441});
  }
  SECTION("omnimax") {
    check_two(camera(Kind::omnimax), {-0.4621, 0.7259, 0.5093}, {0.5135, -0.2229, 0.8286});
  }
  SECTION("panoramic") {
    check_two(camera(Kind::panoramic), {-0.4940, 0.6685, 0.5559}, {0.4940, -0.6685, 0.5559});
  }
  SECTION("spherical") {
    check_two(camera(Kind::spherical, 360), {-0.6533, 0.7071, 0.2706}, {0.6533, -0.7071, 0.2706});
  }
}

TEST_CASE("camera: cylinders stand and lie", "[tracer][camera]") {
  scene::Camera c = camera(Kind::cylinder, 100);
  SECTION("1") {
    c.cylinder_type = 1;
    check_two(c, {-0.3118, 0.2425, 0.9187}, {0.3118, -0.2425, 0.9187});
  }
  SECTION("2") {
    c.cylinder_type = 2;
    check_two(c, {-0.2420, 0.4101, 0.8794}, {0.2420, -0.4101, 0.8794});
  }
  SECTION("3 and 4 look at right angles from their axis") {
    c.cylinder_type = GENERATE(3, 4);
    const Ray ray = look(c, 0.25, 0.25).ray;
    const double turn = glm::radians(25.0);
    if (c.cylinder_type == 3) {
      check_direction(ray.o, {0, 0.25, 0});
      check_direction(ray.d, {std::sin(turn), 0, std::cos(turn)});
    } else {
      check_direction(ray.o, {0.3325, 0, 0});
      check_direction(ray.d, {0, std::sin(turn), std::cos(turn)});
    }
  }
}

TEST_CASE("camera: there is nothing outside of a fisheye's circle", "[tracer][camera]") {
  CHECK_FALSE(look(camera(Kind::fisheye, 170), 0.45, 0.2).found);
  CHECK(look(camera(Kind::fisheye, 170), 0.2, 0.2).found);
  CHECK_FALSE(look(camera(Kind::omnimax), 0, -0.6).found);
}

TEST_CASE("camera: rays of a mesh camera leave the faces along their normals", "[tracer][camera]") {
  scene::Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {3, 3, 0}};
  mesh.faces = {{0, 2, 1}, {1, 2, 3}};
  scene::MeshCamera m;
  m.meshes = {std::make_shared<const scene::Mesh>(mesh)};
  m.transforms.resize(1);
  scene::Camera c = camera(Kind::mesh_camera);
  c.location = {0, 0, 0.5};
  c.direction = {0, 0, GENERATE(1.0, -1.0)};
  c.mesh = scene::MeshCamera(m);
  const tracer::Camera made(c);
  functions::Workspace workspace;
  tracer::CameraRay out;
  const auto ray = [&](int x, int y) {
    return made.ray({0, 0, x * 1.0, y * 1.0, 2, 2, 0}, workspace, out);
  };
  REQUIRE(ray(1, 0));
  CHECK(out.ray.o == dvec3(2, 2, 0.5));
  CHECK(out.ray.d == dvec3(0, 0, c.direction.z));
  CHECK(ray(0, 1));  // rows 0 and 1 are the same
  CHECK_FALSE(ray(0, 2));
}

TEST_CASE("camera: rays of a pinhole are the same one by one and in lanes", "[tracer][camera]") {
  scene::Camera c;
  c.location = {1, 2, 3};
  c.direction = {0.3, -0.2, 1.1};
  c.right = {1.3, 0.1, -0.02};
  c.up = {0.01, 0.97, 0.11};
  const tracer::Pinhole hole{&c, 401, 303};
  tracer::PinholeRays places;
  for (std::size_t i = 0; i < tracer::most_in_packet; ++i) {
    const auto n = static_cast<double>(i);
    places.x[i] = i < 8 ? n - 1 : n * 26.3 - 0.37;
    places.y[i] = i < 8 ? 302 - n : n * 20.1 - 0.61;
    places.key[i] = static_cast<std::uint32_t>(i * i);
  }
  for (const tracer::PinholeVersion look_through : tracer::pinhole_versions()) {
    tracer::PinholeRays rays = places;
    look_through(hole, rays);
    for (std::size_t i = 0; i < tracer::most_in_packet; ++i) {
      CAPTURE(i);
      const double u = (places.x[i] + 0.5) / hole.width - 0.5;
      const double v = (hole.height - 1 - places.y[i] + 0.5) / hole.height - 0.5;
      CHECK(rays.rays.d[i] == look(c, u, v).ray.d);
      CHECK(rays.key[i] == tracer::sample_seed(places.x[i], places.y[i], places.key[i]));
    }
  }
}

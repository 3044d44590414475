// Hits and normals that the oracle printed for `trace` on objects made of curves and fields
// (objects §15), and what curves must not do: lose a surface, or show one twice.
#include "tests/unit/tracer_geometry/scenes.h"

namespace durer::tracer::test {
namespace {

struct Expected {
  const char* type;
  std::vector<double> args;
  Ray ray;
  dvec3 p;
  dvec3 n;
};

constexpr double plain = scene::none;

std::vector<Expected> oracle_hits() {
  const dvec3 z(0, 0, 1);
  return {
      {"blob",
       {0.6, 0,     -0.5, 0, 0,  1, 1, plain, 0, 0.5, 0,    0,    1,
        1,   plain, 1,    0, -1, 0, 0, 1,     0, 0.5, -0.5, plain},
       {{0.3, 0.1, -10}, z},
       {0.3, 0.1, -0.4378840},
       {-0.060728, 0.222228, -0.973102}},
      {"lathe",
       {1, 0, -1, 0.5, 0, 1, 1, 0.5, 2, 0.7, 3},
       {{0.2, 1.4, -10}, z},
       {0.2, 1.4, -0.8979978},
       {0.201843, 0.371391, -0.906272}},
      {"lathe",
       {2, 0, -1, 0.5, 0, 1, 1, 0.5, 2, 0.7, 3, 0, 4},
       {{0.2, 1.4, -10}, {0, 0.05, 1}},
       {0.2, 1.8751475, -0.4970508},
       {0.345398, 0.379271, -0.858402}},
      {"lathe",
       {3, 0.5, 0, 1.5, 0.5, 0, 1.5, 0.5, 2},
       {{0.2, 1.4, -10}, z},
       {0.2, 1.4, -0.4435700},
       {0.375631, 0.406027, -0.833093}},
      {"prism",
       {2, 0, 0, 1, 0, -1, 1, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0},
       {{0.3, 0.5, -10}, z},
       {0.3, 0.5, -0.0992177},
       {-0.191921, 0, -0.981410}},
      {"prism",
       {3, 1, 0, 1, 0, -1, 0, -1, -1, 1, -1, 1, 0, 1, 0, 1, 1, -1, 1, -1, 0},
       {{0.2, 0.5, -10}, z},
       {0.2, 0.5, -0.3469522},
       {-0.223643, 0.614457, 0.756589}},
      {"sor",
       {0, 0.5, -1, 0.5, 0, 1, 1, 0.4, 2, 0.3, 3},
       {{0.2, 1.4, -10}, z},
       {0.2, 1.4, -0.8226786},
       {0.197670, 0.547545, -0.813093}},
      {"sphere_sweep",
       {0, 1e-6, 0, 0, 0, 1, 2, 0, 0, 0.5},
       {{1, 0.2, -5}, z},
       {1, 0.2, -0.7483315},
       {0.25, 0.25, -0.935414}},
      {"sphere_sweep",
       {1, 1e-6, -1, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 0.5, 3, 1, 0, 1},
       {{1, 0.2, -5}, z},
       {1, 0.2, -0.7147950},
       {0.333077, 0.305574, -0.892011}},
      {"sphere_sweep",
       {2, 1e-6, -1, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 0.5, 3, 1, 0, 1},
       {{1, 0.2, -5}, z},
       {1, 0.2, -0.7504483},
       {0.175720, 0.238703, -0.955062}},
      {"ovus",
       {1.5, 1},
       {{0.2, 1.2, -10}, z},
       {0.2, 1.2, -1.3105350},
       {0.141631, 0.344444, -0.928062}},
      {"ovus",
       {1, 1.5},
       {{0.2, 0.1, -10}, z},
       {0.2, 0.1, -1.2472781},
       {0.143316, -0.425, -0.893776}},
      {"polygon",
       {5, 0, 0, 0, 1, 0, 0.5, 1, 1, 0.5, 0, 1, 0, 0, 0, 0},
       {{0.2, 0.3, -5}, z},
       {0.2, 0.3, 0.1},
       {-0.447214, 0, 0.894427}},
      {"bicubic_patch",
       {3, 3, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 0, 1, 0, 1, 1, 1, 2,
        1, 1, 3, 1, 0, 0, 2, 0, 1, 2, 1, 2, 2, 1, 3, 2, 0, 0, 3, 0, 1, 3, 0, 2, 3, 0, 3, 3, 0},
       {{1.4, 1.3, -5}, z},
       {1.4, 1.3, 0.5349609},
       {0.045805, 0.095289, -0.994395}},
      {"julia_fractal",
       {-0.083, 0, -0.83, -0.025, 0, 0, 0, 0, 8, 15, 0, 0, 0, 1, 0},
       {{0.1, 0.2, -5}, z},
       {0.1, 0.2, -0.3413396},
       {0.854708, 0.141788, -0.499371}},
      {"julia_fractal",
       {-0.083, 0, -0.83, -0.025, 0, 1, 0, 0, 8, 15, 0, 0, 0, 1, 0},
       {{0.1, 0.2, -5}, z},
       {0.1, 0.2, -1.0919235},
       {0.270494, 0.244841, -0.931067}},
      {"julia_fractal",
       {-0.083, 0, -0.83, -0.025, 1, 0, 0, 0, 8, 15, 0, 0, 0, 1, 0},
       {{0.1, 0.2, -5}, z},
       {0.1, 0.2, -0.2355982},
       {0.622886, 0.553172, -0.553185}},
      {"julia_fractal",
       {-0.5, 0.2, 0.1, 0, 1, 3, 0, 0, 8, 15, 0, 0, 0, 1, 0},
       {{0.1, 0.2, -5}, z},
       {0.1, 0.2, -0.3560363},
       {0.997752, 0.058981, 0.031807}},
      {"julia_fractal",
       {0.2, 0.1, 0, 0, 1, 4, 0, 0, 6, 15, 0, 0, 0, 1, 0},
       {{0.1, 0.2, -5}, z},
       {0.1, 0.2, -1.0604117},
       {-0.718553, 0.465384, 0.516817}},
  };
}

scene::Object product_field(bool smooth) {
  auto field = std::make_shared<scene::HeightField>();
  field->width = field->height = 9;
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 9; ++i) {
      field->heights.push_back(static_cast<std::uint16_t>(65535 * (i / 8.0) * (j / 8.0)));
    }
  }
  scene::Object o = primitive("height_field", {0, smooth ? 1.0 : 0.0});
  o.extras.edit().heights = std::move(field);
  return o;
}

void check(const Geometry& geometry, const Ray& ray, dvec3 p, dvec3 n) {
  const auto scratch = geometry.make_scratch();
  Hit hit;
  REQUIRE(geometry.closest({ray.o, glm::normalize(ray.d)}, t_min, no_hit_depth, RayKind::image, hit,
                           *scratch));
  for (int i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(hit.p[i] == Approx(p[i]).margin(2e-7));
    CHECK(std::abs(hit.n[i]) ==
          Approx(std::abs(n[i])).margin(2e-6));  // turned to the viewer or not
  }
}

}  // namespace

TEST_CASE("curves: the oracle's hits", "[tracer][curves]") {
  for (const Expected& e : oracle_hits()) {
    CAPTURE(e.type, e.args);
    check(only(primitive(e.type, e.args)), e.ray, e.p, e.n);
  }
}

TEST_CASE("superellipsoid: the oracle's hits", "[tracer][superellipsoid]") {
  const Transform turn = Transform::rotate_deg({20, 30, 0});
  check(only(primitive("superellipsoid", {0.25, 0.5}, turn)), {{0.3, 0.4, -10}, {0, 0, 1}},
        {0.3, 0.4, -1.0816414}, {0.151922, 0.271883, -0.950263});
  check(only(primitive("superellipsoid", {1.5, 0.7}, turn)), {{0.1, 0.2, -10}, {0, 0, 1}},
        {0.1, 0.2, -1.0560141}, {-0.025456, 0.035155, -0.999058});
}

TEST_CASE("height_field: the oracle's hits, flat and smooth", "[tracer][height_field]") {
  const Ray down{{0.7, 5, 0.2}, {0, -1, 0}};
  check(only(product_field(false)), down, {0.7, 0.5624847, 0.2}, {-0.514496, 0.685994, 0.514496});
  check(only(product_field(true)), down, {0.7, 0.5624847, 0.2}, {-0.585618, 0.627523, 0.513095});
}

TEST_CASE("curves: the nearest hit is the first crossing, and shadows fall where there is one",
          "[tracer][curves]") {
  Random random(11);
  for (const char* name : {"blob", "prism", "text", "lathe", "sphere_sweep"}) {
    const PrimitiveType& type = *primitive_types()[type_named(name)];
    for (const std::vector<double>& args : type.samples()) {
      TypeStores stores = type.make_stores();
      const auto ref = type.place(stores, args, {}, false);
      REQUIRE(ref);
      ref->store->tags[ref->shape].mask = 0xFF;
      for (int i = 0; i < 3000; ++i) {
        const Ray ray{point_in_cube(random, 2.5), direction(random)};
        const double t_from = 0.02;
        const double t_to = uniform(random, 0.1, 6);
        const auto ask = [&](bool any) {
          RayQuery query{ray, t_from, t_to, nullptr, nullptr, nullptr, {}, {}, 0xFF, any};
          ref->store->nearest(*ref->store, ref->shape, query);
          return query;
        };
        const RayQuery found = ask(false);
        CAPTURE(name, args, i);
        REQUIRE((ask(true).found.store != nullptr) == (found.found.store != nullptr));
        if (name == std::string("lathe")) continue;  // has no inside near its axis
        Crossings crossings;
        std::vector<std::uint32_t> begun;
        const LeafShape leaf{0, ref->shape};
        ref->store->crossings(std::span(&leaf, 1), ray, crossings, begun);
        const auto first = first_visible(crossings, t_from, t_to);
        REQUIRE(first.has_value() == (found.found.store != nullptr));
        if (first) REQUIRE(found.t_to == Approx(first->t).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("curves: boxes end where the oracle's do", "[tracer][extent]") {
  const auto box = [](const char* type, std::vector<double> args) {
    const PrimitiveType& t = *primitive_types()[type_named(type)];
    TypeStores stores = t.make_stores();
    const auto ref = t.place(stores, args, {}, false);
    return ref->store->surface_bounds(ref->shape);
  };
  const Bounds3 egg = box("ovus", {1, 1.5});
  CHECK(egg.hi.x == Approx(1.547631264));
  CHECK(egg.hi.y == Approx(2.5));
  const Bounds3 sweep =
      box("sphere_sweep", {1, 1e-6, -1, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 0.5, 3, 0, 0, 1});
  CHECK(sweep.lo.x == Approx(-3));
  CHECK(sweep.hi.x == Approx(5));
  const Bounds3 rod = box("blob", {0.5, 1, 0, 0, 0, 0, 1, 0, 1, 1, plain});
  CHECK(rod.hi.x == Approx(1.118034005));
  CHECK(rod.lo.y == Approx(-1));
  CHECK(rod.hi.y == Approx(2));
}

}  // namespace durer::tracer::test

// What every primitive must hold, whoever writes it: a loop over the registry with the samples that
// each type brings, under several placements.
#include <algorithm>
#include <limits>
#include <random>

#include "tests/support/catch.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double lo, double hi) {
  return std::uniform_real_distribution<double>(lo, hi)(random);
}
dvec3 point_in_cube(Random& random, double half) {
  const double x = uniform(random, -half, half);
  const double y = uniform(random, -half, half);
  return {x, y, uniform(random, -half, half)};
}

std::vector<Transform> placements() {
  Transform skewed = Transform::rotate_deg({20, 30, -50});
  skewed = skewed.then(Transform::scale({2, -0.5, 1})).then(Transform::rotate_deg({10, 0, 70}));
  return {{},
          Transform::translate({3, -20, 7}),
          Transform::scale(dvec3(0.01)).then(Transform::rotate_deg({30, 40, 50})),
          skewed.then(Transform::translate({100, 0, -1}))};
}

std::vector<scene::Object> samples_of(const PrimitiveType& type) {
  std::vector<scene::Object> objects;
  for (auto& args : type.samples()) objects.emplace_back().args = std::move(args);
  if (type.sample_objects != nullptr) {
    for (auto& object : type.sample_objects()) objects.push_back(std::move(object));
  }
  return objects;
}

/// One placed sample with whatever the checks ask of it.
class Subject {
 public:
  Subject(const PrimitiveType& type, const scene::Object& object, const Transform& to_world,
          bool by_uv = false)
      : type_(&type),
        stores_(type.make_stores()),
        ref_(place_object(type, stores_, object, {}, to_world, false, by_uv)) {
    if (!ref_) return;
    const Bounds3 box = surface_box();
    const bool endless = box.infinite();
    middle_ = endless ? to_world.point(dvec3(0.0)) : (box.lo + box.hi) * 0.5;
    size_ = endless ? glm::length(to_world.vector({1, 1, 1})) : glm::distance(box.lo, box.hi);
  }

  [[nodiscard]] const PrimitiveType& type() const { return *type_; }
  [[nodiscard]] bool exists() const { return ref_.has_value(); }
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] Bounds3 surface_box() const { return store().surface_bounds(ref_->shape); }
  [[nodiscard]] Bounds3 inside_box() const { return store().inside_bounds(ref_->shape); }
  [[nodiscard]] Bounds3 inside_within(const Bounds3& box) const {
    return store().inside_within(ref_->shape, box);
  }
  [[nodiscard]] dvec2 uv(dvec3 p, std::uint32_t part) const {
    return store().uv(ref_->shape, p, part);
  }
  [[nodiscard]] bool has_uv() const { return store().has_uv(); }
  [[nodiscard]] bool contains(dvec3 p) const { return store().contains(ref_->shape, p); }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const {
    return store().normal(ref_->shape, p, part);
  }
  [[nodiscard]] Crossings crossings(const Ray& ray) const {
    Crossings out;
    std::vector<std::uint32_t> begun;
    const LeafShape leaf{0, ref_->shape};
    store().crossings({&leaf, 1}, ray, out, begun);
    std::sort(out.begin(), out.end(),
              [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    return out;
  }
  [[nodiscard]] bool begins_inside(const Ray& ray) const {
    Crossings out;
    std::vector<std::uint32_t> begun;
    const LeafShape leaf{0, ref_->shape};
    store().crossings({&leaf, 1}, ray, out, begun);
    return !begun.empty();
  }
  [[nodiscard]] RayQuery nearest(const Ray& ray, double t_from, double t_to) const {
    ref_->store->tags[ref_->shape] = {0, seen_by_image, false};
    RayQuery query{ray, t_from, t_to, nullptr, nullptr, nullptr, {}, {}, seen_by_image, false};
    store().nearest(store(), ref_->shape, query);
    return query;
  }
  /// Towards the neighbourhood of the shape, from up to three sizes away.
  [[nodiscard]] Ray ray(Random& random) const {
    const dvec3 o = middle_ + point_in_cube(random, 3 * size_);
    const Bounds3 box = surface_box();
    const dvec3 reach = box.infinite() ? dvec3(size_) : box.hi - box.lo;
    const dvec3 target = middle_ + reach * point_in_cube(random, 0.6);
    return {o, glm::normalize(target - o)};
  }
  [[nodiscard]] dvec3 point(Random& random) const { return middle_ + point_in_cube(random, size_); }

 private:
  [[nodiscard]] const Store& store() const { return *ref_->store; }

  const PrimitiveType* type_;
  TypeStores stores_;
  std::optional<ShapeRef> ref_;
  dvec3 middle_{0.0};
  double size_ = 1;
};

/// Runs `check(subject, random)` for every sample of every primitive in every placement.
template <typename Check>
void for_every_subject(Check&& check) {
  for (const PrimitiveType* type : primitive_types()) {
    CAPTURE(type->name);
    const auto samples = samples_of(*type);
    REQUIRE(samples.size() >= 2);
    for (const scene::Object& sample : samples) {
      const std::vector<double> args(sample.args.begin(), sample.args.end());
      CAPTURE(args);
      REQUIRE(
          (type->open_ended ? args.size() >= type->arg_count() : args.size() == type->arg_count()));
      if (type->validate != nullptr) CHECK_FALSE(type->validate(args).has_value());
      const auto all = placements();
      for (std::size_t i = 0; i < all.size(); ++i) {
        CAPTURE(i);
        const Subject subject(*type, sample, all[i]);
        REQUIRE(subject.exists());
        Random random(i + 1);
        check(subject, random);
      }
    }
  }
}

constexpr int ray_count = 1000;

}  // namespace

TEST_CASE("primitives: every type is described", "[conformance]") {
  std::vector<std::string_view> names;
  for (const PrimitiveType* type : primitive_types()) {
    CAPTURE(type->name);
    CHECK_FALSE(type->doc.empty());
    CHECK((!type->params.empty() || type->place_whole != nullptr));
    for (const scene::Param& p : type->params) CHECK_FALSE(p.doc.empty());
    names.push_back(type->name);
  }
  CHECK(std::is_sorted(names.begin(), names.end()));
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

TEST_CASE("primitives: boxes enclose surface and inside", "[conformance]") {
  for_every_subject([](const Subject& s, Random& random) {
    const Bounds3 surface = s.surface_box();
    const Bounds3 inside = s.inside_box();
    const dvec3 slack(1e-9 * s.size());
    int outside = 0;
    int hits = 0;
    for (int i = 0; i < ray_count; ++i) {
      const Ray ray = s.ray(random);
      for (const Crossing& c : s.crossings(ray)) {
        if (!c.visible) continue;
        ++hits;
        if (!Bounds3{surface.lo - slack, surface.hi + slack}.contains(ray.at(c.t))) ++outside;
      }
      const dvec3 p = s.point(random);
      if (s.contains(p) && !inside.contains(p)) ++outside;
    }
    CHECK(hits > 0);
    CHECK(outside == 0);
  });
}

TEST_CASE("primitives: what is known of the inside within a box holds all of it", "[conformance]") {
  for_every_subject([](const Subject& s, Random& random) {
    int outside = 0;
    for (int i = 0; i < 50; ++i) {
      Bounds3 box;
      box.add(s.point(random));
      box.add(s.point(random));
      const Bounds3 probes = box;
      for (int axis = 0; axis < 3; ++axis) {  // some are open on some sides
        if (random() % 4 == 0) box.lo[axis] = -unbounded;
        if (random() % 4 == 0) box.hi[axis] = unbounded;
      }
      const Bounds3 found = s.inside_within(box);
      const dvec3 slack(1e-9 * s.size());
      for (int k = 0; k < 40; ++k) {
        const dvec3 p = probes.lo + (probes.hi - probes.lo) * (point_in_cube(random, 0.5) + 0.5);
        if (s.contains(p) && !Bounds3{found.lo - slack, found.hi + slack}.contains(p)) ++outside;
      }
    }
    CHECK(outside == 0);
  });
}

TEST_CASE("primitives: surface coordinates turn with the surface", "[conformance]") {
  for (const PrimitiveType* type : primitive_types()) {
    CAPTURE(type->name);
    for (const scene::Object& sample : samples_of(*type)) {
      const Subject still(*type, sample, {}, true);
      if (!still.has_uv()) continue;
      for (const Transform& placement : placements()) {
        const Subject moved(*type, sample, placement, true);
        Random random(5);
        for (int i = 0; i < 100; ++i) {
          const Ray ray = still.ray(random);
          for (const Crossing& c : still.crossings(ray)) {
            const dvec3 p = ray.at(c.t);
            const dvec2 there = moved.uv(placement.point(p), c.part);
            const double off = glm::distance(there, still.uv(p, c.part));
            // u wraps around, and v does at the poles.
            REQUIRE(std::min(off, std::abs(off - 1)) < 1e-6);
          }
        }
      }
    }
  }
}

TEST_CASE("primitives: the inside changes at enter and exit, and only there", "[conformance]") {
  for_every_subject([](const Subject& s, Random& random) {
    int wrong = 0;
    int unbalanced = 0;
    for (int i = 0; i < ray_count; ++i) {
      const Ray ray = s.ray(random);
      const Crossings all = s.crossings(ray);
      bool inside = s.begins_inside(ray);
      for (std::size_t k = 0; k < all.size(); ++k) {
        if (all[k].side != Side::sheet) {
          if (inside == (all[k].side == Side::enter)) ++unbalanced;
          inside = !inside;
        }
        // Between two crossings that are far enough apart to have a between.
        const double next = k + 1 < all.size() ? all[k + 1].t : all[k].t + s.size();
        if (next - all[k].t < 1e-6 * s.size()) continue;
        if (s.contains(ray.at(0.5 * (all[k].t + next))) != inside) ++wrong;
      }
      const double before = all.empty() ? 0 : all[0].t - s.size();
      if (s.contains(ray.at(before)) != s.begins_inside(ray)) ++wrong;
    }
    CHECK(unbalanced == 0);
    CHECK(wrong == 0);
  });
}

TEST_CASE("primitives: normals are unit vectors across the surface", "[conformance]") {
  for_every_subject([](const Subject& s, Random& random) {
    int outward = 0;
    int inward = 0;
    int bad_length = 0;
    for (int i = 0; i < ray_count; ++i) {
      const Ray ray = s.ray(random);
      for (const Crossing& c : s.crossings(ray)) {
        if (!c.visible || c.side == Side::sheet) continue;
        const dvec3 n = s.normal(ray.at(c.t), c.part);
        if (!(std::abs(glm::length(n) - 1) < 1e-12)) ++bad_length;
        const double slope = glm::dot(n, ray.d) * (c.side == Side::enter ? -1 : 1);
        if (slope > 1e-6) ++outward;
        if (slope < -1e-6) ++inward;
      }
    }
    CHECK(bad_length == 0);
    if (s.type().sides_by_order) return;
    CHECK(std::min(outward, inward) == 0);  // a negative radius may turn all of them inward
  });
}

TEST_CASE("primitives: the nearest hit is the first visible crossing", "[conformance]") {
  for_every_subject([](const Subject& s, Random& random) {
    for (int i = 0; i < ray_count; ++i) {
      const Ray ray = s.ray(random);
      const double t_from = uniform(random, 0, 4) * s.size();
      const double t_to = t_from + uniform(random, 0, 4) * s.size();
      const auto expected = first_visible(s.crossings(ray), t_from, t_to);
      const RayQuery found = s.nearest(ray, t_from, t_to);
      REQUIRE((found.found.store != nullptr) == expected.has_value());
      if (!expected) continue;
      REQUIRE(found.t_to == Approx(expected->t).epsilon(s.type().hit_tolerance));
      REQUIRE(found.found.part == expected->part);
    }
  });
}

TEST_CASE("primitives: moving object and ray together changes nothing", "[conformance]") {
  for (const PrimitiveType* type : primitive_types()) {
    for (const scene::Object& sample : samples_of(*type)) {
      const Subject still(*type, sample, {});
      for (const Transform& placement : placements()) {
        const Subject moved(*type, sample, placement);
        CAPTURE(type->name);
        Random random(5);
        int differ = 0;
        for (int i = 0; i < ray_count; ++i) {
          const Ray ray = still.ray(random);
          const dvec3 d = placement.vector(ray.d);
          const double length = glm::length(d);
          const Crossings a = still.crossings(ray);
          const Crossings b = moved.crossings({placement.point(ray.o), d / length});
          if (a.size() != b.size()) {
            ++differ;
            continue;
          }
          for (std::size_t k = 0; k < a.size(); ++k) {
            const bool same = std::abs(a[k].t - b[k].t / length) < 1e-7 * still.size() &&
                              a[k].visible == b[k].visible;
            if (!same) ++differ;
          }
        }
        CHECK(differ <= 1);  // a tangent line may go either way
      }
    }
  }
}

TEST_CASE("primitives: lines that make no sense have no crossings", "[conformance]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for_every_subject([nan](const Subject& s, Random&) {
    CHECK_FALSE(s.nearest({dvec3(0.0), dvec3(nan)}, t_min, 1e9).found.store != nullptr);
    CHECK_FALSE(s.nearest({dvec3(nan), dvec3(0, 0, 1)}, t_min, 1e9).found.store != nullptr);
  });
}

}  // namespace durer::tracer

// Solids against the definition: a surface of one operand counts if its point lies inside all the
// others (intersection), or outside all of them (merge), tested point by point.
#include <algorithm>

#include "tests/unit/tracer_geometry/scenes.h"
#include "tracer/extent.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer::test {
namespace {

using scene::NodeKind;
using scene::Object;
using scene::ObjectId;

/// The definition, evaluated without any cleverness.
class Definition {
 public:
  struct Surface {
    double t;
    std::uint32_t leaf;
    dvec3 n;
  };

  Definition(const scene::Scene& scene, ObjectId root) : scene_(scene) {
    root_ = make(root, {}, false);
  }

  [[nodiscard]] std::vector<Surface> hits(const Ray& ray) const {
    std::vector<Surface> all = hits(*root_, ray);
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    return all;
  }
  [[nodiscard]] bool inside(dvec3 p) const { return inside(*root_, p); }

 private:
  struct Node {
    enum class Rule { leaf, any, outside_others, inside_others } rule = Rule::leaf;
    std::vector<std::unique_ptr<Node>> children;
    std::vector<std::unique_ptr<Node>> clips;
    TypeStores stores;
    ShapeRef ref;
    std::uint32_t leaf = 0;
  };

  std::unique_ptr<Node> make(ObjectId id, const Transform& outer, bool inverted,
                             bool counts = true) {
    const Object& o = scene_.objects[id];
    auto node = std::make_unique<Node>();
    const Transform inner = o.transform.then(outer);
    inverted = inverted != o.inverse;
    if (o.kind == NodeKind::primitive) {
      const PrimitiveType& type = *primitive_types()[o.type];
      node->stores = type.make_stores();
      node->ref = *place_object(type, node->stores, o, {}, inner, inverted);
      if (counts) node->leaf = leaves_++;
    } else {
      const bool cuts = o.kind == NodeKind::intersection || o.kind == NodeKind::difference;
      node->rule = cuts == inverted ? Node::Rule::outside_others : Node::Rule::inside_others;
      if (o.kind == NodeKind::union_ && !inverted) node->rule = Node::Rule::any;
      for (std::size_t i = 0; i < o.children.size(); ++i) {
        const bool subtracted = o.kind == NodeKind::difference && i > 0;
        node->children.push_back(make(o.children[i], inner, inverted != subtracted, counts));
      }
    }
    // Patches take no notice of clips of their own.
    const bool deaf = o.kind == NodeKind::primitive &&
                      primitive_types()[o.type]->name == "bicubic_patch";
    for (const ObjectId clip : o.extras->clips) {
      if (deaf) break;
      node->clips.push_back(make(clip, o.extras->clip_transform.then(outer), false, false));
    }
    return node;
  }

  [[nodiscard]] static bool inside(const Node& node, dvec3 p) {
    for (const auto& clip : node.clips) {
      if (!inside(*clip, p)) return false;
    }
    if (node.rule == Node::Rule::leaf) {
      return node.ref.store->contains(node.ref.shape, p) != node.ref.inverted;
    }
    const auto holds = [p](const auto& child) { return inside(*child, p); };
    return node.rule == Node::Rule::inside_others
               ? std::all_of(node.children.begin(), node.children.end(), holds)
               : std::any_of(node.children.begin(), node.children.end(), holds);
  }

  [[nodiscard]] static std::vector<Surface> hits(const Node& node, const Ray& ray) {
    std::vector<Surface> result;
    if (node.rule == Node::Rule::leaf) {
      Crossings crossings;
      std::vector<std::uint32_t> begun;
      const LeafShape leaf{0, node.ref.shape};
      node.ref.store->crossings({&leaf, 1}, ray, crossings, begun);
      for (const Crossing& c : crossings) {
        if (!c.visible) continue;
        const dvec3 n = node.ref.store->normal(node.ref.shape, ray.at(c.t), c.part);
        result.push_back({c.t, node.leaf, node.ref.inverted ? -n : n});
      }
    }
    for (const auto& child : node.children) {
      for (const Surface& s : hits(*child, ray)) {
        bool kept = true;
        for (const auto& other : node.children) {
          if (other == child || node.rule == Node::Rule::any) continue;
          if (inside(*other, ray.at(s.t)) != (node.rule == Node::Rule::inside_others)) kept = false;
        }
        if (kept) result.push_back(s);
      }
    }
    std::erase_if(result, [&](const Surface& s) {
      return std::any_of(node.clips.begin(), node.clips.end(),
                         [&](const auto& clip) { return !inside(*clip, ray.at(s.t)); });
    });
    return result;
  }

  const scene::Scene& scene_;
  std::unique_ptr<Node> root_;
  std::uint32_t leaves_ = 0;
};

Object random_primitive(Random& random) {
  const auto types = types_with_samples();
  const auto& type = *types[random() % types.size()];
  const auto samples = type.samples();
  Object o = primitive(type.name, samples[random() % samples.size()]);
  o.origin = o.type;  // tells which sort was hit
  const double scale = type.name == "plane" || type.name == "disc" ? 1 : uniform(random, 0.5, 2);
  o.transform = Transform::scale(dvec3(scale, 1, uniform(random, 0.5, 2)))
                    .then(Transform::rotate_deg(point_in_cube(random, 180)))
                    .then(Transform::translate(point_in_cube(random, 2)));
  return o;
}

ObjectId random_tree(SceneBuilder& b, Random& random, int depth) {
  Object o;
  if (depth == 0 || random() % 4 == 0) {
    o = random_primitive(random);
  } else {
    constexpr NodeKind kinds[] = {NodeKind::union_, NodeKind::merge, NodeKind::intersection,
                                  NodeKind::difference};
    o.kind = kinds[random() % 4];
    std::vector<ObjectId> children(2 + random() % 3);
    for (ObjectId& child : children) child = random_tree(b, random, depth - 1);
    o.children = children;
    o.transform = Transform::rotate_deg(point_in_cube(random, 180));
  }
  o.inverse = random() % 6 == 0;
  if (random() % 6 == 0) {
    o.extras.edit().clips.push_back(random_tree(b, random, std::min(depth, 1)));
    o.extras.edit().clip_transform = Transform::translate(point_in_cube(random, 1));
  }
  return b.add(std::move(o));
}

Ray random_ray(Random& random) {
  const dvec3 o = point_in_cube(random, 8);
  const dvec3 to = point_in_cube(random, 3) - o;
  return {o, to / std::sqrt(to.x * to.x + to.y * to.y + to.z * to.z)};
}

}  // namespace

TEST_CASE("csg: random solids show the surfaces that the definition shows", "[tracer][csg]") {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 800; ++seed) {
    Random random(seed);
    SceneBuilder b;
    const ObjectId root = random_tree(b, random, 3);
    b.show(root);
    const Geometry geometry = b.build(seed % 2 == 0 ? Hierarchy::embree : Hierarchy::linear);
    const Definition definition(b.scene, root);
    const auto scratch = geometry.make_scratch();
    CAPTURE(seed);
    for (int i = 0; i < 100; ++i) {
      CAPTURE(i);
      const Ray ray = random_ray(random);
      double t_from = t_min;
      Hit hit;
      for (const Definition::Surface& expected : definition.hits(ray)) {
        if (expected.t < t_min || expected.t > 1e6) continue;
        REQUIRE(geometry.closest(ray, t_from, no_hit_depth, RayKind::image, hit, *scratch));
        REQUIRE(hit.t == Approx(expected.t).epsilon(1e-9));
        REQUIRE(hit.leaf == expected.leaf);
        REQUIRE(std::abs(hit.n.x - expected.n.x) + std::abs(hit.n.y - expected.n.y) +
                    std::abs(hit.n.z - expected.n.z) <
                1e-6);
        t_from = hit.t + 1e-9 * std::max(1.0, hit.t);
        ++compared;
      }
      const bool more = geometry.closest(ray, t_from, 1e6, RayKind::image, hit, *scratch);
      CAPTURE(hit.t, t_from, primitive_types()[geometry.leaves()[hit.leaf].origin]->name);
      REQUIRE_FALSE(more);
    }
  }
  CHECK(compared > 20000);
}

TEST_CASE("csg: random solids contain the points that the definition contains", "[tracer][csg]") {
  int inside = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    SceneBuilder b;
    ObjectId root = random_tree(b, random, 3);
    if (b.scene.objects[root].kind == NodeKind::union_) root = b.csg(NodeKind::merge, {root});
    b.show(root);
    const Geometry geometry = b.build();
    const Definition definition(b.scene, root);
    const auto scratch = geometry.make_scratch();
    CAPTURE(seed);
    for (int i = 0; i < 100; ++i) {
      const dvec3 p = point_in_cube(random, 4);
      std::vector<std::uint32_t> interiors;
      geometry.containing(p, interiors, *scratch);
      const bool holds = definition.inside(p) && extent_of(b.scene, root).contains(p);
      REQUIRE(interiors.size() == (holds ? 1 : 0));
      if (!interiors.empty()) ++inside;
    }
  }
  CHECK(inside > 1000);
}

namespace {

/// Depths of all hits along z from (x, y, -10).
std::vector<double> depths(const Geometry& geometry, double x, double y) {
  const auto scratch = geometry.make_scratch();
  std::vector<double> all;
  Hit hit;
  double t_from = t_min;
  while (geometry.closest({{x, y, -10}, {0, 0, 1}}, t_from, no_hit_depth, RayKind::image, hit,
                          *scratch)) {
    all.push_back(hit.t);
    t_from = hit.t + 1e-9;
  }
  return all;
}

}  // namespace

TEST_CASE("csg: a hole that begins with its block leaves no sliver", "[tracer][csg]") {
  SceneBuilder b;
  const auto block = b.add(primitive("box", {-1, -1, -1, 1, 1, 1}));
  const auto hole = b.add(primitive("box", {-0.5, -0.5, -1, 0.5, 0.5, 1}));
  b.show(b.csg(NodeKind::difference, {block, hole}));
  const Geometry geometry = b.build();
  CHECK(depths(geometry, 0.1, 0.2).empty());
  CHECK(depths(geometry, 0.7, 0.2) == std::vector<double>{9, 11});
}

TEST_CASE("csg: merged boxes that share a face have no wall between them", "[tracer][csg]") {
  SceneBuilder b;
  const auto front = b.add(primitive("box", {-1, -1, -1, 1, 1, 0}));
  const auto back = b.add(primitive("box", {-1, -1, 0, 1, 1, 1}));
  b.show(b.csg(NodeKind::merge, {front, back}));
  CHECK(depths(b.build(), 0.1, 0.2) == std::vector<double>{9, 11});
}

TEST_CASE("csg: an open cylinder cuts like a closed one and shows no caps", "[tracer][csg]") {
  SceneBuilder b;
  const auto tube = b.add(primitive("cylinder", {0, 0, -1, 0, 0, 1, 1, 1}));
  const auto slab = b.add(primitive("box", {-2, -2, -0.5, 2, 2, 0.5}));
  b.show(b.csg(NodeKind::intersection, {tube, slab}));
  CHECK(depths(b.build(), 0.1, 0.2) == std::vector<double>{9.5, 10.5});
  b.scene.roots.clear();
  b.show(tube);
  CHECK(depths(b.build(), 0.1, 0.2).empty());
}

TEST_CASE("csg: a flat box can be seen", "[tracer][csg]") {
  SceneBuilder b;
  const auto plate = b.add(primitive("box", {-1, -1, 0, 1, 1, 0}));
  const auto hole = b.add(primitive("cylinder", {0, 0, -1, 0, 0, 1, 0.5, 0}));
  b.show(b.csg(NodeKind::difference, {plate, hole}));
  const Geometry geometry = b.build();
  CHECK(depths(geometry, 0.8, 0) == std::vector<double>{10});
  CHECK(depths(geometry, 0.1, 0).empty());
}

TEST_CASE("csg: a wrong bound cuts a union, a right one does not", "[tracer][csg]") {
  SceneBuilder b;
  const auto left = b.add(primitive("sphere", {-2, 0, 0, 1}));
  const auto right = b.add(primitive("sphere", {2, 0, 0, 1}));
  const auto both = b.csg(NodeKind::union_, {left, right});
  const auto bound = b.add(primitive("box", {-4, -2, -2, 2, 2, 2}));
  b.scene.objects[both].extras.edit().bounds = {bound};
  b.show(both);
  const Geometry geometry = b.build();
  CHECK(depths(geometry, -2, 0) == std::vector<double>{9, 11});
  CHECK(depths(geometry, 1.9, 0).size() == 2);
  CHECK(depths(geometry, 2.1, 0).empty());
}

}  // namespace durer::tracer::test

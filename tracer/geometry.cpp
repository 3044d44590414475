#include "tracer/geometry.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tracer/accel/accel.h"
#include "tracer/accel/box_tree.h"
#include "tracer/flatten.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer {

bool gates_open(std::uint32_t /*leaf*/, RayQuery& /*query*/) { return true; }

struct GeometryScratch {
  std::vector<std::uint32_t> entries;
};
void DeleteGeometryScratch::operator()(GeometryScratch* s) const { delete s; }

namespace {

/// An entry as `containing` needs it.
struct Body {
  const Store* store = nullptr;
  std::uint32_t shape = 0;
  std::uint32_t interior = 0;
  bool inverted = false;
};

std::uint8_t mask_of(RayKind kind) {
  switch (kind) {
    case RayKind::image: return seen_by_image;
    case RayKind::reflection: return seen_by_reflection;
    case RayKind::shadow: return casts_shadow;
  }
  return 0;
}

}  // namespace

struct Geometry::State {
  std::vector<Leaf> leaves;
  std::vector<std::uint8_t> leaf_inverted;  // normals are negated
  std::vector<Surface> surfaces;
  std::vector<InteriorInstance> interiors;
  std::vector<scene::Light> lights;

  std::vector<TypeStores> stores;  // one per primitive type
  std::unique_ptr<Accel> accel;

  std::vector<Body> bodies;  // in order of declaration
  BoxTree body_boxes;        // of those that are finite …
  std::vector<std::uint32_t> body_of_box;
  std::vector<std::uint32_t> endless_bodies;  // … and the others
  bool translucent_shadows = true;

  [[nodiscard]] std::vector<Store*> all_stores() const {
    std::vector<Store*> all;
    for (const TypeStores& s : stores) {
      all.push_back(s.baked.get());
      all.push_back(s.placed.get());
    }
    return all;
  }
};

namespace {

class Builder {
 public:
  Builder(const scene::Scene& scene, Diagnostics& diagnostics)
      : scene_(scene), diagnostics_(diagnostics) {}

  template <typename State>
  void run(State& state) {
    Flat flat = flatten(scene_, diagnostics_);
    for (const PrimitiveType* type : primitive_types()) state.stores.push_back(type->make_stores());
    state.leaf_inverted.resize(flat.leaves.size());
    for (const FlatEntry& entry : flat.entries) {
      const FlatNode& node = flat.nodes[entry.node];
      if (node.op != Op::leaf) {
        Diagnostic d;
        d.code = Code::not_supported;
        d.message = "CSG is not supported yet";
        diagnostics_.report(std::move(d));
        continue;
      }
      const FlatLeaf& part = flat.parts[node.part];
      const auto ref = primitive_types()[part.object->type]->place(
          state.stores[part.object->type], part.object->args, part.to_world, part.inverted);
      if (!ref) continue;
      ref->store->tags[ref->shape] = {part.leaf, part.mask, part.gate != scene::none};
      state.leaf_inverted[part.leaf] = ref->inverted ? 1 : 0;
      state.bodies.push_back({ref->store, ref->shape, entry.interior, ref->inverted});
    }
    state.leaves = std::move(flat.leaves);
    state.surfaces = std::move(flat.surfaces);
    state.interiors = std::move(flat.interiors);
    state.lights = std::move(flat.lights);
    index_bodies(state);
  }

 private:
  template <typename State>
  static void index_bodies(State& state) {
    std::vector<Bounds3> boxes;
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) {
      const Body& body = state.bodies[i];
      const Bounds3 b = body.store->inside_bounds(body.shape);
      if (body.inverted || b.infinite()) {
        state.endless_bodies.push_back(i);
      } else {
        state.body_of_box.push_back(i);
        boxes.push_back(b);
      }
    }
    state.body_boxes = BoxTree(boxes);
  }

  const scene::Scene& scene_;
  Diagnostics& diagnostics_;
};

}  // namespace

Geometry::Geometry(std::unique_ptr<State> state) : state_(std::move(state)) {}
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;
Geometry::~Geometry() = default;

std::optional<Geometry> Geometry::build(const scene::Scene& scene, Diagnostics& diagnostics,
                                        Hierarchy hierarchy) {
  auto state = std::make_unique<State>();
  const bool had_errors = diagnostics.has_errors();
  Builder(scene, diagnostics).run(*state);
  if (diagnostics.has_errors() && !had_errors) return std::nullopt;
  const std::vector<Store*> stores = state->all_stores();
  const std::vector<const Store*> views(stores.begin(), stores.end());
  state->accel =
      hierarchy == Hierarchy::linear ? make_linear_accel(views) : make_embree_accel(views);
  return Geometry(std::move(state));
}

std::span<const Leaf> Geometry::leaves() const { return state_->leaves; }
std::span<const Surface> Geometry::surfaces() const { return state_->surfaces; }
std::span<const InteriorInstance> Geometry::interiors() const { return state_->interiors; }
std::span<const scene::Light> Geometry::lights() const { return state_->lights; }

void Geometry::set_opaque(std::vector<bool> by_surface) {
  state_->translucent_shadows = false;
  for (Store* store : state_->all_stores()) {
    for (Tag& tag : store->tags) {
      if ((tag.mask & casts_shadow) == 0) continue;
      const bool opaque = by_surface[state_->leaves[tag.leaf].surface];
      if (opaque) {
        tag.mask |= blocks_light;
      } else {
        tag.mask &= static_cast<std::uint8_t>(~blocks_light);
        state_->translucent_shadows = true;
      }
    }
  }
}

GeometryScratchPtr Geometry::make_scratch() const {
  return GeometryScratchPtr(new GeometryScratch);
}

bool Geometry::closest(const Ray& ray, double t_from, double t_to, RayKind kind, Hit& hit,
                       GeometryScratch& /*scratch*/) const {
  RayQuery query{.ray = ray, .t_from = t_from, .t_to = t_to, .mask = mask_of(kind)};
  state_->accel->closest(query);
  const Found& found = query.found;
  if (found.store == nullptr) return false;
  hit.t = query.t_to;
  hit.leaf = found.leaf;
  hit.p = ray.at(hit.t);
  hit.n = found.store->normal(found.shape, hit.p, found.part);
  if (state_->leaf_inverted[found.leaf] != 0) hit.n = -hit.n;
  return true;
}

bool Geometry::occluded(const Ray& ray, double t_from, double t_to,
                        GeometryScratch& /*scratch*/) const {
  const double after = std::nextafter(t_from, std::numeric_limits<double>::infinity());
  RayQuery query{.ray = ray, .t_from = after, .t_to = t_to, .mask = blocks_light};
  return state_->accel->any(query);
}

bool Geometry::has_translucent_shadows() const { return state_->translucent_shadows; }

void Geometry::containing(dvec3 p, std::vector<std::uint32_t>& interiors,
                          GeometryScratch& scratch) const {
  const State& s = *state_;
  scratch.entries.clear();
  const auto test = [&](std::uint32_t i) {
    const Body& body = s.bodies[i];
    if (body.store->contains(body.shape, p) != body.inverted) scratch.entries.push_back(i);
  };
  for (const std::uint32_t i : s.endless_bodies) test(i);
  s.body_boxes.at(p, [&](std::uint32_t box) { test(s.body_of_box[box]); });
  std::sort(scratch.entries.begin(), scratch.entries.end());
  for (const std::uint32_t i : scratch.entries) interiors.push_back(s.bodies[i].interior);
}

}  // namespace durer::tracer

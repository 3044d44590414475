#include "tracer/geometry.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "tracer/geometry_state.h"

namespace durer::tracer {
namespace {

std::size_t error_count(const Diagnostics& diagnostics) {
  return static_cast<std::size_t>(
      std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                    [](const Diagnostic& d) { return d.severity == Severity::error; }));
}

}  // namespace

void DeleteGeometryScratch::operator()(GeometryScratch* s) const { delete s; }

void Geometry::State::resolve_path(const PlacementPath& inner_first, Hit& hit) const {
  dvec3 p = hit.p;
  for (std::uint32_t k = 0; k < hit.depth; ++k) {
    hit.path[k] = inner_first[hit.depth - 1 - k];
    p = placements[hit.path[k]].to_outer.backward.point(p);
    hit.inner[k] = p;
  }
  dvec3 n = hit.store->normal(hit.shape, p, hit.part);
  for (std::uint32_t k = hit.depth; k-- > 0;) {
    const Placement& placement = placements[hit.path[k]];
    n = placement.to_outer.backward.covector(n);
    hit.interior = placement.outer_interior(hit.interior);
  }
  hit.n = glm::normalize(n);
}

Geometry::Geometry(std::unique_ptr<State> state) : state_(std::move(state)) {}
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;
Geometry::~Geometry() = default;

std::optional<Geometry> Geometry::build(const scene::Scene& scene, Diagnostics& diagnostics,
                                        Hierarchy hierarchy, const SharingLimits& limits) {
  const std::size_t errors = error_count(diagnostics);
  Flat flat = flatten(scene, diagnostics, limits);
  if (error_count(diagnostics) > errors) return std::nullopt;
  return Geometry(std::make_unique<State>(std::move(flat), hierarchy));
}

std::optional<Geometry> Geometry::build_object(const scene::Scene& scene, scene::ObjectId object,
                                               Diagnostics& diagnostics,
                                               const Transform& to_world) {
  const std::size_t errors = error_count(diagnostics);
  Flat flat = flatten_object(scene, object, diagnostics, to_world);
  if (error_count(diagnostics) > errors) return std::nullopt;
  const bool few = flat.world.entries.size() < 16;  // then setting up Embree costs more than it saves
  return Geometry(
      std::make_unique<State>(std::move(flat), few ? Hierarchy::linear : Hierarchy::embree));
}

std::span<const Leaf> Geometry::leaves() const { return state_->leaves; }
std::span<const Surface> Geometry::surfaces() const { return state_->surfaces; }
std::span<const InteriorInstance> Geometry::interiors() const { return state_->interiors; }
std::span<const Placement> Geometry::placements() const { return state_->placements; }
std::span<const scene::Light> Geometry::lights() const { return state_->lights; }
std::span<const std::vector<std::uint32_t>> Geometry::lamp_sets() const {
  return state_->lamp_sets;
}
std::span<const Projection> Geometry::projections() const { return state_->projections; }
std::span<const PhotonTarget> Geometry::photon_targets() const { return state_->photon_targets; }

void Geometry::for_surfaces(const std::function<void(const Leaf&, const Bounds3&)>& visit) const {
  for (const TypeStores& stores : state_->world().lone) {
    for (const Store* store : {stores.baked.get(), stores.placed.get()}) {
      for (std::uint32_t i = 0; i < store->size(); ++i) {
        visit(state_->leaves[store->tags[i].leaf], store->surface_bounds(i));
      }
    }
  }
  for (const Body& body : state_->world().bodies) {
    if (body.kind != Body::Kind::solid) continue;
    const Solid& solid = state_->parts.solids[body.index];
    for (const SolidLeaf& leaf : solid.leaves) {
      if (leaf.muted) continue;
      const Bounds3 own = leaf.store->surface_bounds(leaf.shape);
      visit(state_->leaves[leaf.store->tags[leaf.shape].leaf], own.intersection(solid.surface));
    }
  }
}

void Geometry::set_opaque(std::vector<bool> by_surface) { state_->set_opaque(by_surface); }
bool Geometry::has_translucent_shadows() const { return state_->translucent_shadows; }
bool Geometry::answers_together() const { return state_->answers_together; }

GeometryScratchPtr Geometry::make_scratch() const {
  return GeometryScratchPtr(new GeometryScratch(state_->parts));
}

bool Geometry::closest(const Ray& ray, double t_from, double t_to, RayKind kind, Hit& hit,
                       GeometryScratch& scratch) const {
  RayQuery query = state_->query(ray, t_from, t_to, kind, scratch);
  state_->accel->closest(query);
  if (query.found.store == nullptr) return false;
  state_->fill_in(query, hit);
  if (hit.depth > 0) {
    state_->resolve_path(query.path, hit);
  } else {
    hit.n = hit.store->normal(hit.shape, hit.p, hit.part);
  }
  state_->orient(hit);
  return true;
}

dvec2 Geometry::uv(const Hit& hit) {
  if (!hit.store->has_uv()) return {hit.p.x, hit.p.y};
  return hit.store->uv(hit.shape, hit.at(hit.depth), hit.part);
}
TextureBlend Geometry::part_textures(const Hit& hit) {
  return hit.store->textures(hit.shape, hit.at(hit.depth), hit.part);
}

TextureBlend Geometry::cutaway_textures(const Hit& hit, bool from_inside) const {
  const Surface& surface = state_->surfaces[state_->leaves[hit.leaf].surface];
  return state_->cutaways[surface.cutaway].lenders(hit.p, hit.leaf, from_inside);
}

bool Geometry::occluded(const Ray& ray, double t_from, double t_to,
                        GeometryScratch& scratch) const {
  RayQuery query = state_->shadow_query(ray, t_from, t_to, scratch);
  return state_->accel->any(query);
}

namespace {

constexpr std::size_t most_casters = 12;  // beyond, the hierarchy is faster

}  // namespace

bool Geometry::casters(const Shaft& shaft, std::vector<Caster>& out) const {
  return state_->caster_index().gather(shaft, most_casters, out);
}
bool Geometry::casters(const Sheet& sheet, std::vector<Caster>& out) const {
  return state_->caster_index().gather(sheet, most_casters, out);
}

Geometry::Way Geometry::way_between(std::span<Caster> among, const Ray& ray, double t_from,
                                    double t_to, GeometryScratch& scratch) const {
  std::array<Caster*, most_casters> near;
  std::size_t count = 0;
  const dvec3 inverse = 1.0 / ray.d;
  for (Caster& c : among) {
    double enter = t_from;
    double leave = t_to;
    if (!BoxTree::clip(c.box, ray.o, inverse, enter, leave)) continue;
    const bool opaque = c.lone != nullptr && (c.lone->tags[c.index].mask & blocks_light) != 0;
    if (!opaque) return Way::unknown;
    near[count++] = &c;
  }
  RayQuery query = state_->shadow_query(ray, t_from, t_to, scratch);
  for (std::size_t i = 0; i < count; ++i) {
    near[i]->targets->nearest(*near[i]->targets, near[i]->index, query);
    if (query.found.store != nullptr) return Way::blocked;
  }
  return Way::open;
}

bool Geometry::occluded_by(std::span<Caster> among, const Ray& ray, double t_from, double t_to,
                           GeometryScratch& scratch) const {
  RayQuery query = state_->shadow_query(ray, t_from, t_to, scratch);
  const dvec3 inverse = 1.0 / ray.d;
  for (Caster& c : among) {
    double enter = query.t_from;
    double leave = t_to;
    if (!BoxTree::clip(c.box, ray.o, inverse, enter, leave)) continue;
    c.targets->nearest(*c.targets, c.index, query);
    if (query.found.store == nullptr) continue;
    std::swap(c, among.front());
    return true;
  }
  return false;
}

void Geometry::containing(dvec3 p, std::vector<std::uint32_t>& interiors,
                          GeometryScratch& scratch) const {
  scratch.bodies.clear();
  state_->containing(state_->world(), p, interiors, scratch.bodies, scratch.sweep);
}

}  // namespace durer::tracer

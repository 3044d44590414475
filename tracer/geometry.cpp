#include "tracer/geometry.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tracer/geometry_state.h"

namespace durer::tracer {
namespace {

std::uint8_t mask_of(RayKind kind) {
  switch (kind) {
    case RayKind::image: return seen_by_image;
    case RayKind::reflection: return seen_by_reflection;
    case RayKind::shadow: return casts_shadow;
  }
  return 0;
}

std::size_t error_count(const Diagnostics& diagnostics) {
  return static_cast<std::size_t>(
      std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                    [](const Diagnostic& d) { return d.severity == Severity::error; }));
}

}  // namespace

struct GeometryScratch {
  SweepState sweep;
  std::vector<std::uint32_t> bodies;
};
void DeleteGeometryScratch::operator()(GeometryScratch* s) const { delete s; }

Geometry::Geometry(std::unique_ptr<State> state) : state_(std::move(state)) {}
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;
Geometry::~Geometry() = default;

std::optional<Geometry> Geometry::build(const scene::Scene& scene, Diagnostics& diagnostics,
                                        Hierarchy hierarchy) {
  const std::size_t errors = error_count(diagnostics);
  Flat flat = flatten(scene, diagnostics);
  if (error_count(diagnostics) > errors) return std::nullopt;
  return Geometry(std::make_unique<State>(std::move(flat), hierarchy));
}

std::optional<Geometry> Geometry::build_object(const scene::Scene& scene, scene::ObjectId object,
                                               Diagnostics& diagnostics,
                                               const Transform& to_world) {
  const std::size_t errors = error_count(diagnostics);
  Flat flat = flatten_object(scene, object, diagnostics, to_world);
  if (error_count(diagnostics) > errors) return std::nullopt;
  const bool few = flat.entries.size() < 16;  // then setting up Embree costs more than it saves
  return Geometry(
      std::make_unique<State>(std::move(flat), few ? Hierarchy::linear : Hierarchy::embree));
}

std::span<const Leaf> Geometry::leaves() const { return state_->leaves; }
std::span<const Surface> Geometry::surfaces() const { return state_->surfaces; }
std::span<const InteriorInstance> Geometry::interiors() const { return state_->interiors; }
std::span<const scene::Light> Geometry::lights() const { return state_->lights; }
std::span<const std::vector<std::uint32_t>> Geometry::lamp_sets() const {
  return state_->lamp_sets;
}
std::span<const Projection> Geometry::projections() const { return state_->projections; }

void Geometry::set_opaque(std::vector<bool> by_surface) { state_->set_opaque(by_surface); }
bool Geometry::has_translucent_shadows() const { return state_->translucent_shadows; }

GeometryScratchPtr Geometry::make_scratch() const {
  return GeometryScratchPtr(new GeometryScratch{state_->parts.make_state(), {}});
}

bool Geometry::closest(const Ray& ray, double t_from, double t_to, RayKind kind, Hit& hit,
                       GeometryScratch& scratch) const {
  RayQuery query{ray, t_from, t_to, mask_of(kind), {}, &state_->parts, &scratch.sweep, false};
  state_->accel->closest(query);
  const Found& found = query.found;
  if (found.store == nullptr) return false;
  hit.t = query.t_to;
  hit.leaf = found.leaf;
  hit.store = found.store;
  hit.shape = found.shape;
  hit.part = found.part;
  hit.p = ray.at(hit.t);
  hit.n = found.store->normal(found.shape, hit.p, found.part);
  if (state_->leaf_inverted[found.leaf] != 0) hit.n = -hit.n;
  return true;
}

dvec2 Geometry::uv(const Hit& hit) { return hit.store->uv(hit.shape, hit.p, hit.part); }
TextureBlend Geometry::part_textures(const Hit& hit) {
  return hit.store->textures(hit.shape, hit.p, hit.part);
}

bool Geometry::occluded(const Ray& ray, double t_from, double t_to,
                        GeometryScratch& scratch) const {
  const double after = t_from * (1 + std::numeric_limits<double>::epsilon());
  RayQuery query{ray, after, t_to, blocks_light, {}, &state_->parts, &scratch.sweep, true};
  return state_->accel->any(query);
}

bool Geometry::casters(const Shaft& shaft, std::vector<Caster>& out) const {
  constexpr std::size_t most = 12;  // beyond, the hierarchy is faster
  std::call_once(state_->casters_found, [this] { state_->index_casters(); });
  return state_->casters.gather(shaft, most, out);
}

bool Geometry::occluded_by(std::span<Caster> among, const Ray& ray, double t_from, double t_to,
                           GeometryScratch& scratch) const {
  const double after = t_from * (1 + std::numeric_limits<double>::epsilon());
  RayQuery query{ray, after, t_to, blocks_light, {}, &state_->parts, &scratch.sweep, true};
  const dvec3 inverse = 1.0 / ray.d;
  for (Caster& c : among) {
    double enter = after;
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
  const State& s = *state_;
  std::vector<std::uint32_t>& found = scratch.bodies;
  found.clear();
  const auto test = [&](std::uint32_t i) {
    if (s.body_contains(s.bodies[i], p, scratch.sweep)) found.push_back(i);
  };
  constexpr int few = 4;
  if (s.questions.load(std::memory_order_relaxed) < few) {
    s.questions.fetch_add(1, std::memory_order_relaxed);
    for (std::uint32_t i = 0; i < s.bodies.size(); ++i) test(i);
  } else {
    s.index_bodies();
    for (const std::uint32_t i : s.index.endless) test(i);
    s.index.boxes.at(p, [&](std::uint32_t box) { test(s.index.body_of_box[box]); });
  }
  std::sort(found.begin(), found.end());
  for (const std::uint32_t i : found) interiors.push_back(s.bodies[i].interior);
}

}  // namespace durer::tracer

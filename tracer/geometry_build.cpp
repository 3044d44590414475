#include <algorithm>
#include <map>

#include "tracer/csg/build.h"
#include "tracer/csg/sweep.h"
#include "tracer/extent.h"
#include "tracer/geometry_state.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer {

Group::Group(const Parts& parts, const std::vector<Placement>& all,
             const std::vector<PlacementTargets::Contents>& contents)
    : solids(std::make_unique<SolidTargets>(parts)),
      placements(std::make_unique<PlacementTargets>(all, contents)) {
  for (const PrimitiveType* type : primitive_types()) lone.push_back(type->make_stores());
}

std::vector<const Targets*> Group::targets() const {
  std::vector<const Targets*> all;
  for (const TypeStores& s : lone) {
    all.push_back(s.baked.get());
    all.push_back(s.placed.get());
  }
  all.push_back(solids.get());
  all.push_back(placements.get());
  return all;
}

Geometry::State::State(Flat flat, Hierarchy hierarchy) {
  for (const PrimitiveType* type : primitive_types()) operands.push_back(type->make_stores());
  around.noise_generator = flat.noise_generator;
  leaf_inverted.assign(flat.leaves.size(), 0);
  parts.gate_of_leaf.assign(flat.leaves.size(), scene::none);
  add_gates(flat);
  placements = std::move(flat.placements);
  contents.reserve(flat.groups.size() + 1);
  for (const FlatGroup& group : flat.groups) add_group(flat, group);
  add_group(flat, flat.world);
  leaves = std::move(flat.leaves);
  add_cutaways(flat);
  surfaces = std::move(flat.surfaces);
  interiors = std::move(flat.world.interiors);
  lights = std::move(flat.lights);
  lamp_sets = std::move(flat.lamp_sets);
  projections = std::move(flat.projections);
  photon_targets = std::move(flat.photon_targets);
  flat = {};  // makes room for the hierarchies
  for (std::size_t i = 0; i < groups.size(); ++i) finish_group(*groups[i], contents[i], hierarchy);
  accel = world().accel.get();
  for (const Targets* targets : world().targets()) {
    if (targets->size() > 0 && targets->nearest_together != nullptr) answers_together = true;
  }
  update_masks();
}

void Geometry::State::add_group(const Flat& flat, const FlatGroup& from) {
  Group& group = *groups.emplace_back(std::make_unique<Group>(parts, placements, contents));
  contents.emplace_back();
  for (const FlatEntry& entry : from.entries) add_entry(group, flat, entry);
}

void Geometry::State::finish_group(Group& group, PlacementTargets::Contents& result,
                                   Hierarchy hierarchy) {
  constexpr std::uint32_t few = 16;  // then setting up Embree costs more than it saves
  std::vector<const Targets*> all;
  std::uint32_t count = 0;
  for (const Targets* targets : group.targets()) {
    if (targets->size() == 0) continue;
    all.push_back(targets);
    count += targets->size();
    for (std::uint32_t i = 0; i < targets->size(); ++i) {
      result.surface.add(targets->surface_bounds(i));
    }
  }
  for (const Body& body : group.bodies) group.inside.add(inside_bounds(body));
  const bool is_world = &group == groups.back().get();
  const bool linear = hierarchy == Hierarchy::linear || (!is_world && count < few);
  group.accel = linear ? make_linear_accel(all) : make_embree_accel(all);
  result.accel = group.accel.get();
}

void Geometry::State::update_masks() {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    groups[i]->solids->update_masks();
    groups[i]->placements->update_masks();
    contents[i].mask = 0;
    for (const Targets* targets : groups[i]->targets()) {
      for (const Tag& tag : targets->tags) contents[i].mask |= tag.mask;
    }
  }
}

void Geometry::State::add_gates(const Flat& flat) {
  const auto place_part = [this](const FlatLeaf& part) { return place(operands, part); };
  for (const FlatGate& flat_gate : flat.gates) {
    Gate gate{flat_gate.box, {}, flat_gate.outer};
    for (const std::uint32_t node : flat_gate.nodes) {
      gate.solids.push_back(add_solid(parts, flat, node, place_part));
    }
    parts.gates.push_back(std::move(gate));
  }
}

void Geometry::State::add_cutaways(const Flat& flat) {
  const auto place_part = [this](const FlatLeaf& part) { return place(operands, part); };
  for (const std::uint32_t node : flat.cutaways) {
    cutaways.push_back(make_cutaway(flat, node, leaves, place_part));
  }
}

namespace {

/// The gate of all that can be seen of a node; nothing if its parts differ in that.
std::optional<std::uint32_t> common_gate(const Flat& flat, std::uint32_t node) {
  const FlatNode& n = flat.nodes[node];
  if (n.op == Op::leaf) return flat.parts[n.part].gate;
  std::optional<std::uint32_t> common;
  for (const std::uint32_t child : n.children) {
    const FlatNode& c = flat.nodes[child];
    if (c.op == Op::leaf && flat.parts[c.part].leaf == scene::none) continue;  // it clips
    const auto gate = common_gate(flat, child);
    if (!gate || (common && *common != *gate)) return std::nullopt;
    common = gate;
  }
  return common;
}

/// True if the node is a primitive whose surface has no end.
bool is_endless(const Flat& flat, const FlatNode& node) {
  if (node.op != Op::leaf) return false;
  const FlatLeaf& part = flat.parts[node.part];
  const PrimitiveType& type = *primitive_types()[part.object->type];
  if (!type.keeps_bounds) return false;
  TypeStores stores = type.make_stores();
  const auto ref = place_object(type, stores, *part.object, {}, part.to_world, part.inverted);
  return ref && ref->store->surface_bounds(ref->shape).infinite();
}

}  // namespace

void Geometry::State::add_entry(Group& group, const Flat& flat, const FlatEntry& entry) {
  if (entry.placement != scene::none) {
    group.placements->add(entry.placement, placements[entry.placement].gate != scene::none);
    group.bodies.push_back(
        {Body::Kind::placement, false, entry.placement, entry.interior, nullptr});
    add_box(group, flat, entry.boxed);
    return;
  }
  const FlatNode& node = flat.nodes[entry.node];
  // What is endless is only asked by rays that meet the bounds that it has: as a solid.
  const Bounds3 bounds = gate_bounds(parts, common_gate(flat, entry.node).value_or(scene::none));
  const bool cut = !bounds.infinite() && is_endless(flat, node);
  if (node.op == Op::leaf && !cut) {
    const auto ref = place(group.lone, flat.parts[node.part]);
    if (!ref) return;
    group.bodies.push_back(
        {Body::Kind::primitive, ref->inverted, ref->shape, entry.interior, ref->store});
    add_box(group, flat, entry.boxed);
    return;
  }
  const std::uint32_t solid = add_solid(
      parts, flat, entry.node, [this](const FlatLeaf& part) { return place(operands, part); });
  parts.solids[solid].gate = bounds;
  group.solids->add(solid);
  group.bodies.push_back({Body::Kind::solid, false, solid, entry.interior, nullptr});
  add_box(group, flat, entry.boxed);
}

/// True if points far from the surface may count as inside.
bool Geometry::State::reaches_far(const Body& body) const {
  if (body.inverted) return true;
  switch (body.kind) {
    case Body::Kind::primitive: return body.store->inside_bounds(body.index).infinite();
    case Body::Kind::solid: {
      const Solid& solid = parts.solids[body.index];
      return !solid.endless.empty() || solid.inside.infinite();
    }
    case Body::Kind::placement: break;
  }
  return groups[placements[body.index].group]->reaches_far;
}

/// For the last body of the group.
void Geometry::State::add_box(Group& group, const Flat& flat, const BoxedObject& boxed) const {
  Body& body = group.bodies.back();
  if (!reaches_far(body)) return;
  group.reaches_far = true;
  if (flat.scene == nullptr || boxed.object == scene::none) return;
  const Bounds3 box = extent_of(*flat.scene, boxed.object, flat.frames[boxed.frame]);
  if (box.infinite()) return;
  body.box = static_cast<std::uint32_t>(group.boxes.size());
  group.boxes.push_back(box);
}

std::optional<ShapeRef> Geometry::State::place(std::vector<TypeStores>& stores,
                                               const FlatLeaf& part) {
  const std::uint32_t type = part.object->type;
  const auto ref = place_object(*primitive_types()[type], stores[type], *part.object, around,
                                part.to_world, part.inverted, part.by_uv);
  if (!ref) return ref;
  Tag& tag = ref->store->tags[ref->shape];
  tag = {part.leaf, part.mask, false};
  if (part.leaf == scene::none) return ref;
  leaf_inverted[part.leaf] = ref->inverted ? 1 : 0;
  if (part.gate != scene::none &&
      !gate_holds(parts, part.gate, ref->store->surface_bounds(ref->shape))) {
    tag.gated = true;
    parts.gate_of_leaf[part.leaf] = part.gate;
  }
  return ref;
}

Bounds3 Geometry::State::inside_bounds(const Body& body) const {
  if (body.inverted) return Bounds3::everything();
  switch (body.kind) {
    case Body::Kind::primitive: return body.store->inside_bounds(body.index);
    case Body::Kind::solid: return parts.solids[body.index].inside;
    case Body::Kind::placement: break;
  }
  const Placement& placement = placements[body.index];
  return groups[placement.group]->inside.transformed(placement.to_outer.forward);
}

void Geometry::State::index_bodies(const Group& group) const {
  std::call_once(group.index_made, [this, &group] {
    std::vector<Bounds3> boxes;
    for (std::uint32_t i = 0; i < group.bodies.size(); ++i) {
      const Bounds3 b = inside_bounds(group.bodies[i]);
      if (b.infinite()) {
        group.index.endless.push_back(i);
      } else {
        group.index.body_of_box.push_back(i);
        boxes.push_back(b);
      }
    }
    group.index.boxes = BoxTree(boxes);
  });
}

const CasterIndex& Geometry::State::caster_index() const {
  std::call_once(casters_found, [this] { casters = CasterIndex(world().targets()); });
  return casters;
}

void Geometry::State::set_opaque(const std::vector<bool>& by_surface) {
  translucent_shadows = false;
  const auto update = [&](Store& store) {
    for (Tag& tag : store.tags) {
      if ((tag.mask & casts_shadow) == 0) continue;
      tag.mask &= static_cast<std::uint8_t>(~blocks_light);
      if (by_surface[leaves[tag.leaf].surface]) {
        tag.mask |= blocks_light;
      } else {
        translucent_shadows = true;
      }
    }
  };
  each_store(update);
  update_masks();
}

std::vector<Geometry::Doubt> Geometry::doubts() const {
  std::map<scene::OriginId, Doubt> found;
  const auto ask = [&](const Store& store) {
    for (std::uint32_t i = 0; i < store.size(); ++i) {
      auto [message, remedy] = store.doubt(i);
      const std::uint32_t leaf = store.tags[i].leaf;
      if (message.empty() || leaf == scene::none) continue;
      const scene::OriginId origin = state_->leaves[leaf].origin;
      found.try_emplace(origin, Doubt{origin, std::move(message), std::move(remedy)});
    }
  };
  state_->each_store(ask);
  std::vector<Doubt> all;
  for (auto& [origin, doubt] : found) all.push_back(std::move(doubt));
  return all;
}

bool Geometry::State::contains(const Body& body, dvec3 p, SweepState& sweep) const {
  switch (body.kind) {
    case Body::Kind::primitive: return body.store->contains(body.index, p) != body.inverted;
    case Body::Kind::solid: return solid_contains(parts.solids[body.index], p, sweep);
    case Body::Kind::placement: break;  // its contents will be asked
  }
  return inside_bounds(body).contains(p);
}

// `found` is a stack: contents that are asked here find their bodies behind ours.
void Geometry::State::containing(const Group& group, dvec3 p,
                                 std::vector<std::uint32_t>& out,
                                 std::vector<std::uint32_t>& found, SweepState& sweep) const {
  const std::size_t first = found.size();
  const auto test = [&](std::uint32_t i) {
    const Body& body = group.bodies[i];
    if (body.box != scene::none && !group.boxes[body.box].contains(p)) return;
    if (contains(body, p, sweep)) found.push_back(i);
  };
  const auto count = static_cast<std::uint32_t>(group.bodies.size());
  constexpr std::uint32_t few = 4;  // bodies, and questions, for which an index is too much
  if (count <= few || group.questions.load(std::memory_order_relaxed) < static_cast<int>(few)) {
    if (count > few) group.questions.fetch_add(1, std::memory_order_relaxed);
    for (std::uint32_t i = 0; i < count; ++i) test(i);
  } else {
    index_bodies(group);
    for (const std::uint32_t i : group.index.endless) test(i);
    group.index.boxes.at(p, [&](std::uint32_t box) { test(group.index.body_of_box[box]); });
  }
  const std::size_t end = found.size();
  if (end > first + 1) std::sort(found.begin() + static_cast<std::ptrdiff_t>(first), found.end());
  for (std::size_t k = first; k < end; ++k) {
    const Body& body = group.bodies[found[k]];
    if (body.kind != Body::Kind::placement) {
      out.push_back(body.interior);
      continue;
    }
    const Placement& placement = placements[body.index];
    const std::size_t known = out.size();
    containing(*groups[placement.group], placement.to_outer.backward.point(p), out, found,
               sweep);
    for (std::size_t i = known; i < out.size(); ++i) {
      out[i] = placement.outer_interior(out[i]);
    }
  }
  found.resize(first);
}

}  // namespace durer::tracer

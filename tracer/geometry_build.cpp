#include <map>

#include "tracer/csg/build.h"
#include "tracer/csg/sweep.h"
#include "tracer/geometry_state.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer {

Geometry::State::State(Flat flat, Hierarchy hierarchy) {
  for (const PrimitiveType* type : primitive_types()) {
    lone.push_back(type->make_stores());
    operands.push_back(type->make_stores());
  }
  solids = std::make_unique<SolidTargets>(parts);
  around.noise_generator = flat.noise_generator;
  leaf_inverted.assign(flat.leaves.size(), 0);
  parts.gate_of_leaf.assign(flat.leaves.size(), scene::none);
  add_gates(flat);
  for (const FlatEntry& entry : flat.entries) add_entry(flat, entry);
  solids->update_masks();
  leaves = std::move(flat.leaves);
  surfaces = std::move(flat.surfaces);
  interiors = std::move(flat.interiors);
  lights = std::move(flat.lights);
  lamp_sets = std::move(flat.lamp_sets);
  projections = std::move(flat.projections);
  flat = {};  // makes room for the hierarchy
  build_accel(hierarchy);
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

void Geometry::State::add_entry(const Flat& flat, const FlatEntry& entry) {
  const FlatNode& node = flat.nodes[entry.node];
  if (node.op == Op::leaf) {
    const auto ref = place(lone, flat.parts[node.part]);
    if (ref) bodies.push_back({ref->store, ref->shape, entry.interior, ref->inverted});
    return;
  }
  const std::uint32_t solid = add_solid(
      parts, flat, entry.node, [this](const FlatLeaf& part) { return place(operands, part); });
  solids->add(solid);
  bodies.push_back({nullptr, solid, entry.interior, false});
}

std::optional<ShapeRef> Geometry::State::place(std::vector<TypeStores>& stores,
                                               const FlatLeaf& part) {
  const std::uint32_t type = part.object->type;
  const auto ref = place_object(*primitive_types()[type], stores[type], *part.object, around,
                                part.to_world, part.inverted);
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

void Geometry::State::index_bodies() const {
  std::call_once(index_made, [this] {
    std::vector<Bounds3> boxes;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      const Body& body = bodies[i];
      const Bounds3 b = body.store != nullptr ? body.store->inside_bounds(body.index)
                                              : parts.solids[body.index].inside;
      if (body.inverted || b.infinite()) {
        index.endless.push_back(i);
      } else {
        index.body_of_box.push_back(i);
        boxes.push_back(b);
      }
    }
    index.boxes = BoxTree(boxes);
  });
}

std::vector<const Targets*> Geometry::State::all_targets() const {
  std::vector<const Targets*> all;
  for (const TypeStores& s : lone) {
    all.push_back(s.baked.get());
    all.push_back(s.placed.get());
  }
  all.push_back(solids.get());
  return all;
}

void Geometry::State::index_casters() const { casters = CasterIndex(all_targets()); }

void Geometry::State::build_accel(Hierarchy hierarchy) {
  const std::vector<const Targets*> all = all_targets();
  accel = hierarchy == Hierarchy::linear ? make_linear_accel(all) : make_embree_accel(all);
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
  for (const std::vector<TypeStores>* stores : {&lone, &operands}) {
    for (const TypeStores& s : *stores) {
      update(*s.baked);
      update(*s.placed);
    }
  }
  solids->update_masks();
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
  for (const auto* stores : {&state_->lone, &state_->operands}) {
    for (const TypeStores& s : *stores) {
      ask(*s.baked);
      ask(*s.placed);
    }
  }
  std::vector<Doubt> all;
  for (auto& [origin, doubt] : found) all.push_back(std::move(doubt));
  return all;
}

bool Geometry::State::body_contains(const Body& body, dvec3 p, SweepState& sweep) const {
  if (body.store == nullptr) return solid_contains(parts.solids[body.index], p, sweep);
  return body.store->contains(body.index, p) != body.inverted;
}

}  // namespace durer::tracer

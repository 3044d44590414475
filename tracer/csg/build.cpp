#include "tracer/csg/build.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/registry.h"

namespace durer::tracer {
namespace {

/// `t` with what is only rounding made zero, so that axes that are parallel are so exactly.
std::optional<Transform> without_dust(const Affine& t) {
  std::array<double, 12> m{t.x.x, t.x.y, t.x.z, t.y.x, t.y.y, t.y.z,
                           t.z.x, t.z.y, t.z.z, t.t.x, t.t.y, t.t.z};
  double greatest = 0;
  for (std::size_t i = 0; i < 9; ++i) greatest = std::max(greatest, std::abs(m[i]));
  for (std::size_t i = 0; i < 9; ++i) {
    if (std::abs(m[i]) < 1e-13 * greatest) m[i] = 0;
  }
  return Transform::matrix(m);
}

/// The inside of an intersection as far as those of its children tell that are leaves, in a space
/// whose map to the world is `frame`.
Bounds3 inside_in(const Flat& flat, const FlatNode& node, const Transform& frame) {
  std::vector<std::pair<TypeStores, ShapeRef>> placed;
  Bounds3 inside = Bounds3::everything();
  for (const std::uint32_t child : node.children) {
    if (flat.nodes[child].op != Op::leaf) continue;
    const FlatLeaf& part = flat.parts[flat.nodes[child].part];
    const PrimitiveType& type = *primitive_types()[part.object->type];
    const auto to_frame = without_dust(part.to_world->forward.then(frame.backward));
    if (type.place_whole != nullptr || !to_frame) continue;
    TypeStores stores = type.make_stores();
    const auto ref = place_object(type, stores, *part.object, {}, *to_frame, part.inverted);
    if (!ref || ref->inverted) continue;
    inside = inside.intersection(ref->store->inside_bounds(ref->shape));
    placed.emplace_back(std::move(stores), *ref);
  }
  constexpr int rounds = 2;  // they may bound each other
  for (int i = 0; i < rounds && !inside.empty(); ++i) {
    for (const auto& [stores, ref] : placed) {
      inside = inside.intersection(ref.store->inside_within(ref.shape, inside));
    }
  }
  return inside;
}

/// What has been turned as a whole, half-spaces and all, has closer bounds along its own axes.
void bound_turned(const Flat& flat, const FlatNode& node, Bounds3& inside) {
  constexpr int most = 3;  // leaves whose axes are tried
  int tried = 0;
  for (const std::uint32_t child : node.children) {
    if (inside.empty() || tried == most) return;
    if (flat.nodes[child].op != Op::leaf) continue;
    const SharedTransform& frame = flat.parts[flat.nodes[child].part].to_world;
    if (frame.is_identity()) continue;
    ++tried;
    const Bounds3 own = inside_in(flat, node, frame);
    if (own.empty()) return void(inside = own);
    if (own.infinite()) continue;
    inside = inside.intersection(BoxTree::grown(own).transformed(frame->forward));
  }
}

class SolidBuilder {
 public:
  SolidBuilder(const Flat& flat, const PlacePart& place) : flat_(flat), place_(place) {}

  Solid run(std::uint32_t root) {
    Extent extent;
    if (flat_.nodes[root].op == Op::leaf) {  // the root of a solid is never a leaf
      add_node(Op::any, no_node, 1);
      extent = add(root, 0);
      solid_.counts[0] = extent.value ? 1 : 0;
    } else {
      extent = add(root, no_node);
    }
    solid_.surface = BoxTree::grown(extent.surface);
    solid_.inside = BoxTree::grown(extent.inside);
    solid_.boxes = BoxTree(boxes_);
    return std::move(solid_);
  }

 private:
  /// What a subtree can reach: where its surface can be seen, where its inside can be, and whether
  /// it is true where all its leaves are empty.
  struct Extent {
    Bounds3 surface;
    Bounds3 inside;
    bool value = false;
    std::uint32_t leaf = no_node;  // of a subtree that is one
  };

  Extent add(std::uint32_t flat_node, std::uint32_t parent) {
    const FlatNode& node = flat_.nodes[flat_node];
    if (node.op == Op::leaf) return add_leaf(flat_.parts[node.part], parent);
    const std::uint32_t index =
        add_node(node.op, parent, static_cast<std::uint32_t>(node.children.size()));
    Extent extent;
    if (node.op == Op::all) extent.inside = Bounds3::everything();
    std::vector<std::uint32_t> leaves;  // among the children
    bool endless = false;               // one of them has no box
    for (const std::uint32_t child : node.children) {
      const Extent e = add(child, index);
      if (e.value) ++solid_.counts[index];
      if (e.leaf != no_node) {
        leaves.push_back(e.leaf);
        endless = endless || (e.inside.infinite() && !solid_.leaves[e.leaf].inverted);
      }
      extent.surface.add(e.surface);
      if (node.op == Op::all) {
        extent.inside = extent.inside.intersection(e.inside);
      } else {
        extent.inside.add(e.inside);
      }
    }
    if (node.op == Op::all) {
      tighten(leaves, extent.inside);
      if (endless) bound_turned(flat_, node, extent.inside);
    }
    // A surface counts inside the others and lies on the border of its own inside.
    if (node.op == Op::all) extent.surface = extent.surface.intersection(extent.inside);
    extent.value = solid_.nodes[index].value(solid_.counts[index]);
    return extent;
  }

  // What is endless by itself (a hyperboloid) may be bounded by what the others leave of it.
  void tighten(const std::vector<std::uint32_t>& leaves, Bounds3& inside) const {
    constexpr int rounds = 2;  // they may bound each other
    for (int i = 0; i < rounds; ++i) {
      for (const std::uint32_t leaf : leaves) {
        const SolidLeaf& l = solid_.leaves[leaf];
        if (inside.empty()) return;
        if (!l.inverted) inside = inside.intersection(l.store->inside_within(l.shape, inside));
      }
    }
  }

  Extent add_leaf(const FlatLeaf& part, std::uint32_t parent) {
    const auto ref = place_(part);
    if (!ref) return add_nothing(part.inverted, parent);
    const auto index = static_cast<std::uint32_t>(solid_.leaves.size());
    solid_.leaves.push_back({ref->store, ref->shape, parent, slot_of(ref->store), ref->inverted,
                             part.muted, absent_for(part, parent)});
    const Bounds3 inside = ref->store->inside_bounds(ref->shape);
    if (inside.infinite()) {
      solid_.endless.push_back(index);
    } else {
      solid_.leaf_of_box.push_back(index);
      boxes_.push_back(inside);
    }
    return {ref->store->surface_bounds(ref->shape), ref->inverted ? Bounds3::everything() : inside,
            ref->inverted, index};
  }

  /// What some rays do not see of a merge does not hide its other parts from them (objects §9.2).
  [[nodiscard]] std::uint8_t absent_for(const FlatLeaf& part, std::uint32_t parent) const {
    constexpr int seen =
        seen_by_image | seen_by_transmission | seen_by_reflection | seen_by_gathering;
    if (part.leaf == scene::none || part.inverted) return 0;
    for (std::uint32_t n = parent; n != no_node; n = solid_.nodes[n].parent) {
      if (solid_.nodes[n].op == Op::merge) return static_cast<std::uint8_t>(seen & ~part.mask);
    }
    return 0;
  }

  // A primitive without surface and inside is a union of nothing; its inverse fills space.
  Extent add_nothing(bool inverted, std::uint32_t parent) {
    add_node(inverted ? Op::all : Op::any, parent, 0);
    return {{}, inverted ? Bounds3::everything() : Bounds3{}, inverted, no_node};
  }

  std::uint32_t add_node(Op op, std::uint32_t parent, std::uint32_t children) {
    solid_.nodes.push_back({op, parent, children});
    solid_.counts.push_back(0);
    return static_cast<std::uint32_t>(solid_.nodes.size() - 1);
  }

  std::uint32_t slot_of(const Store* store) {
    const auto at = std::find(solid_.stores.begin(), solid_.stores.end(), store);
    const auto slot = static_cast<std::uint32_t>(at - solid_.stores.begin());
    if (at == solid_.stores.end()) solid_.stores.push_back(store);
    return slot;
  }

  const Flat& flat_;
  const PlacePart& place_;
  Solid solid_;
  std::vector<Bounds3> boxes_;
};

}  // namespace

std::uint32_t add_solid(Parts& parts, const Flat& flat, std::uint32_t node,
                        const PlacePart& place) {
  Solid solid = SolidBuilder(flat, place).run(node);
  solid.first_node = parts.node_count;
  solid.first_leaf = parts.leaf_count;
  parts.node_count += static_cast<std::uint32_t>(solid.nodes.size());
  parts.leaf_count += static_cast<std::uint32_t>(solid.leaves.size());
  parts.solids.push_back(std::move(solid));
  return static_cast<std::uint32_t>(parts.solids.size() - 1);
}

SweepState Parts::make_state() const {
  SweepState state;
  state.counts.reserve(node_count);
  std::size_t slots = 0;
  for (const Solid& solid : solids) {
    state.counts.insert(state.counts.end(), solid.counts.begin(), solid.counts.end());
    slots = std::max(slots, solid.stores.size());
  }
  state.inside.assign(leaf_count, 0);
  state.solids.asked.resize(slots);
  state.gates.asked.resize(slots);
  return state;
}

}  // namespace durer::tracer

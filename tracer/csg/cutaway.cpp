#include "tracer/csg/cutaway.h"

#include <algorithm>

namespace durer::tracer {
namespace {

/// Appends the tree below `index`; returns where its root went.
std::uint32_t add(const Flat& flat, std::uint32_t index, const std::vector<Leaf>& leaves,
                  const PlacePart& place, std::vector<Cutaway::Node>& out) {
  const FlatNode& from = flat.nodes[index];
  Cutaway::Node node;
  node.op = from.op;
  node.lenders = from.lenders;
  for (const std::uint32_t child : from.children) {
    node.children.push_back(add(flat, child, leaves, place, out));
  }
  if (from.op == Op::leaf) {
    const FlatLeaf& part = flat.parts[from.part];
    node.inverted = part.inverted;
    if (const auto ref = place(part)) {
      node.store = ref->store;
      node.shape = ref->shape;
      node.inverted = ref->inverted;
    }
    node.leaf = part.leaf;
    if (part.leaf != scene::none) {
      const std::uint32_t surface = leaves[part.leaf].surface;
      if (flat.surfaces[surface].cutaway == scene::none) node.surface = surface;
    }
  }
  out.push_back(std::move(node));
  return static_cast<std::uint32_t>(out.size() - 1);
}

}  // namespace

bool Cutaway::holds(const Node& node, const Place& at) const {
  const auto child_holds = [&](std::uint32_t child) { return holds(nodes_[child], at); };
  switch (node.op) {
    case Op::leaf:
      if (node.leaf == at.leaf) return at.in_leaf;
      return (node.store != nullptr && node.store->contains(node.shape, at.p)) != node.inverted;
    case Op::all: return std::all_of(node.children.begin(), node.children.end(), child_holds);
    default: return std::any_of(node.children.begin(), node.children.end(), child_holds);
  }
}

/// Clips of a lender do not count, as the oracle has it; those of what is in it do.
bool Cutaway::lends(const Node& node, const Place& at) const {
  return holds(node.lenders == Lenders::body ? nodes_[node.children[0]] : node, at);
}

void Cutaway::gather(const Node& node, const Place& at, TextureBlend& out) const {
  if (node.op == Op::leaf) {
    if (node.surface != scene::none) out.add(node.surface, 1);
    return;
  }
  switch (node.lenders) {
    case Lenders::nobody: return;
    case Lenders::body: return gather(nodes_[node.children[0]], at, out);
    case Lenders::first:
      if (lends(nodes_[node.children[0]], at)) gather(nodes_[node.children[0]], at, out);
      return;
    case Lenders::all:
      for (const std::uint32_t child : node.children) {
        if (lends(nodes_[child], at)) gather(nodes_[child], at, out);
      }
  }
}

TextureBlend Cutaway::lenders(dvec3 p, std::uint32_t leaf, bool from_inside) const {
  TextureBlend found;
  gather(nodes_.back(), {p, leaf, from_inside}, found);
  for (std::uint32_t i = 0; i < found.count; ++i) {
    found.parts[i].weight = 1.0F / static_cast<float>(found.count);
  }
  if (found.count == 0) {
    found.add(scene::none, 0);
    found.add(scene::none, 0);
  }
  return found;
}

Cutaway make_cutaway(const Flat& flat, std::uint32_t root, const std::vector<Leaf>& leaves,
                     const PlacePart& place) {
  std::vector<Cutaway::Node> nodes;
  add(flat, root, leaves, place, nodes);
  return Cutaway(std::move(nodes));
}

}  // namespace durer::tracer

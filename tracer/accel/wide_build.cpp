// Embree's builder splits the items; what it makes is copied into a flat array of our own.
#include "tracer/accel/wide_build.h"

#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "tracer/accel/box_tree.h"

namespace durer::tracer {
namespace {

/// Beyond any depth that a ray can see, and within what the builder can count with.
constexpr double farthest = 1e15;
constexpr std::size_t largest_leaf = 4;

/// A node or leaf as the builder makes it.
struct Made {
  std::uint32_t count = 0;  // of children or items
  bool leaf = false;
};
struct MadeNode : Made {
  Made* child[WideNodes::width];
  RTCBounds bounds[WideNodes::width];
};
struct MadeLeaf : Made {
  std::uint32_t item[largest_leaf];
};

template <typename T>
T* make(RTCThreadLocalAllocator allocator) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(T), 16)) T;
}

void* make_node(RTCThreadLocalAllocator allocator, unsigned count, void* /*user*/) {
  auto* node = make<MadeNode>(allocator);
  node->count = count;
  return static_cast<Made*>(node);
}
void* make_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives,
                std::size_t count, void* /*user*/) {
  auto* leaf = make<MadeLeaf>(allocator);
  leaf->count = static_cast<std::uint32_t>(count);
  leaf->leaf = true;
  for (std::size_t i = 0; i < count; ++i) leaf->item[i] = primitives[i].primID;
  return static_cast<Made*>(leaf);
}
void set_children(void* to, void** children, unsigned count, void* /*user*/) {
  auto* node = static_cast<MadeNode*>(static_cast<Made*>(to));
  for (unsigned i = 0; i < count; ++i) node->child[i] = static_cast<Made*>(children[i]);
}
void set_bounds(void* to, const RTCBounds** bounds, unsigned count, void* /*user*/) {
  auto* node = static_cast<MadeNode*>(static_cast<Made*>(to));
  for (unsigned i = 0; i < count; ++i) node->bounds[i] = *bounds[i];
}

RTCDevice builder_device() {
  static const struct Holder {
    RTCDevice device = rtcNewDevice(nullptr);
    ~Holder() { rtcReleaseDevice(device); }
  } holder;
  return holder.device;
}

class Copier {
 public:
  Copier(WideNodes& out, const MakeLeaf& make_leaf, double pad)
      : out_(out), make_leaf_(make_leaf), pad_(pad) {}

  void count(const Made& made) {
    if (made.leaf) {
      ++leaves;
      return;
    }
    ++nodes;
    const auto& node = static_cast<const MadeNode&>(made);
    for (std::uint32_t i = 0; i < node.count; ++i) count(*node.child[i]);
  }

  std::uint32_t copy(const Made& made) {
    if (made.leaf) {
      const auto& leaf = static_cast<const MadeLeaf&>(made);
      return WideNodes::leaf_mark | make_leaf_(std::span(leaf.item, leaf.count));
    }
    const auto& from = static_cast<const MadeNode&>(made);
    const auto index = static_cast<std::uint32_t>(out_.nodes.size());
    out_.nodes.emplace_back();
    WideNodes::Node node;
    for (std::size_t i = 0; i < WideNodes::width; ++i) {
      node.child[i] = i < from.count ? copy(*from.child[i]) : WideNodes::leaf_mark;
      put_bounds(node, i, i < from.count ? &from.bounds[i] : nullptr);
    }
    out_.nodes[index] = node;
    return index;
  }

  std::size_t nodes = 0;
  std::size_t leaves = 0;

 private:
  /// Boxes become relative to the centre, larger by the pad; none becomes a box that nothing meets.
  void put_bounds(WideNodes::Node& node, std::size_t i, const RTCBounds* b) const {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (b == nullptr) {
        node.planes[axis][i] = infinity;
        node.planes[axis + 3][i] = -infinity;
        continue;
      }
      const float lo = (&b->lower_x)[axis];
      const float hi = (&b->upper_x)[axis];
      const double center = out_.center[static_cast<int>(axis)];
      node.planes[axis][i] = std::nextafter(static_cast<float>(lo - center - pad_), -infinity);
      node.planes[axis + 3][i] = std::nextafter(static_cast<float>(hi - center + pad_), infinity);
    }
  }

  WideNodes& out_;
  const MakeLeaf& make_leaf_;
  double pad_;
};

}  // namespace

void add_item(WideItems& items, const Bounds3& box, std::uint32_t number, WideNodes& nodes) {
  if (box.empty()) return;
  const dvec3 most = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  if (!(most.x < farthest && most.y < farthest && most.z < farthest)) return;
  nodes.bounds.add(box);
  RTCBuildPrimitive item{};
  item.lower_x = static_cast<float>(box.lo.x), item.upper_x = static_cast<float>(box.hi.x);
  item.lower_y = static_cast<float>(box.lo.y), item.upper_y = static_cast<float>(box.hi.y);
  item.lower_z = static_cast<float>(box.lo.z), item.upper_z = static_cast<float>(box.hi.z);
  item.primID = number;
  items.push_back(item);
}

void build_wide_nodes(WideItems items, std::size_t leaf_size, WideNodes& nodes,
                      const std::function<void(std::size_t)>& expect, const MakeLeaf& make) {
  if (items.empty()) return;
  nodes.reach = BoxTree::grown(nodes.bounds);
  const dvec3 extent = nodes.bounds.hi - nodes.bounds.lo;
  nodes.center = (nodes.bounds.lo + nodes.bounds.hi) * 0.5;
  // Rays are rounded to single precision, and so are their steps: errors of a few 2^-24 of the
  // whole, which the boxes must cover. So is an item, far from the origin.
  const dvec3 most = glm::max(glm::abs(nodes.bounds.lo), glm::abs(nodes.bounds.hi));
  const double pad = 1e-6 * std::max({extent.x, extent.y, extent.z}) +
                     6e-8 * std::max({most.x, most.y, most.z});
  nodes.pad = static_cast<float>(pad);

  RTCBVH bvh = rtcNewBVH(builder_device());
  RTCBuildArguments args = rtcDefaultBuildArguments();
  args.bvh = bvh;
  args.maxBranchingFactor = WideNodes::width;
  args.maxDepth = 32;
  args.sahBlockSize = static_cast<unsigned>(leaf_size);
  args.maxLeafSize = static_cast<unsigned>(leaf_size);
  args.primitives = items.data();
  args.primitiveCount = items.size();
  args.primitiveArrayCapacity = items.size();
  args.createNode = make_node;
  args.createLeaf = make_leaf;
  args.setNodeChildren = set_children;
  args.setNodeBounds = set_bounds;
  const auto* root = static_cast<const Made*>(rtcBuildBVH(&args));
  WideItems().swap(items);
  Copier copier(nodes, make, pad);
  copier.count(*root);
  nodes.nodes.reserve(copier.nodes);
  expect(copier.leaves);
  nodes.root = copier.copy(*root);
  rtcReleaseBVH(bvh);
}

}  // namespace durer::tracer

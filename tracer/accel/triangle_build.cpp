// Embree's builder splits the triangles; what it makes is copied into flat arrays of our own.
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "tracer/accel/embree_api.h"
#include "tracer/accel/triangle_tree.h"

namespace durer::tracer {
namespace {

/// Beyond any depth that a ray can see, and within what the builder can count with.
constexpr double farthest = 1e15;

/// A node or leaf as the builder makes it.
struct Made {
  std::uint32_t count = 0;  // of children or triangles
  bool leaf = false;
};
struct MadeNode : Made {
  Made* child[TriangleTree::width];
  RTCBounds bounds[TriangleTree::width];
};
struct MadeLeaf : Made {
  std::uint32_t face[TriangleTree::block_size];
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
  for (std::size_t i = 0; i < count; ++i) leaf->face[i] = primitives[i].primID;
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

}  // namespace

/// Fills the arrays of a tree.
class TriangleTreeBuilder {
 public:
  TriangleTreeBuilder(const scene::Mesh& mesh, TriangleTree& tree) : mesh_(mesh), tree_(tree) {}

  void run() {
    std::vector<RTCBuildPrimitive> triangles = triangles_with_area();
    if (triangles.empty()) return;
    const dvec3 extent = tree_.bounds_.hi - tree_.bounds_.lo;
    tree_.center_ = (tree_.bounds_.lo + tree_.bounds_.hi) * 0.5;
    // Rays are rounded to single precision, and so are their steps: errors of a few 2^-24 of the
    // whole, which the boxes must cover.
    pad_ = 1e-6 * std::max({extent.x, extent.y, extent.z});
    tree_.pad_ = static_cast<float>(pad_);

    RTCBVH bvh = rtcNewBVH(builder_device());
    RTCBuildArguments args = rtcDefaultBuildArguments();
    args.bvh = bvh;
    args.maxBranchingFactor = TriangleTree::width;
    args.maxDepth = 32;
    args.sahBlockSize = TriangleTree::block_size;
    args.maxLeafSize = TriangleTree::block_size;
    args.primitives = triangles.data();
    args.primitiveCount = triangles.size();
    args.primitiveArrayCapacity = triangles.size();
    args.createNode = make_node;
    args.createLeaf = make_leaf;
    args.setNodeChildren = set_children;
    args.setNodeBounds = set_bounds;
    const auto* root = static_cast<const Made*>(rtcBuildBVH(&args));
    std::vector<RTCBuildPrimitive>().swap(triangles);
    count(*root);
    tree_.nodes_.reserve(nodes_);
    tree_.blocks_.reserve(blocks_);
    tree_.root_ = copy(*root, 0);
    rtcReleaseBVH(bvh);
  }

 private:
  // The oracle never hits triangles without area (objects §11.6). Those that leave the range of
  // single precision have none either, as far as anyone could see.
  std::vector<RTCBuildPrimitive> triangles_with_area() {
    std::vector<RTCBuildPrimitive> triangles;
    triangles.reserve(mesh_.faces.size());
    for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
      const dvec3 a = mesh_.corner(f, 0);
      const dvec3 b = mesh_.corner(f, 1);
      const dvec3 c = mesh_.corner(f, 2);
      if (glm::cross(b - a, c - a) == dvec3(0.0)) continue;
      Bounds3 box;
      for (const dvec3 p : {a, b, c}) box.add(p);
      const dvec3 most = glm::max(glm::abs(box.lo), glm::abs(box.hi));
      if (!(most.x < farthest && most.y < farthest && most.z < farthest)) continue;
      tree_.bounds_.add(box);
      RTCBuildPrimitive t{};
      t.lower_x = static_cast<float>(box.lo.x), t.upper_x = static_cast<float>(box.hi.x);
      t.lower_y = static_cast<float>(box.lo.y), t.upper_y = static_cast<float>(box.hi.y);
      t.lower_z = static_cast<float>(box.lo.z), t.upper_z = static_cast<float>(box.hi.z);
      t.primID = f;
      triangles.push_back(t);
    }
    return triangles;
  }

  void count(const Made& made) {
    if (made.leaf) {
      ++blocks_;
      return;
    }
    ++nodes_;
    const auto& node = static_cast<const MadeNode&>(made);
    for (std::uint32_t i = 0; i < node.count; ++i) count(*node.child[i]);
  }

  std::uint32_t copy(const Made& made, std::size_t depth) {
    if (made.leaf) return copy_leaf(static_cast<const MadeLeaf&>(made));
    const auto& from = static_cast<const MadeNode&>(made);
    const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    TriangleTree::Node node;
    for (std::size_t i = 0; i < TriangleTree::width; ++i) {
      node.child[i] = i < from.count ? copy(*from.child[i], depth + 1) : TriangleTree::leaf_mark;
      put_bounds(node, i, i < from.count ? &from.bounds[i] : nullptr);
    }
    tree_.nodes_[index] = node;
    return index;
  }

  /// Boxes become relative to the centre, larger by the pad; none becomes a box that nothing meets.
  void put_bounds(TriangleTree::Node& node, std::size_t i, const RTCBounds* b) const {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (b == nullptr) {
        node.planes[axis][i] = infinity;
        node.planes[axis + 3][i] = -infinity;
        continue;
      }
      const float lo = (&b->lower_x)[axis];
      const float hi = (&b->upper_x)[axis];
      const double center = tree_.center_[static_cast<int>(axis)];
      node.planes[axis][i] = std::nextafter(static_cast<float>(lo - center - pad_), -infinity);
      node.planes[axis + 3][i] = std::nextafter(static_cast<float>(hi - center + pad_), infinity);
    }
  }

  std::uint32_t copy_leaf(const MadeLeaf& leaf) {
    TriangleTree::Block block{};
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      block.face[i] = leaf.face[i];
      for (std::size_t k = 0; k < 9; ++k) {
        const std::uint32_t vertex = mesh_.faces[leaf.face[i]][k / 3];
        block.corners[k][i] = mesh_.vertices[vertex][static_cast<int>(k % 3)];
      }
    }
    tree_.blocks_.push_back(block);
    return TriangleTree::leaf_mark | static_cast<std::uint32_t>(tree_.blocks_.size() - 1);
  }

  const scene::Mesh& mesh_;
  TriangleTree& tree_;
  double pad_ = 0;
  std::size_t nodes_ = 0;
  std::size_t blocks_ = 0;
};

TriangleTree::TriangleTree(const scene::Mesh& mesh) { TriangleTreeBuilder(mesh, *this).run(); }

}  // namespace durer::tracer

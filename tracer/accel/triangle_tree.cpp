#include "tracer/accel/triangle_tree.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "functions/simd/inline.h"
#include "tracer/accel/box_tree.h"
#include "tracer/accel/sheared_ray.h"

namespace durer::tracer {
namespace {

using Float8 = float __attribute__((vector_size(32)));
using Byte8 = std::int8_t __attribute__((vector_size(8)));
using Float4 = float __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));
using Long4 = std::int64_t __attribute__((vector_size(32)));

DURER_INLINE Float8 load8(const float* p) {
  Float8 r;
  std::memcpy(&r, p, sizeof r);
  return r;
}
DURER_INLINE Double4 load4(const float* p) {
  Float4 r;
  std::memcpy(&r, p, sizeof r);
  return __builtin_convertvector(r, Double4);
}
DURER_INLINE Float8 greater_of(Float8 a, Float8 b) { return a > b ? a : b; }
DURER_INLINE Float8 less_of(Float8 a, Float8 b) { return a < b ? a : b; }

/// The ray as boxes see it: from where it enters the tree, unit direction, single precision.
struct BoxRay {
  float o[3];
  float inverse[3];
  std::size_t near_plane[3];  // which of Node::planes a ray meets first
  std::size_t far_plane[3];
  double start = 0;   // of this ray, on the given one
  double length = 1;  // of the given direction

  /// Depth on this ray, with room for its rounding.
  [[nodiscard]] DURER_INLINE float depth(double t) const {
    return static_cast<float>((t - start) * length * (1 + 1e-6));
  }
};

bool prepare(const TriangleTree& tree, const Ray& ray, double t_from, double t_to, BoxRay& out) {
  const double length = glm::length(ray.d);
  if (!(length > 0) || tree.bounds_.empty() ||
      !BoxTree::clip(BoxTree::grown(tree.bounds_), ray.o, 1.0 / ray.d, t_from, t_to)) {
    return false;
  }
  out.start = t_from;
  out.length = length;
  const dvec3 o = ray.at(t_from) - tree.center_;
  const dvec3 d = ray.d / length;
  for (int i = 0; i < 3; ++i) {
    constexpr double least = 1e-18;  // keeps 0 * infinity away
    const double component = std::abs(d[i]) < least ? std::copysign(least, d[i]) : d[i];
    const auto axis = static_cast<std::size_t>(i);
    out.o[i] = static_cast<float>(o[i]);
    out.inverse[i] = static_cast<float>(1 / component);
    out.near_plane[i] = component > 0 ? axis : axis + 3;
    out.far_plane[i] = component > 0 ? axis + 3 : axis;
  }
  return true;
}

struct Waiting {
  std::uint32_t child;
  float depth;
};

/// Children of a node whose boxes the ray meets before `limit`, the nearest on top of the stack.
DURER_INLINE std::size_t push_children(const TriangleTree::Node& node, const BoxRay& ray,
                                       float limit, Waiting* stack, std::size_t top) {
  const auto slab = [&](std::size_t plane, int axis) DURER_LAMBDA_INLINE {
    return (load8(node.planes[plane].data()) - ray.o[axis]) * ray.inverse[axis];
  };
  Float8 enter = slab(ray.near_plane[0], 0);
  enter = greater_of(enter, slab(ray.near_plane[1], 1));
  enter = greater_of(enter, slab(ray.near_plane[2], 2));
  enter = greater_of(enter, Float8{});
  Float8 exit = slab(ray.far_plane[0], 0);
  exit = less_of(exit, slab(ray.far_plane[1], 1));
  exit = less_of(exit, slab(ray.far_plane[2], 2));
  exit = less_of(exit, Float8{} + limit);
  // One byte per child, so that only those which are met are looked at.
  const Byte8 met = __builtin_convertvector(enter <= exit, Byte8);
  std::uint64_t left;
  std::memcpy(&left, &met, sizeof left);
  std::array<float, TriangleTree::width> depth;
  std::memcpy(depth.data(), &enter, sizeof depth);
  const std::size_t bottom = top;
  while (left != 0) {
    const auto bit = static_cast<std::size_t>(std::countr_zero(left));
    const std::size_t i = bit / 8;
    left &= ~(std::uint64_t{0xFF} << bit);
    const Waiting w{node.child[i], depth[i]};
    std::size_t at = top++;
    for (; at > bottom && stack[at - 1].depth < w.depth; --at) stack[at] = stack[at - 1];
    stack[at] = w;
  }
  return top;
}

/// Calls on_hit(lane) for every triangle of the block that the line passes through.
template <typename OnHit>
DURER_INLINE void pierce(const TriangleTree::Block& block, const ShearedRay& ray, OnHit&& on_hit) {
  struct Shadow {
    Double4 x, y;
  };
  const auto shadow = [&](int first) DURER_LAMBDA_INLINE {
    const auto component = [&](int axis) DURER_LAMBDA_INLINE {
      return load4(block.corners[static_cast<std::size_t>(first + axis)].data());
    };
    const Double4 z = component(ray.z) - ray.o.z;
    return Shadow{(component(ray.x) - ray.o.x) - ray.sx * z,
                  (component(ray.y) - ray.o.y) - ray.sy * z};
  };
  const Shadow a = shadow(0);
  const Shadow b = shadow(3);
  const Shadow c = shadow(6);
  const Double4 u = b.x * c.y - b.y * c.x;
  const Double4 v = c.x * a.y - c.y * a.x;
  const Double4 w = a.x * b.y - a.y * b.x;
  const Double4 zero{};
  const Long4 hit = (((u >= zero) & (v >= zero) & (w >= zero)) |
                     ((u <= zero) & (v <= zero) & (w <= zero))) &
                    ((u + v + w) != zero);
  if ((hit[0] | hit[1] | hit[2] | hit[3]) == 0) return;
  for (std::size_t i = 0; i < TriangleTree::block_size; ++i) {
    if (hit[i] != 0) on_hit(i);
  }
}

/// Depth of the triangle's plane; false for a ray in that plane.
bool plane_depth(const TriangleTree::Block& block, std::size_t lane, const Ray& ray, double& t) {
  const auto corner = [&](std::size_t i) {
    return dvec3(block.corners[i][lane], block.corners[i + 1][lane], block.corners[i + 2][lane]);
  };
  const dvec3 a = corner(0);
  const dvec3 n = glm::cross(corner(3) - a, corner(6) - a);
  const double slope = glm::dot(n, ray.d);
  if (slope * slope < epsilon * epsilon * glm::dot(n, n) * glm::dot(ray.d, ray.d)) return false;
  t = glm::dot(n, a - ray.o) / slope;
  return true;
}

/// Calls leaf(block) for the leaves that the ray may meet in t_from…t_to, the nearest first; it
/// returns the new t_to, or less than t_from to end the walk.
template <typename Leaf>
DURER_INLINE void walk(const TriangleTree& tree, const Ray& ray, double t_from, double t_to,
                       Leaf&& leaf) {
  BoxRay box_ray;
  if (!prepare(tree, ray, t_from, t_to, box_ray)) return;
  Waiting stack[TriangleTree::stack_size];
  std::size_t top = 0;
  float limit = box_ray.depth(t_to) + tree.pad_;
  stack[top++] = {tree.root_, 0};
  while (top > 0) {
    const Waiting next = stack[--top];
    if (next.depth > limit) continue;
    if ((next.child & TriangleTree::leaf_mark) == 0) {
      top = push_children(tree.nodes_[next.child], box_ray, limit, stack, top);
      continue;
    }
    t_to = leaf(tree.blocks_[next.child & ~TriangleTree::leaf_mark]);
    if (t_to < t_from) return;
    limit = box_ray.depth(t_to) + tree.pad_;
  }
}

DURER_INLINE std::optional<TriangleTree::Hit> nearest_in(const TriangleTree& tree, const Ray& ray,
                                                         double t_from, double t_to) {
  TriangleTree::Hit best{t_to, 0};
  bool found = false;
  const ShearedRay sheared(ray);
  walk(tree, ray, t_from, t_to, [&](const TriangleTree::Block& block) DURER_LAMBDA_INLINE {
    pierce(block, sheared, [&](std::size_t lane) {
      double t;
      if (!plane_depth(block, lane, ray, t) || !(t >= t_from)) return;
      const std::uint32_t face = block.face[lane];
      if (!(t < best.t || (found && t == best.t && face < best.face))) return;
      best = {t, face};
      found = true;
    });
    return best.t;
  });
  if (!found) return std::nullopt;
  return best;
}

DURER_INLINE std::optional<TriangleTree::Hit> any_in(const TriangleTree& tree, const Ray& ray,
                                                     double t_from, double t_to) {
  std::optional<TriangleTree::Hit> found;
  const ShearedRay sheared(ray);
  walk(tree, ray, t_from, t_to, [&](const TriangleTree::Block& block) DURER_LAMBDA_INLINE {
    pierce(block, sheared, [&](std::size_t lane) {
      double t;
      if (!plane_depth(block, lane, ray, t) || !(t >= t_from && t < t_to)) return;
      found = TriangleTree::Hit{t, block.face[lane]};
    });
    return found ? t_from - 1 : t_to;
  });
  return found;
}

DURER_INLINE void all_in(const TriangleTree& tree, const Ray& ray, double t_from, double t_to,
                         std::vector<TriangleTree::Hit>& out) {
  const ShearedRay sheared(ray);
  walk(tree, ray, t_from, t_to, [&](const TriangleTree::Block& block) DURER_LAMBDA_INLINE {
    pierce(block, sheared, [&](std::size_t lane) {
      double t;
      if (!plane_depth(block, lane, ray, t) || !(t >= t_from && t < t_to)) return;
      out.push_back({t, block.face[lane]});
    });
    return t_to;
  });
}

// The same code for processors with 256-bit vectors and for all others; the results are equal.
#if defined(__x86_64__)
#define DURER_WIDE __attribute__((target("avx2")))
DURER_WIDE std::optional<TriangleTree::Hit> nearest_wide(const TriangleTree& tree, const Ray& ray,
                                                         double t_from, double t_to) {
  return nearest_in(tree, ray, t_from, t_to);
}
DURER_WIDE std::optional<TriangleTree::Hit> any_wide(const TriangleTree& tree, const Ray& ray,
                                                     double t_from, double t_to) {
  return any_in(tree, ray, t_from, t_to);
}
DURER_WIDE void all_wide(const TriangleTree& tree, const Ray& ray, double t_from, double t_to,
                         std::vector<TriangleTree::Hit>& out) {
  all_in(tree, ray, t_from, t_to, out);
}
const bool has_wide = __builtin_cpu_supports("avx2") != 0;
#endif

}  // namespace

std::optional<TriangleTree::Hit> TriangleTree::nearest(const Ray& ray, double t_from,
                                                       double t_to) const {
#if defined(__x86_64__)
  if (has_wide) return nearest_wide(*this, ray, t_from, t_to);
#endif
  return nearest_in(*this, ray, t_from, t_to);
}

std::optional<TriangleTree::Hit> TriangleTree::any(const Ray& ray, double t_from,
                                                   double t_to) const {
#if defined(__x86_64__)
  if (has_wide) return any_wide(*this, ray, t_from, t_to);
#endif
  return any_in(*this, ray, t_from, t_to);
}

void TriangleTree::all(const Ray& ray, double t_from, double t_to, std::vector<Hit>& out) const {
#if defined(__x86_64__)
  if (has_wide) return all_wide(*this, ray, t_from, t_to, out);
#endif
  all_in(*this, ray, t_from, t_to, out);
}

std::size_t TriangleTree::bytes() const {
  return nodes_.size() * sizeof(Node) + blocks_.size() * sizeof(Block);
}

}  // namespace durer::tracer

// Walking through wide nodes: along a ray, the nearest box first, or to a point. Everything here
// becomes part of its caller, and so is compiled for the caller's instruction set.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "base/ray.h"
#include "tracer/accel/box_tree.h"
#include "tracer/accel/lanes.h"
#include "tracer/accel/wide_nodes.h"

namespace durer::tracer::wide {

/// The ray as boxes see it: from where it enters the whole, in single precision.
struct BoxRay {
  float o[3];
  float inverse[3];
  std::size_t near_plane[3];  // which of Node::planes a ray meets first
  std::size_t far_plane[3];
  double start = 0;  // of this ray, on the given one
  double scale = 1;  // from the given depth to this one's
  float slack = 0;   // for rounding

  [[nodiscard]] DURER_INLINE float depth(double t) const {
    return static_cast<float>((t - start) * scale) + slack;
  }
};

/// False if the ray misses everything.
DURER_INLINE bool prepare(const WideNodes& tree, const Ray& ray, double t_from, double t_to,
                          BoxRay& out) {
  const dvec3 inverse = 1.0 / ray.d;
  if (tree.reach.empty() || !BoxTree::clip(tree.reach, ray.o, inverse, t_from, t_to)) return false;
  const double most = std::max({std::abs(ray.d.x), std::abs(ray.d.y), std::abs(ray.d.z)});
  // Depths stay as they are, unless single precision could not hold them.
  const double unit = most > 1e-9 && most < 1e9 ? 1 : most;
  const double least = 1e-18 * most;  // keeps 0 * infinity away
  if (!(most > 0)) return false;
  out.start = t_from;
  out.scale = unit * (1 + 1e-6);
  out.slack = tree.pad * static_cast<float>(unit / most);
  const dvec3 o = ray.at(t_from) - tree.center;
  for (int i = 0; i < 3; ++i) {
    const double component = ray.d[i];
    const bool level = std::abs(component) < least;
    const double inv = level ? std::copysign(1 / least, component) : inverse[i];
    const auto axis = static_cast<std::size_t>(i);
    out.o[i] = static_cast<float>(o[i]);
    out.inverse[i] = static_cast<float>(unit * inv);
    out.near_plane[i] = inv > 0 ? axis : axis + 3;
    out.far_plane[i] = inv > 0 ? axis + 3 : axis;
  }
  return true;
}

/// A child and its depth as one number, by which nearer ones are smaller: depths are not negative,
/// and so are ordered as their bits are.
using Waiting = std::uint64_t;
DURER_INLINE Waiting waiting(std::uint32_t child, float depth) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(depth)} << 32 | child;
}
DURER_INLINE float depth_of(Waiting w) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(w >> 32));
}

/// Children of a node whose boxes the ray meets before `limit`, the nearest on top of the stack.
DURER_INLINE std::size_t push_children(const WideNodes::Node& node, const BoxRay& ray, float limit,
                                       Waiting* stack, std::size_t top) {
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
  std::array<float, WideNodes::width> depth;
  std::memcpy(depth.data(), &enter, sizeof depth);
  const std::size_t bottom = top;
  each_bit(bits_of_8(enter <= exit), [&](std::size_t i) DURER_LAMBDA_INLINE {
    const Waiting w = waiting(node.child[i], depth[i]);
    std::size_t at = top++;
    for (; at > bottom && stack[at - 1] < w; --at) stack[at] = stack[at - 1];
    stack[at] = w;
  });
  return top;
}

/// Calls leaf(number) for the leaves that the ray may meet in t_from…t_to, the nearest first; it
/// returns the new t_to, or less than t_from to end the walk.
template <typename Leaf>
DURER_INLINE void along(const WideNodes& tree, const Ray& ray, double t_from, double t_to,
                        Leaf&& leaf) {
  BoxRay box_ray;
  if (!prepare(tree, ray, t_from, t_to, box_ray)) return;
  Waiting stack[WideNodes::stack_size];
  std::size_t top = 0;
  float limit = box_ray.depth(t_to);
  stack[top++] = waiting(tree.root, 0);
  while (top > 0) {
    const Waiting next = stack[--top];
    if (depth_of(next) > limit) continue;
    const auto child = static_cast<std::uint32_t>(next);
    if ((child & WideNodes::leaf_mark) == 0) {
      top = push_children(tree.nodes[child], box_ray, limit, stack, top);
      continue;
    }
    t_to = leaf(child & ~WideNodes::leaf_mark);
    if (t_to < t_from) return;
    limit = box_ray.depth(t_to);
  }
}

/// Calls leaf(number) for the leaves whose boxes may hold `p`.
template <typename Leaf>
DURER_INLINE void at(const WideNodes& tree, dvec3 p, Leaf&& leaf) {
  if (!tree.reach.contains(p)) return;
  const dvec3 from_center = p - tree.center;
  const float x[3] = {static_cast<float>(from_center.x), static_cast<float>(from_center.y),
                      static_cast<float>(from_center.z)};
  std::uint32_t stack[WideNodes::stack_size];
  std::size_t top = 0;
  stack[top++] = tree.root;
  while (top > 0) {
    const std::uint32_t next = stack[--top];
    if ((next & WideNodes::leaf_mark) != 0) {
      leaf(next & ~WideNodes::leaf_mark);
      continue;
    }
    const WideNodes::Node& node = tree.nodes[next];
    Int8 holds = ~Int8{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      holds &= (load8(node.planes[axis].data()) <= x[axis]) &
               (load8(node.planes[axis + 3].data()) >= x[axis]);
    }
    each_bit(bits_of_8(holds),
             [&](std::size_t i) DURER_LAMBDA_INLINE { stack[top++] = node.child[i]; });
  }
}

}  // namespace durer::tracer::wide

#include "tracer/accel/triangle_tree.h"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "tracer/accel/sheared_ray.h"
#include "tracer/accel/wide_walk.h"

namespace durer::tracer {
namespace {

using Float4 = float __attribute__((vector_size(16)));
using wide::Double4;
using wide::Long4;

DURER_INLINE Double4 load4(const float* p) {
  Float4 r;
  std::memcpy(&r, p, sizeof r);
  return __builtin_convertvector(r, Double4);
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
  wide::each_bit(wide::bits_of_4(hit), on_hit);
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

DURER_INLINE std::optional<TriangleTree::Hit> nearest_in(const TriangleTree& tree, const Ray& ray,
                                                         double t_from, double t_to) {
  TriangleTree::Hit best{t_to, 0};
  bool found = false;
  const ShearedRay sheared(ray);
  wide::along(tree.nodes_, ray, t_from, t_to, [&](std::uint32_t leaf) DURER_LAMBDA_INLINE {
    const TriangleTree::Block& block = tree.blocks_[leaf];
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
  wide::along(tree.nodes_, ray, t_from, t_to, [&](std::uint32_t leaf) DURER_LAMBDA_INLINE {
    const TriangleTree::Block& block = tree.blocks_[leaf];
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
  wide::along(tree.nodes_, ray, t_from, t_to, [&](std::uint32_t leaf) DURER_LAMBDA_INLINE {
    const TriangleTree::Block& block = tree.blocks_[leaf];
    pierce(block, sheared, [&](std::size_t lane) {
      double t;
      if (!plane_depth(block, lane, ray, t) || !(t >= t_from && t < t_to)) return;
      out.push_back({t, block.face[lane]});
    });
    return t_to;
  });
}

#if DURER_HAS_WIDE
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
#endif

}  // namespace

std::optional<TriangleTree::Hit> TriangleTree::nearest(const Ray& ray, double t_from,
                                                       double t_to) const {
#if DURER_HAS_WIDE
  if (has_wide_vectors()) return nearest_wide(*this, ray, t_from, t_to);
#endif
  return nearest_in(*this, ray, t_from, t_to);
}

std::optional<TriangleTree::Hit> TriangleTree::any(const Ray& ray, double t_from,
                                                   double t_to) const {
#if DURER_HAS_WIDE
  if (has_wide_vectors()) return any_wide(*this, ray, t_from, t_to);
#endif
  return any_in(*this, ray, t_from, t_to);
}

void TriangleTree::all(const Ray& ray, double t_from, double t_to, std::vector<Hit>& out) const {
#if DURER_HAS_WIDE
  if (has_wide_vectors()) return all_wide(*this, ray, t_from, t_to, out);
#endif
  all_in(*this, ray, t_from, t_to, out);
}

std::size_t TriangleTree::bytes() const {
  return nodes_.nodes.size() * sizeof(WideNodes::Node) + blocks_.size() * sizeof(Block);
}

}  // namespace durer::tracer

// A hierarchy over the triangles of one mesh. Boxes are single precision and only choose; whether,
// where and which triangle a ray hits is decided in double precision, so that a mesh is seen as its
// formulas say, and no ray slips between two triangles that share an edge.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/bounds.h"
#include "base/ray.h"
#include "scene/mesh.h"

namespace durer::tracer {

class TriangleTree {
 public:
  explicit TriangleTree(const scene::Mesh& mesh);

  struct Hit {
    double t = 0;  // along the ray
    std::uint32_t face = 0;
  };
  /// The first hit in t_from <= t < t_to; of equal ones, that of the lower face.
  [[nodiscard]] std::optional<Hit> nearest(const Ray& ray, double t_from, double t_to) const;

  /// Some hit in t_from <= t < t_to.
  [[nodiscard]] std::optional<Hit> any(const Ray& ray, double t_from, double t_to) const;

  /// Appends all hits in t_from <= t < t_to, in any order. A line through an edge hits both faces.
  void all(const Ray& ray, double t_from, double t_to, std::vector<Hit>& out) const;

  /// Box of all faces that have an area.
  [[nodiscard]] const Bounds3& bounds() const { return bounds_; }
  [[nodiscard]] std::size_t bytes() const;

  static constexpr std::size_t width = 8;      // children of a node
  static constexpr std::size_t block_size = 4;  // triangles that are tested together

  /// Boxes of the children, relative to the centre of the whole. Absent children are empty boxes.
  struct alignas(32) Node {
    std::array<std::array<float, width>, 6> planes;  // lo x, y, z; hi x, y, z
    std::array<std::uint32_t, width> child;          // node, or leaf_mark | block
  };
  /// A leaf: corners of four triangles, a component of four at a time. Absent triangles are points.
  struct alignas(16) Block {
    std::array<std::array<float, block_size>, 9> corners;  // a.x a.y a.z b.x … c.z
    std::array<std::uint32_t, block_size> face;
  };
  static constexpr std::uint32_t leaf_mark = 1U << 31;
  /// A walk leaves at most seven children waiting on each level; the builder makes 32 levels, and
  /// a few more where triangles cannot be told apart.
  static constexpr std::size_t stack_size = 7 * 48;

  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
  Bounds3 bounds_;
  dvec3 center_{0.0};
  std::uint32_t root_ = 0;
  float pad_ = 0;  // by which boxes are larger than what is in them
};

}  // namespace durer::tracer

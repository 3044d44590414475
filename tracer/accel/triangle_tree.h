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
#include "tracer/accel/wide_nodes.h"

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
  [[nodiscard]] const Bounds3& bounds() const { return nodes_.bounds; }
  [[nodiscard]] std::size_t bytes() const;

  static constexpr std::size_t block_size = 4;  // triangles that are tested together

  /// A leaf: corners of four triangles, a component of four at a time. Absent triangles are points.
  struct alignas(16) Block {
    std::array<std::array<float, block_size>, 9> corners;  // a.x a.y a.z b.x … c.z
    std::array<std::uint32_t, block_size> face;
  };

  WideNodes nodes_;
  std::vector<Block> blocks_;
};

}  // namespace durer::tracer

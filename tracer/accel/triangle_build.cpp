// Leaves of a mesh's tree: four triangles each, those that have an area.
#include <glm/geometric.hpp>

#include "tracer/accel/triangle_tree.h"
#include "tracer/accel/wide_build.h"

namespace durer::tracer {
namespace {

// The oracle never hits triangles without area (objects §11.6).
WideItems triangles_with_area(const scene::Mesh& mesh, WideNodes& nodes) {
  WideItems triangles;
  triangles.reserve(mesh.faces.size());
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const dvec3 a = mesh.corner(f, 0);
    const dvec3 b = mesh.corner(f, 1);
    const dvec3 c = mesh.corner(f, 2);
    if (glm::cross(b - a, c - a) == dvec3(0.0)) continue;
    Bounds3 box;
    for (const dvec3 p : {a, b, c}) box.add(p);
    add_item(triangles, box, f, nodes);
  }
  return triangles;
}

TriangleTree::Block block_of(const scene::Mesh& mesh, std::span<const std::uint32_t> faces) {
  TriangleTree::Block block{};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    block.face[i] = faces[i];
    for (std::size_t k = 0; k < 9; ++k) {
      const std::uint32_t vertex = mesh.faces[faces[i]][k / 3];
      block.corners[k][i] = mesh.vertices[vertex][static_cast<int>(k % 3)];
    }
  }
  return block;
}

}  // namespace

TriangleTree::TriangleTree(const scene::Mesh& mesh) {
  build_wide_nodes(
      triangles_with_area(mesh, nodes_), block_size, nodes_,
      [&](std::size_t leaves) { blocks_.reserve(leaves); },
      [&](std::span<const std::uint32_t> faces) {
        blocks_.push_back(block_of(mesh, faces));
        return static_cast<std::uint32_t>(blocks_.size() - 1);
      });
}

}  // namespace durer::tracer

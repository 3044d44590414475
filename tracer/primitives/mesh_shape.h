// A mesh as a shape. Objects that show the same mesh share its triangles and their hierarchy.
#pragma once

#include <memory>

#include "base/transform.h"
#include "scene/mesh.h"
#include "tracer/accel/triangle_tree.h"
#include "tracer/primitives/typed_store.h"

namespace durer::tracer {

/// The triangles of a mesh and the hierarchy over them.
struct MeshData {
  std::shared_ptr<const scene::Mesh> mesh;
  TriangleTree tree;
  bool closed = false;  // it has an inside, and that ends at its faces
};
/// The data of a mesh; made once, however often it is asked for, as long as anybody holds it.
[[nodiscard]] std::shared_ptr<const MeshData> shared_mesh_data(
    const std::shared_ptr<const scene::Mesh>& mesh);

/// Its parts are faces. Normals and corners have the left-handed sense of the oracle.
class MeshShape {
 public:
  /// `to_world` leads from the space of the vertices to the world.
  MeshShape(std::shared_ptr<const MeshData> data, const Transform& to_world);

  [[nodiscard]] Bounds3 bounds() const { return data_->tree.bounds(); }
  /// A mesh with holes has an inside that reaches beyond it, as far as its inside_vector points.
  [[nodiscard]] Bounds3 inside_bounds() const;
  [[nodiscard]] bool contains(dvec3 p) const;
  [[nodiscard]] bool begins_inside(const Ray& ray) const;
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t face) const;
  void crossings(const Ray& ray, Crossings& out) const;
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const;
  [[nodiscard]] std::optional<Nearest> any(const Ray& ray, double t_from, double t_to) const;
  [[nodiscard]] dvec2 uv(dvec3 p, std::uint32_t face) const;
  [[nodiscard]] TextureBlend textures(dvec3 p, std::uint32_t face) const;

 private:
  [[nodiscard]] dvec3 weights(dvec3 p, std::uint32_t face) const;

  std::shared_ptr<const MeshData> data_;
  dvec3 inside_vector_;  // in the space of the vertices; 0: no inside
};

}  // namespace durer::tracer

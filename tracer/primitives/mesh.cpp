#include "tracer/primitives/describe.h"
#include "tracer/primitives/mesh_shape.h"

namespace durer::tracer {
namespace {

/// Four faces, all turned the same way.
std::shared_ptr<const scene::Mesh> tetrahedron(dvec3 inside_vector) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->vertices = {{0, 1, 0}, {-1, -0.5F, -0.6F}, {1, -0.5F, -0.6F}, {0.1F, -0.5F, 1.1F}};
  mesh->faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  mesh->inside_vector = inside_vector;
  return mesh;
}

// `mesh` and `mesh2` (objects §11.5, §11.6). Their operands are not numbers but a scene::Mesh, so
// this type is described by hand.
constexpr PrimitiveType mesh_type() {
  PrimitiveType type;
  type.name = "mesh";
  type.doc = "Triangles that share vertices, normals and textures.";
  type.make_stores = [] { return make_type_stores<MeshShape>(); };
  type.place = [](TypeStores&, std::span<const double>, const Transform&,
                  bool) -> std::optional<ShapeRef> { return std::nullopt; };
  type.place_whole = [](TypeStores& stores, const scene::Object& object, const Surroundings&,
                        const Transform& to_world, bool inverted) -> std::optional<ShapeRef> {
    const std::shared_ptr<const scene::Mesh>& mesh = object.extras->mesh;
    // Without an inside there is nothing that could be inverted (objects §8.5).
    return place_shape(stores, MeshShape(shared_mesh_data(mesh), to_world), to_world,
                       inverted && mesh->has_inside());
  };
  type.sample_objects = [] {
    std::vector<scene::Object> all(2);
    all[0].extras.edit().mesh = tetrahedron({0.1, 1, 0.2});
    all[1].extras.edit().mesh = tetrahedron(dvec3(0.0));
    return all;
  };
  type.samples = [] { return std::vector<std::vector<double>>{}; };
  return type;
}

}  // namespace

extern constinit const PrimitiveType mesh_primitive = mesh_type();

}  // namespace durer::tracer

#include "interpreter/mesh_files/mesh_file.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

namespace durer::interpreter {

MeshFile read_mesh_file(std::string_view bytes, std::string_view extension) {
  MeshFile file;
  if (extension == ".obj") {
    file = read_obj(bytes);
  } else if (extension == ".ply") {
    file = read_ply(bytes);
  } else if (extension == ".stl") {
    file = read_stl(bytes);
  } else {
    throw MeshFileError{
        fmt::format("meshes are read from `.obj`, `.ply` and `.stl` files, not from `{}`",
                    extension)};
  }
  if (file.mesh.faces.empty()) throw MeshFileError{"it holds no faces"};
  return file;
}

void smooth_normals(scene::Mesh& mesh) {
  mesh.face_normals.clear();
  mesh.face_normals.shrink_to_fit();
  mesh.normals.assign(mesh.vertices.size(), vec3(0.0F));
  mesh.normals_by_vertex = true;
  for (const scene::Triple& face : mesh.faces) {
    const dvec3 a(mesh.vertices[face[0]]);
    const vec3 n(
        glm::cross(dvec3(mesh.vertices[face[1]]) - a, dvec3(mesh.vertices[face[2]]) - a));
    for (const std::uint32_t v : face) mesh.normals[v] += n;
  }
  for (vec3& n : mesh.normals) {
    const double length = glm::length(dvec3(n));
    n = length > 0 ? vec3(dvec3(n) / length) : vec3(1, 0, 0);
  }
}

}  // namespace durer::interpreter

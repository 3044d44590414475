// Triangle meshes as plain data, shared by all objects that show them (objects §11.5, §11.6).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "base/bounds.h"
#include "base/vec.h"
#include "scene/texture.h"

namespace durer::scene {

/// Three indices, one for each corner of a face.
using Triple = std::array<std::uint32_t, 3>;

/// Triangles over shared vertices, in the space of the `mesh` statement. The oracle keeps vertices
/// and normals in single precision, and so do we.
struct Mesh {
  std::vector<vec3> vertices;
  std::vector<vec3> normals;  // unit
  std::vector<glm::vec2> uvs;
  std::vector<Triple> faces;  // into `vertices`; some may have no area, these are never hit
  /// Into `normals`, of the first faces; the others, and those that begin with `none`, are flat.
  std::vector<Triple> face_normals;
  /// Into `uvs`. Empty: <0,0> everywhere.
  std::vector<Triple> face_uvs;
  /// Normals (uvs) are as many as vertices, and faces use the indices of their vertices for them.
  bool normals_by_vertex = false;
  bool uvs_by_vertex = false;

  /// Textures of single faces, placed with the mesh. Of a face's three indices the second is `none`
  /// if the first holds all over the face; all are `none` if it looks like the mesh.
  std::vector<TextureId> textures;
  std::vector<Triple> face_textures;  // into `textures`, of the first faces

  /// World direction in which to count faces that lie around a point; 0: the mesh has no inside.
  dvec3 inside_vector{0.0};

  [[nodiscard]] bool has_inside() const { return inside_vector != dvec3(0.0); }

  /// Indices of a face's normals; the first is `none` if the face is flat.
  [[nodiscard]] Triple normals_of(std::size_t face) const {
    if (normals_by_vertex) return faces[face];
    return face < face_normals.size() ? face_normals[face] : Triple{none, none, none};
  }
  /// Indices of a face's uvs; the first is `none` where there are none.
  [[nodiscard]] Triple uvs_of(std::size_t face) const {
    if (uvs_by_vertex) return faces[face];
    return face < face_uvs.size() ? face_uvs[face] : Triple{none, none, none};
  }
  [[nodiscard]] Triple textures_of(std::size_t face) const {
    return face < face_textures.size() ? face_textures[face] : Triple{none, none, none};
  }
  [[nodiscard]] dvec3 corner(std::size_t face, std::size_t i) const {
    return dvec3(vertices[faces[face][i]]);
  }
  [[nodiscard]] Bounds3 bounds() const {
    Bounds3 b;
    for (const Triple& face : faces) {
      for (const std::uint32_t v : face) b.add(dvec3(vertices[v]));
    }
    return b;
  }
};

}  // namespace durer::scene

// Triangles from files of other programs: Wavefront OBJ, PLY and STL. Read here and not by a library
// because scans have ten million triangles, and a library's own copy of them would not fit beside
// ours; and because a file that nobody vouches for should meet little code.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.h"

namespace durer::interpreter {

struct MeshMaterial {
  std::string name;
  vec3 diffuse{0.8F};
  float opacity = 1;
};

/// Coordinates are those of the file.
struct MeshFile {
  scene::Mesh mesh;
  std::vector<MeshMaterial> materials;       // without a place in `mesh`, yet
  std::vector<std::uint32_t> face_material;  // of the first faces; none: no material
  std::vector<std::string> libraries;        // files of materials that an OBJ file names
};

/// What went wrong in a mesh file; the message says where in the file.
struct MeshFileError {
  std::string message;
};

/// Reads the file whose bytes these are; `extension` in lower case, with its dot. Throws
/// MeshFileError.
[[nodiscard]] MeshFile read_mesh_file(std::string_view bytes, std::string_view extension);
[[nodiscard]] MeshFile read_obj(std::string_view text);
[[nodiscard]] MeshFile read_ply(std::string_view bytes);
[[nodiscard]] MeshFile read_stl(std::string_view bytes);
/// The materials of an MTL file. Throws MeshFileError.
[[nodiscard]] std::vector<MeshMaterial> read_mtl(std::string_view text);

/// Normals at the vertices, as the mean of the faces around them, weighted by area; replaces those
/// that are there.
void smooth_normals(scene::Mesh& mesh);

}  // namespace durer::interpreter

// Collects the triangles of a `mesh` or `mesh2` while it is read.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scene/mesh.h"

namespace durer::interpreter {

class MeshBuilder {
 public:
  /// A triangle of a `mesh`, which brings everything with it.
  struct Triangle {
    bool smooth = false;
    bool has_uvs = false;
    std::array<vec3, 3> corners;
    std::array<vec3, 3> normals;
    std::array<glm::vec2, 3> uvs;
    scene::Triple textures{scene::none, scene::none, scene::none};  // of texture()
  };

  /// Drops triangles without area; merges vertices, normals and uvs that are equal.
  void add(const Triangle& triangle);
  /// The index of a texture among those of the mesh.
  std::uint32_t texture(scene::TextureId id);
  void set_textures(std::size_t face, const scene::Triple& textures);
  /// Of unit length and single precision; x where there is none (objects §11.5).
  vec3 unit(dvec3 normal);
  void set_inside(dvec3 direction);
  [[nodiscard]] scene::Mesh finish();

  scene::Mesh mesh;
  bool zero_normals = false;

 private:
  /// Finds equal elements of a growing list of vectors.
  template <typename V>
  class Merged {
   public:
    std::uint32_t add(std::vector<V>& list, const V& v);

   private:
    void grow(const std::vector<V>& list);
    std::vector<std::uint32_t> slots_;  // open addressing; none: empty
  };
  void set_row(std::vector<scene::Triple>& rows, std::size_t face, const scene::Triple& row);

  Merged<vec3> vertices_;
  Merged<vec3> normals_;
  Merged<glm::vec2> uvs_;
  std::unordered_map<scene::TextureId, std::uint32_t> textures_;
};

}  // namespace durer::interpreter

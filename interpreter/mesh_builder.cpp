#include "interpreter/mesh_builder.h"

#include <bit>
#include <glm/geometric.hpp>

namespace durer::interpreter {
namespace {

template <typename V>
std::size_t hash_of(const V& v) {
  std::uint64_t h = 0;
  for (int i = 0; i < v.length(); ++i) {
    // Adding 0 makes -0, which is equal to 0, hash like it.
    h = (h ^ std::bit_cast<std::uint32_t>(v[i] + 0.0F)) * 0x9E3779B97F4A7C15U;
    h ^= h >> 29;
  }
  return h;
}

double square(dvec3 v) { return glm::dot(v, v); }

bool same_normals(const std::array<vec3, 3>& n) {
  return square(dvec3(n[0]) - dvec3(n[1])) <= epsilon && square(dvec3(n[0]) - dvec3(n[2])) <= epsilon;
}

}  // namespace

template <typename V>
std::uint32_t MeshBuilder::Merged<V>::add(std::vector<V>& list, const V& v) {
  if (2 * list.size() >= slots_.size()) grow(list);
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = hash_of(v) & mask;
  while (slots_[at] != scene::none) {
    if (list[slots_[at]] == v) return slots_[at];
    at = (at + 1) & mask;
  }
  slots_[at] = static_cast<std::uint32_t>(list.size());
  list.push_back(v);
  return slots_[at];
}

template <typename V>
void MeshBuilder::Merged<V>::grow(const std::vector<V>& list) {
  slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), scene::none);
  const std::size_t mask = slots_.size() - 1;
  for (std::uint32_t i = 0; i < list.size(); ++i) {
    std::size_t at = hash_of(list[i]) & mask;
    while (slots_[at] != scene::none) at = (at + 1) & mask;
    slots_[at] = i;
  }
}

vec3 MeshBuilder::unit(dvec3 normal) {
  const double length = glm::length(normal);
  if (length == 0) {
    zero_normals = true;
    return {1, 0, 0};
  }
  return vec3(normal / length);
}

void MeshBuilder::set_inside(dvec3 direction) {
  const double length = glm::length(direction);
  mesh.inside_vector = length > 0 ? direction / length : dvec3(0.0);
}

std::uint32_t MeshBuilder::texture(scene::TextureId id) {
  const auto [at, is_new] =
      textures_.try_emplace(id, static_cast<std::uint32_t>(mesh.textures.size()));
  if (is_new) mesh.textures.push_back(id);
  return at->second;
}

/// Rows are made up to the face that needs one; those in between say nothing.
void MeshBuilder::set_row(std::vector<scene::Triple>& rows, std::size_t face,
                          const scene::Triple& row) {
  rows.resize(face, {scene::none, scene::none, scene::none});
  rows.push_back(row);
}

void MeshBuilder::set_textures(std::size_t face, const scene::Triple& textures) {
  set_row(mesh.face_textures, face, textures);
}

void MeshBuilder::add(const Triangle& triangle) {
  const dvec3 a(triangle.corners[0]);
  if (glm::cross(dvec3(triangle.corners[1]) - a, dvec3(triangle.corners[2]) - a) == dvec3(0.0)) {
    return;
  }
  const std::size_t face = mesh.faces.size();
  const auto merge = [](auto& merged, auto& list, const auto& three) {
    scene::Triple indices;
    for (std::size_t i = 0; i < 3; ++i) indices[i] = merged.add(list, three[i]);
    return indices;
  };
  mesh.faces.push_back(merge(vertices_, mesh.vertices, triangle.corners));
  if (triangle.smooth && !same_normals(triangle.normals)) {
    set_row(mesh.face_normals, face, merge(normals_, mesh.normals, triangle.normals));
  }
  if (triangle.has_uvs) set_row(mesh.face_uvs, face, merge(uvs_, mesh.uvs, triangle.uvs));
  if (triangle.textures[0] != scene::none) set_textures(face, triangle.textures);
}

scene::Mesh MeshBuilder::finish() {
  mesh.vertices.shrink_to_fit();
  mesh.normals.shrink_to_fit();
  mesh.faces.shrink_to_fit();
  mesh.face_normals.shrink_to_fit();
  mesh.face_uvs.shrink_to_fit();
  return std::move(mesh);
}

}  // namespace durer::interpreter

#include "tracer/primitives/mesh_shape.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <mutex>
#include <unordered_map>

namespace durer::tracer {
namespace {

constexpr double t_least = 1e-6;  // least depth of a triangle, in units of the mesh (objects §3)

/// Depths of a triangle count in units of the mesh, ours in units of the world.
struct DepthRange {
  double from;
  double to;
};
DepthRange within_reach(const Ray& ray, double t_from, double t_to) {
  const double length = glm::length(ray.d);
  return {std::max(t_from, t_least / length), std::min(t_to, t_far / length)};
}

/// Hits of one call; a buffer per thread, because shapes have none to hand down.
std::vector<TriangleTree::Hit>& hit_buffer() {
  thread_local std::vector<TriangleTree::Hit> hits;
  hits.clear();
  return hits;
}

}  // namespace

std::shared_ptr<const MeshData> shared_mesh_data(const std::shared_ptr<const scene::Mesh>& mesh) {
  static std::mutex mutex;
  static std::unordered_map<const scene::Mesh*, std::weak_ptr<const MeshData>> known;
  const std::lock_guard lock(mutex);
  std::weak_ptr<const MeshData>& entry = known[mesh.get()];
  // The data holds its mesh, so no other mesh can have taken the address while the data lives.
  if (auto data = entry.lock()) return data;
  auto data = std::make_shared<const MeshData>(MeshData{mesh, TriangleTree(*mesh)});
  entry = data;
  return data;
}

MeshShape::MeshShape(std::shared_ptr<const MeshData> data, const Transform& to_world)
    : data_(std::move(data)),
      inside_vector_(to_world.backward.vector(data_->mesh->inside_vector)) {}

std::optional<Nearest> MeshShape::nearest(const Ray& ray, double t_from, double t_to) const {
  const DepthRange range = within_reach(ray, t_from, t_to);
  const auto hit = data_->tree.nearest(ray, range.from, range.to);
  if (!hit) return std::nullopt;
  return Nearest{hit->t, hit->face};
}

// The parity of faces in one direction (objects §11.5).
bool MeshShape::contains(dvec3 p) const {
  if (!data_->mesh->has_inside() || !bounds().contains(p)) return false;
  const Ray ray{p, inside_vector_};
  const DepthRange range = within_reach(ray, 0, no_hit_depth);
  std::vector<TriangleTree::Hit>& hits = hit_buffer();
  data_->tree.all(ray, range.from, range.to, hits);
  return hits.size() % 2 != 0;
}

// A line goes in and out by turns. Where it meets an odd number of faces the mesh has holes, and
// what lies between two faces is asked point by point, as the oracle would.
void MeshShape::crossings(const Ray& ray, Crossings& out) const {
  std::vector<TriangleTree::Hit>& hits = hit_buffer();
  data_->tree.all(ray, -no_hit_depth, no_hit_depth, hits);
  const std::size_t first = out.size();
  const bool solid = data_->mesh->has_inside();
  for (const TriangleTree::Hit& hit : hits) {
    out.push_back({.t = hit.t, .part = hit.face, .side = Side::sheet});
  }
  if (!solid) return;
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
            [](const Crossing& a, const Crossing& b) {
              return a.t != b.t ? a.t < b.t : a.part < b.part;
            });
  const bool closed = (out.size() - first) % 2 == 0;
  bool inside = false;
  for (std::size_t i = first; i < out.size(); ++i) {
    const bool last = i + 1 == out.size();
    const bool then = last      ? false
                      : closed ? !inside
                               : contains(ray.at((out[i].t + out[i + 1].t) / 2));
    if (then != inside) out[i].side = then ? Side::enter : Side::exit;
    inside = then;
  }
}

/// Shares of the three corners at a point of the face; they add up to 1.
dvec3 MeshShape::weights(dvec3 p, std::uint32_t face) const {
  const scene::Mesh& mesh = *data_->mesh;
  const dvec3 a = mesh.corner(face, 0);
  const dvec3 ab = mesh.corner(face, 1) - a;
  const dvec3 ac = mesh.corner(face, 2) - a;
  const dvec3 n = glm::cross(ab, ac);
  const double area = glm::dot(n, n);
  const double b = glm::dot(glm::cross(p - a, ac), n) / area;
  const double c = glm::dot(glm::cross(ab, p - a), n) / area;
  return {1 - b - c, b, c};
}

dvec3 MeshShape::normal(dvec3 p, std::uint32_t face) const {
  const scene::Mesh& mesh = *data_->mesh;
  const scene::Triple n = mesh.normals_of(face);
  if (n[0] != scene::none) {
    const dvec3 w = weights(p, face);
    const dvec3 mixed = w.x * dvec3(mesh.normals[n[0]]) + w.y * dvec3(mesh.normals[n[1]]) +
                        w.z * dvec3(mesh.normals[n[2]]);
    if (mixed != dvec3(0.0)) return mixed;
  }
  const dvec3 a = mesh.corner(face, 0);
  return glm::cross(mesh.corner(face, 2) - a, mesh.corner(face, 1) - a);
}

dvec2 MeshShape::uv(dvec3 p, std::uint32_t face) const {
  const scene::Mesh& mesh = *data_->mesh;
  const scene::Triple i = mesh.uvs_of(face);
  if (i[0] == scene::none) return dvec2(0.0);
  const dvec3 w = weights(p, face);
  return w.x * dvec2(mesh.uvs[i[0]]) + w.y * dvec2(mesh.uvs[i[1]]) + w.z * dvec2(mesh.uvs[i[2]]);
}

TextureBlend MeshShape::textures(dvec3 p, std::uint32_t face) const {
  TextureBlend blend;
  const scene::Triple t = data_->mesh->textures_of(face);
  if (t[0] == scene::none) return blend;
  if (t[1] == scene::none) {
    blend.add(t[0], 1);
    return blend;
  }
  const dvec3 w = glm::max(weights(p, face), dvec3(0.0));
  const double sum = w.x + w.y + w.z;
  for (int i = 0; i < 3; ++i) {
    blend.add(t[static_cast<std::size_t>(i)], static_cast<float>(w[i] / sum));
  }
  return blend;
}

}  // namespace durer::tracer

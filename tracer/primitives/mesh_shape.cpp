#include "tracer/primitives/mesh_shape.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <mutex>
#include <unordered_map>
#include <vector>

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

bool close(dvec3 a, dvec3 b) { return glm::dot(a - b, a - b) <= epsilon; }

// Buffers of this thread, because shapes have none to hand down. Two are in use when a list of hits
// is being made while another is walked through.
thread_local std::vector<std::vector<TriangleTree::Hit>> buffers;

std::vector<TriangleTree::Hit> take_buffer() {
  if (buffers.empty()) return {};
  std::vector<TriangleTree::Hit> buffer = std::move(buffers.back());
  buffers.pop_back();
  buffer.clear();
  return buffer;
}
void give_back(std::vector<TriangleTree::Hit>&& buffer) { buffers.push_back(std::move(buffer)); }

/// True if every edge belongs to an even number of faces. Edges are told apart by a sum of hashes
/// in which pairs cancel out: a mesh with holes is taken for closed once in 2^64 cases.
bool is_closed(const scene::Mesh& mesh) {
  const auto hash = [](const vec3 v) {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
      h = (h ^ std::bit_cast<std::uint32_t>(v[i] + 0.0F)) * 0x9E3779B97F4A7C15U;
      h ^= h >> 29;
    }
    return h;
  };
  std::uint64_t sum = 0;
  for (const scene::Triple& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = hash(mesh.vertices[face[i]]);
      const std::uint64_t b = hash(mesh.vertices[face[(i + 1) % 3]]);
      const std::uint64_t edge = (std::min(a, b) * 0xD6E8FEB86659FD93U) ^ std::max(a, b);
      if (a != b) sum ^= (edge ^ (edge >> 32)) * 0xD6E8FEB86659FD93U;
    }
  }
  return sum == 0;
}

}  // namespace

std::shared_ptr<const MeshData> shared_mesh_data(const std::shared_ptr<const scene::Mesh>& mesh) {
  static std::mutex mutex;
  static std::unordered_map<const scene::Mesh*, std::weak_ptr<const MeshData>> known;
  const std::lock_guard lock(mutex);
  std::weak_ptr<const MeshData>& entry = known[mesh.get()];
  // The data holds its mesh, so no other mesh can have taken the address while the data lives.
  if (auto data = entry.lock()) return data;
  auto data = std::make_shared<const MeshData>(
      MeshData{mesh, TriangleTree(*mesh), mesh->has_inside() && is_closed(*mesh)});
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

std::optional<Nearest> MeshShape::any(const Ray& ray, double t_from, double t_to) const {
  const DepthRange range = within_reach(ray, t_from, t_to);
  const auto hit = data_->tree.any(ray, range.from, range.to);
  if (!hit) return std::nullopt;
  return Nearest{hit->t, hit->face};
}

Bounds3 MeshShape::inside_bounds() const {
  const bool endless = data_->mesh->has_inside() && !data_->closed;
  return endless ? Bounds3::everything() : bounds();
}

// The parity of faces in one direction (objects §11.5).
bool MeshShape::contains(dvec3 p) const {
  if (!data_->mesh->has_inside() || (data_->closed && !bounds().contains(p))) return false;
  const Ray ray{p, inside_vector_};
  const DepthRange range = within_reach(ray, 0, no_hit_depth);
  std::vector<TriangleTree::Hit> hits = take_buffer();
  data_->tree.all(ray, range.from, range.to, hits);
  const bool odd = hits.size() % 2 != 0;
  give_back(std::move(hits));
  return odd;
}

bool MeshShape::begins_inside(const Ray& ray) const {
  if (!data_->mesh->has_inside() || data_->closed) return false;
  std::vector<TriangleTree::Hit> hits = take_buffer();
  data_->tree.all(ray, -no_hit_depth, no_hit_depth, hits);
  double before = 0;
  for (const TriangleTree::Hit& hit : hits) before = std::min(before, hit.t - 1);
  give_back(std::move(hits));
  return contains(ray.at(before));
}

// A line goes into a closed mesh and out of it by turns. Where a mesh has holes, what lies between
// two faces is asked point by point, as the oracle would.
void MeshShape::crossings(const Ray& ray, Crossings& out) const {
  std::vector<TriangleTree::Hit> hits = take_buffer();
  data_->tree.all(ray, -no_hit_depth, no_hit_depth, hits);
  const std::size_t first = out.size();
  for (const TriangleTree::Hit& hit : hits) {
    out.push_back({.t = hit.t, .part = hit.face, .side = Side::sheet});
  }
  give_back(std::move(hits));
  if (!data_->mesh->has_inside() || out.size() == first) return;
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
            [](const Crossing& a, const Crossing& b) {
              return a.t != b.t ? a.t < b.t : a.part < b.part;
            });
  const bool turns = data_->closed && (out.size() - first) % 2 == 0;
  bool inside = !turns && contains(ray.at(out[first].t - 1));
  for (std::size_t i = first; i < out.size(); ++i) {
    const double end = i + 1 < out.size() ? out[i + 1].t : out[i].t + 2;
    const bool then = turns ? !inside : contains(ray.at((out[i].t + end) / 2));
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
    const dvec3 na(mesh.normals[n[0]]);
    const dvec3 nb(mesh.normals[n[1]]);
    const dvec3 nc(mesh.normals[n[2]]);
    // A face whose normals are all the same is flat, and its normal is its own (objects §11.5).
    if (!close(na, nb) || !close(na, nc)) {
      const dvec3 w = weights(p, face);
      const dvec3 mixed = w.x * na + w.y * nb + w.z * nc;
      if (mixed != dvec3(0.0)) return mixed;
    }
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

// Rays start on the faces of meshes, along their normals (shading §2.5). What is odd here is the
// oracle's: image rows 0 and 1 show the same faces.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "tracer/cameras/camera.h"

namespace durer::tracer::cameras {
namespace {

using scene::Mesh;

/// A point of a face, by the weights of its corners.
struct Place {
  const Mesh* mesh = nullptr;
  const Transform* to_world = nullptr;
  std::size_t face = 0;
  dvec3 weights{1.0 / 3};
};

std::optional<Place> face_of(const scene::MeshCamera& m, std::size_t mesh, std::size_t face) {
  if (face >= m.meshes[mesh]->faces.size()) return std::nullopt;
  return Place{m.meshes[mesh].get(), &m.transforms[mesh].get(), face};
}

/// Face `face` of all meshes one after the other.
std::optional<Place> face_of_all(const scene::MeshCamera& m, std::size_t face) {
  for (std::size_t i = 0; i < m.meshes.size(); ++i) {
    const std::size_t count = m.meshes[i]->faces.size();
    if (face < count) return face_of(m, i, face);
    face -= count;
  }
  return std::nullopt;
}

/// The first face whose part of the uv plane holds a point.
std::optional<Place> face_at(const scene::MeshCamera& m, dvec2 uv) {
  const Mesh& mesh = *m.meshes.front();
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const scene::Triple ids = mesh.uvs_of(f);
    if (ids[0] == scene::none) continue;
    const dvec2 a(mesh.uvs[ids[0]]);
    const dvec2 b = dvec2(mesh.uvs[ids[1]]) - a;
    const dvec2 c = dvec2(mesh.uvs[ids[2]]) - a;
    const dvec2 p = uv - a;
    const double area = b.x * c.y - b.y * c.x;
    if (area == 0) continue;
    const double v = (p.x * c.y - p.y * c.x) / area;
    const double w = (b.x * p.y - b.y * p.x) / area;
    if (v < 0 || w < 0 || v + w > 1) continue;
    return Place{&mesh, &m.transforms.front().get(), f, {1 - v - w, v, w}};
  }
  return std::nullopt;
}

std::optional<Place> place_of(const scene::MeshCamera& m, const PictureSpot& at) {
  if (m.distribution == 3) {
    const double x = std::min(at.x + 0.5, at.width - 1.0);
    const double y = std::clamp(at.y - 0.5, 0.0, at.height - 1.0);
    return face_at(m, {(x - 0.5) / at.width, 1 - (y + 0.5) / at.height});
  }
  const auto x = static_cast<std::size_t>(std::clamp(at.x + 0.5, 0.0, at.width - 1.0));
  const auto y = static_cast<std::size_t>(std::max(at.y - 0.5, 0.0));
  const auto width = static_cast<std::size_t>(at.width);
  const auto turn = static_cast<std::size_t>(at.turn);
  if (m.distribution == 0) return face_of(m, turn, y * width + x);
  if (m.distribution == 1) {
    // Further rays of a pixel look beyond the last face, and see nothing.
    return turn > 0 ? std::nullopt : face_of_all(m, y * width + x);
  }
  const std::size_t strip = width / m.meshes.size();
  const std::size_t mesh = strip == 0 ? 0 : x / strip;
  if (mesh >= m.meshes.size()) return std::nullopt;
  return face_of(m, mesh, y * strip + x);
}

dvec3 normal_at(const Place& p, bool smooth) {
  const scene::Triple ids = p.mesh->normals_of(p.face);
  if (smooth && ids[0] != scene::none) {
    dvec3 n(0.0);
    for (int i = 0; i < 3; ++i) {
      n += p.weights[i] * dvec3(p.mesh->normals[ids[static_cast<std::size_t>(i)]]);
    }
    return glm::normalize(n);
  }
  const dvec3 a = p.mesh->corner(p.face, 0);
  return glm::normalize(glm::cross(p.mesh->corner(p.face, 2) - a, p.mesh->corner(p.face, 1) - a));
}

bool ray(const Camera& c, const PictureSpot& at, functions::Workspace&, CameraRay& out) {
  const scene::MeshCamera& m = *c.in->mesh;
  const auto place = place_of(m, at);
  if (!place) return false;
  dvec3 o(0.0);
  for (int i = 0; i < 3; ++i) {
    o += place->weights[i] * place->mesh->corner(place->face, static_cast<std::size_t>(i));
  }
  const dvec3 n = normal_at(*place, m.smooth);
  o += c.in->location.z * n;
  const dvec3 d = c.in->direction.z < -epsilon ? -n : n;
  out = {{place->to_world->point(o), place->to_world->vector(d)}, {at.u, at.v}};
  return true;
}

}  // namespace

extern constinit const CameraType mesh_camera_camera{ray, false};

}  // namespace durer::tracer::cameras

#include <array>
#include <cmath>
#include <memory>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/mesh_shape.h"
#include "tracer/primitives/shared_data.h"

namespace durer::tracer {
namespace {

/// Operands as the interpreter lays them out: uv of four corners, then 16 points, row by row.
enum : std::size_t {
  u_steps_at,
  v_steps_at,
  flatness_at,
  uvs_at,
  points_at = uvs_at + 8,
  all_of_it = points_at + 48
};

using Net = std::array<std::array<dvec3, 4>, 4>;  // [i][j]: u along i, v along j

dvec3 bezier(const std::array<dvec3, 4>& p, double w) {
  const double x = 1 - w;
  return x * x * x * p[0] + 3 * x * x * w * p[1] + 3 * x * w * w * p[2] + w * w * w * p[3];
}
dvec3 bezier_slope(const std::array<dvec3, 4>& p, double w) {
  const double x = 1 - w;
  return 3.0 * (x * x * (p[1] - p[0]) + 2 * x * w * (p[2] - p[1]) + w * w * (p[3] - p[2]));
}

/// The two halves of a curve.
void halve(const std::array<dvec3, 4>& p, std::array<dvec3, 4>& left, std::array<dvec3, 4>& right) {
  const dvec3 a = 0.5 * (p[0] + p[1]);
  const dvec3 b = 0.5 * (p[1] + p[2]);
  const dvec3 c = 0.5 * (p[2] + p[3]);
  const dvec3 d = 0.5 * (a + b);
  const dvec3 e = 0.5 * (b + c);
  const dvec3 f = 0.5 * (d + e);
  left = {p[0], a, d, f};
  right = {f, e, c, p[3]};
}
void halve_v(const Net& p, Net& low, Net& high) {
  for (std::size_t i = 0; i < 4; ++i) halve(p[i], low[i], high[i]);
}
void halve_u(const Net& p, Net& low, Net& high) {
  for (std::size_t j = 0; j < 4; ++j) {
    std::array<dvec3, 4> a{};
    std::array<dvec3, 4> b{};
    halve({p[0][j], p[1][j], p[2][j], p[3][j]}, a, b);
    for (std::size_t i = 0; i < 4; ++i) low[i][j] = a[i], high[i][j] = b[i];
  }
}

/// A curved patch (objects §11.7) as the triangles that the oracle makes of it, with the true
/// normals at their corners.
class Tessellation {
 public:
  Tessellation(std::span<const double> args, scene::Mesh& out)
      : u_steps_(args[u_steps_at]),
        v_steps_(args[v_steps_at]),
        flatness_(args[flatness_at]),
        out_(out) {
    for (std::size_t k = 0; k < 4; ++k) uvs_[k] = {args[uvs_at + 2 * k], args[uvs_at + 2 * k + 1]};
    for (std::size_t k = 0; k < 16; ++k) {
      const double* p = &args[points_at + 3 * k];
      whole_[k / 4][k % 4] = {p[0], p[1], p[2]};
    }
    divide(whole_, 0, {0, 1}, {0, 1});
  }

 private:
  void divide(const Net& p, int depth, dvec2 u, dvec2 v) {
    const bool no_u = depth >= u_steps_;
    const bool no_v = depth >= v_steps_;
    if ((no_u && no_v) || is_flat(p)) {
      add_leaf(p, u, v);
      return;
    }
    const double mid_u = 0.5 * (u.x + u.y);
    const double mid_v = 0.5 * (v.x + v.y);
    Net low{};
    Net high{};
    if (no_u) {
      halve_v(p, low, high);
      divide(low, depth + 1, u, {v.x, mid_v});
      divide(high, depth + 1, u, {mid_v, v.y});
      return;
    }
    halve_u(p, low, high);
    const auto each = [&](const Net& half, dvec2 part) {
      if (no_v) return divide(half, depth + 1, part, v);
      Net left{};
      Net right{};
      halve_v(half, left, right);
      divide(left, depth + 1, part, {v.x, mid_v});
      divide(right, depth + 1, part, {mid_v, v.y});
    };
    each(low, {u.x, mid_u});
    each(high, {mid_u, u.y});
  }

  [[nodiscard]] bool is_flat(const Net& p) const {
    const auto apart = [](dvec3 a, dvec3 b) { return glm::distance(a, b) > epsilon; };
    const dvec3 a = p[0][0];
    const dvec3 b = apart(a, p[0][3]) ? p[0][3] : p[3][3];
    const dvec3 c = apart(a, p[3][0]) && apart(b, p[3][0]) ? p[3][0] : p[3][3];
    const dvec3 cross = glm::cross(b - a, c - a);
    const double length = glm::length(cross);
    if (!(length > epsilon)) return false;
    double most = 0;
    for (const auto& row : p) {
      for (const dvec3 q : row) most = std::max(most, std::abs(glm::dot(q - a, cross)) / length);
    }
    return most < flatness_;
  }

  void add_leaf(const Net& p, dvec2 u, dvec2 v) {
    const auto first = static_cast<std::uint32_t>(out_.vertices.size());
    add_corner(p[0][0], u.x, v.x);
    add_corner(p[0][3], u.x, v.y);
    add_corner(p[3][3], u.y, v.y);
    add_corner(p[3][0], u.y, v.x);
    out_.faces.push_back({first, first + 1, first + 2});
    out_.faces.push_back({first, first + 2, first + 3});
  }
  void add_corner(dvec3 p, double u, double v) {
    out_.vertices.emplace_back(p);
    std::array<dvec3, 4> along_v{};
    std::array<dvec3, 4> along_u{};
    for (std::size_t i = 0; i < 4; ++i) {
      along_u[i] = bezier(whole_[i], v);
      along_v[i] = bezier({whole_[0][i], whole_[1][i], whole_[2][i], whole_[3][i]}, u);
    }
    const dvec3 n = glm::cross(bezier_slope(along_u, u), bezier_slope(along_v, v));
    const double length = glm::length(n);
    out_.normals.emplace_back(length > epsilon ? n / length : dvec3(1, 0, 0));
    const dvec2 low = uvs_[0] + (uvs_[1] - uvs_[0]) * v;
    const dvec2 high = uvs_[3] + (uvs_[2] - uvs_[3]) * v;
    out_.uvs.emplace_back(low + (high - low) * u);
  }

  double u_steps_;
  double v_steps_;
  double flatness_;
  std::array<dvec2, 4> uvs_;
  Net whole_{};
  scene::Mesh& out_;
};

std::optional<ShapeRef> place_patch(TypeStores& stores, std::span<const double> args,
                                    const Transform& to_world, bool /*inverted*/) {
  auto data = shared_data<MeshData>(args, [](std::span<const double> all) {
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->normals_by_vertex = mesh->uvs_by_vertex = true;
    Tessellation(all, *mesh);
    return shared_mesh_data(mesh);
  });
  return place_shape(stores, MeshShape(std::move(data), to_world), to_world, false);
}

constexpr std::array<scene::Param, 3> patch_params = {
    scene::Param{"u_steps", scene::ArgKind::number, "how often it is halved across its rows"},
    scene::Param{"v_steps", scene::ArgKind::number, "how often it is halved along its rows"},
    scene::Param{"flatness", scene::ArgKind::number, "pieces flatter than this are not halved"}};

constexpr double most_steps = 22;  // of both: four million pieces

constexpr PrimitiveType describe_bicubic_patch() {
  PrimitiveType type;
  type.name = "bicubic_patch";
  type.doc = "A curved surface over 16 points.";
  type.params = patch_params;
  type.open_ended = true;
  type.is_patch = true;
  type.sides_by_order = true;
  type.validate = [](std::span<const double> args) -> std::optional<std::string> {
    if (args.size() != all_of_it) return "a patch takes 16 points";
    if (args[u_steps_at] + args[v_steps_at] > most_steps)
      return "u_steps and v_steps are 22 at most, together";
    return std::nullopt;
  };
  type.make_stores = [] { return make_type_stores<MeshShape>(); };
  type.place = place_patch;
  type.samples = [] {
    std::vector<double> flat{3, 2, 0, 0, 0, 1, 0, 1, 1, 0, 1};
    std::vector<double> dome{2, 4, 0.01, 0, 0, 1, 0, 1, 1, 0, 1};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const bool inner = i > 0 && i < 3 && j > 0 && j < 3;
        flat.insert(flat.end(), {1.0 * j, 1.0 * i, 0.2 * i * j});
        dome.insert(dome.end(), {1.0 * j, 1.0 * i, inner ? 1.5 : 0.0});
      }
    }
    return std::vector<std::vector<double>>{flat, dome};
  };
  return type;
}

}  // namespace

extern constinit const PrimitiveType bicubic_patch_primitive = describe_bicubic_patch();

}  // namespace durer::tracer

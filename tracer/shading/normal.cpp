#include "tracer/shading/normal.h"

#include <glm/geometric.hpp>
#include <optional>

#include "tracer/patterns/map_search.h"

namespace durer::tracer {

NormalFrame::NormalFrame(const scene::Pattern& pattern, const Transform& to_world, bool keep_scale)
    : keep_scale_(keep_scale) {
  // Only transformations move normals; the other warps are passed over.
  Transform placed;
  for (const scene::Warp& warp : pattern.warps) {
    if (warp.type == scene::none) placed = placed.then(warp.transform);
  }
  placed = placed.then(pattern.transform).then(to_world);
  moved_ = !placed.is_identity();
  into_ = placed.forward;
  back_ = placed.backward;
}

NormalId NormalStore::add(const scene::Normal& normal, const Transform& to_world) {
  const auto id = static_cast<NormalId>(nodes_.size());
  nodes_.emplace_back();
  std::vector<Entry> entries;
  for (const scene::NormalEntry& e : normal.entries) {
    entries.push_back({e.key, add(normal.children[e.normal], {})});
  }
  Node node;
  node.by_uv = normal.uv_mapping;
  const Transform placed = node.by_uv ? Transform{} : to_world;
  node.pattern = patterns_.compile(*normal.pattern, placed);
  node.frame = NormalFrame(*normal.pattern, placed, normal.no_bump_scale);
  node.amount = normal.amount;
  node.accuracy = normal.accuracy;
  node.first_entry = static_cast<std::uint32_t>(entries_.size());
  entries_.insert(entries_.end(), entries.begin(), entries.end());
  node.end_entry = static_cast<std::uint32_t>(entries_.size());
  node.first_slope = static_cast<std::uint32_t>(slopes_.size());
  slopes_.insert(slopes_.end(), normal.slopes.begin(), normal.slopes.end());
  node.end_slope = static_cast<std::uint32_t>(slopes_.size());
  nodes_[id] = node;
  return id;
}

dvec3 NormalStore::at(NormalId id, const dvec3& p, const dvec3& n, const SurfaceView* view) const {
  const Node& node = nodes_[id];
  if (node.pattern.type == nullptr) return n;
  const dvec3& place = node.by_uv && view != nullptr ? view->uv : p;
  const dvec3 inner = node.frame.enter(n);
  const dvec3 bent =
      node.frame.leave(perturbed(node, patterns_.warp(node.pattern, place), inner, view));
  return node.by_uv ? glm::normalize(bent) : bent;
}

void NormalStore::at(NormalId id, std::span<dvec3> points, dvec3* normals) const {
  const Node& node = nodes_[id];
  if (node.pattern.type == nullptr) return;
  for (std::size_t i = 0; i < points.size(); ++i) normals[i] = node.frame.enter(normals[i]);
  patterns_.warp(node.pattern, points);
  if (node.first_entry == node.end_entry && node.pattern.type->perturb != nullptr) {
    node.pattern.type->perturb_all(node.pattern.state, points, normals, node.amount);
  } else {
    for (std::size_t i = 0; i < points.size(); ++i) {
      normals[i] = perturbed(node, points[i], normals[i], nullptr);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) normals[i] = node.frame.leave(normals[i]);
}

dvec3 NormalStore::perturbed(const Node& node, const dvec3& p, const dvec3& n,
                             const SurfaceView* view) const {
  const PatternType& type = *node.pattern.type;
  if (node.first_entry != node.end_entry) {
    return type.averages ? average(node, p, n, view) : blend(node, p, n, view);
  }
  if (type.perturb != nullptr) return type.perturb(node.pattern.state, p, n, node.amount);
  return slide(node, p, n, view);
}

namespace {

/// A surface as one entry of a map after another sees it: each bends the same normal, but patterns
/// that ask for the normal get the one that the entry before has left, as the oracle's do.
class SeenInTurn {
 public:
  explicit SeenInTurn(const SurfaceView* view) {
    if (view != nullptr) seen_ = *view;
  }
  [[nodiscard]] const SurfaceView* view() const { return seen_ ? &*seen_ : nullptr; }
  dvec3 left(const dvec3& n) {
    if (seen_) seen_->n = n;
    return n;
  }

 private:
  std::optional<SurfaceView> seen_;
};

}  // namespace

dvec3 NormalStore::average(const Node& node, const dvec3& p, const dvec3& n,
                           const SurfaceView* view) const {
  SeenInTurn seen(view);
  dvec3 sum(0.0);
  double total = 0;
  for (std::uint32_t i = node.first_entry; i < node.end_entry; ++i) {
    const dvec3 bent = seen.left(at(entries_[i].child, p, n, seen.view()));
    sum += static_cast<double>(entries_[i].key) * bent;
    total += entries_[i].key;
  }
  return sum / total;
}

dvec3 NormalStore::blend(const Node& node, const dvec3& p, const dvec3& n,
                         const SurfaceView* view) const {
  const std::span entries(&entries_[node.first_entry], node.end_entry - node.first_entry);
  const auto found = find_neighbours(entries, PatternStore::value(node.pattern, p, view));
  if (found.single()) return at(found.lower->child, p, n, view);
  SeenInTurn seen(view);
  const dvec3 upper = seen.left(at(found.upper->child, p, n, seen.view()));
  return (1 - found.t) * at(found.lower->child, p, n, seen.view()) + found.t * upper;
}

// The slope of the pattern, from its values at the corners of a small tetrahedron.
dvec3 NormalStore::slide(const Node& node, const dvec3& p, const dvec3& n,
                         const SurfaceView* view) const {
  static constexpr std::array corners{
      dvec3(0.942809041, -0.333333333, 0),
      dvec3(-0.471404521, -0.333333333, 0.816496581),
      dvec3(-0.471404521, -0.333333333, -0.816496581),
      dvec3(0, 1, 0),
  };
  const double size = node.accuracy;
  const double amount = node.amount * -5.0 * (0.02 / size);
  std::array<dvec3, corners.size()> around;
  for (std::size_t i = 0; i < corners.size(); ++i) around[i] = p + size * corners[i];
  std::array<double, corners.size()> height;
  heights(node, around, view, height.data());
  dvec3 slid = n;
  for (std::size_t i = 0; i < corners.size(); ++i) slid += amount * height[i] * corners[i];
  return slid;
}

void NormalStore::heights(const Node& node, std::span<const dvec3> points, const SurfaceView* view,
                          double* out) const {
  if (!node.pattern.type->asks_view) {
    PatternStore::values(node.pattern, points, out);
  } else {
    double* value = out;
    for (const dvec3& p : points) *value++ = PatternStore::value(node.pattern, p, view);
  }
  if (node.first_slope == node.end_slope) return;
  for (std::size_t i = 0; i < points.size(); ++i) out[i] = height(node, out[i]);
}

// The slope map (textures §13.3).
double NormalStore::height(const Node& node, double value) const {
  const std::span slopes(&slopes_[node.first_slope], node.end_slope - node.first_slope);
  const auto found = find_neighbours(slopes, value);
  const double h0 = found.lower->height;
  if (found.single()) return h0;
  const double s0 = found.lower->slope;
  const double s1 = found.upper->slope;
  const double d = h0 - found.upper->height;
  const double t = found.t;
  return t * t * t * (s0 + s1 + 2 * d) - t * t * (2 * s0 + s1 + 3 * d) + t * s0 + h0;
}

}  // namespace durer::tracer

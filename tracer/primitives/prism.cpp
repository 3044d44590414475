#include <cmath>
#include <memory>
#include <utility>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/profile.h"
#include "tracer/primitives/shared_data.h"
#include "tracer/primitives/swept.h"

namespace durer::tracer {
namespace {

struct PrismOutline : Outline {
  using Outline::Outline;
};

// An outline in the plane of x and z, swept along y: at the same size, or as large as y tells, with
// its apex at the origin (objects §10.8). Holes by the even-odd rule.
struct Prism {
  std::shared_ptr<const PrismOutline> outline;  // x and z
  double low = 0;
  double high = 0;
  bool conic = false;
  bool open = false;

  static constexpr double far = t_far;

  [[nodiscard]] Bounds3 bounds() const {
    Bounds3 b;
    for (const double y : {low, high}) {
      const double f = conic ? y : 1;
      b.add({f * outline->lo().x, y, f * outline->lo().y});
      b.add({f * outline->hi().x, y, f * outline->hi().y});
    }
    if (conic && low < 0 && high > 0) b.add(dvec3(0.0));
    return b;
  }
  /// Where a point of the shape lies in the plane of the outline.
  [[nodiscard]] dvec2 onto_plane(dvec3 p) const {
    return conic ? dvec2(p.x / p.y, p.z / p.y) : dvec2(p.x, p.z);
  }
  [[nodiscard]] bool contains(dvec3 p) const {
    if (!(p.y >= low && p.y < high) || (conic && std::abs(p.y) <= epsilon)) return false;
    return outline->contains(onto_plane(p));
  }
  // Outward or inward, as the outline turns; both ends look up, as the oracle has it.
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const {
    if (part < swept::first_side) return {0, 1, 0};
    const Arc& arc = outline->arc(part - swept::first_side);
    const dvec2 slope = arc.slope_near(onto_plane(p));
    if (!conic) return {slope.y, 0, -slope.x};
    return {slope.y, -(p.x * slope.y - p.z * slope.x) / p.y, -slope.x};
  }

  template <typename F>
  void each_crossing(const Ray& ray, F&& f) const {
    const auto piece = swept::between(ray.o.y, ray.d.y, low, high);
    if (!piece) return;
    auto& sides = swept::empty_sides();
    const bool inside = conic ? add_slanted(ray, sides) : add_upright(ray, sides);
    swept::each_crossing(sides, inside, *piece, !open, f);
  }
  void crossings(const Ray& ray, Crossings& out) const {
    each_crossing(ray, [&](const Crossing& c) { out.push_back(c); });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    if (!conic) {
      const auto piece = swept::between(ray.o.y, ray.d.y, low, high);
      if (!piece) return std::nullopt;
      const dvec2 d(ray.d.x, ray.d.z);
      const bool upright = glm::dot(d, d) <= 1e-20 * ray.d.y * ray.d.y;
      return swept::nearest(*outline, {ray.o.x, ray.o.z}, d, upright, *piece, !open, t_from, t_to);
    }
    std::optional<Nearest> best;
    each_crossing(ray, [&](const Crossing& c) {
      if (!best && c.visible && c.t >= t_from && c.t < t_to) best = Nearest{c.t, c.part};
    });
    return best;
  }

 private:
  /// Crossings with the endless sides; returns whether the line begins inside of them.
  bool add_upright(const Ray& ray, std::vector<swept::SideHit>& sides) const {
    const dvec2 o(ray.o.x, ray.o.z);
    const dvec2 d(ray.d.x, ray.d.z);
    const double d2 = glm::dot(d, d);
    if (d2 <= 1e-20 * ray.d.y * ray.d.y) return outline->contains(o);
    const dvec3 line(d.y, -d.x, o.y * d.x - o.x * d.y);
    outline->each_crossing(line, [&](std::uint32_t i, double w) {
      sides.push_back({glm::dot(outline->arc(i).at(w) - o, d) / d2, i + swept::first_side});
    });
    return false;
  }

  // Seen from the apex the line is a line in the plane y = 1, which it leaves to both sides, and
  // comes back to from the other, where it crosses y = 0.
  bool add_slanted(const Ray& ray, std::vector<swept::SideHit>& sides) const {
    const dvec3 line(ray.o.z * ray.d.y - ray.o.y * ray.d.z, ray.o.y * ray.d.x - ray.o.x * ray.d.y,
                     ray.o.x * ray.d.z - ray.o.z * ray.d.x);
    if (line == dvec3(0.0)) {
      return ray.d.y != 0 && outline->contains({ray.d.x / ray.d.y, ray.d.z / ray.d.y});
    }
    bool inside = false;
    const double t_apex = ray.d.y != 0 ? -ray.o.y / ray.d.y : 0;
    outline->each_crossing(line, [&](std::uint32_t i, double w) {
      const dvec2 q = outline->arc(i).at(w);
      const dvec2 down(ray.d.x - q.x * ray.d.y, ray.d.z - q.y * ray.d.y);
      const int axis = std::abs(down.x) >= std::abs(down.y) ? 0 : 1;
      const double at = axis == 0 ? ray.o.x : ray.o.z;
      const double t = (q[axis] * ray.o.y - at) / down[axis];
      if (!std::isfinite(t)) return;
      sides.push_back({t, i + swept::first_side});
      if (ray.d.y != 0 && t < t_apex) inside = !inside;
    });
    return inside;
  }
};

/// Operands as the interpreter lays them out; the points follow.
enum : std::size_t { spline_at, conic_at, low_at, high_at, open_at, points_at };

constexpr std::array<scene::Param, points_at> prism_params = {
    scene::Param{"spline", scene::ArgKind::number, "kind of spline, 0 to 3"},
    scene::Param{"conic_sweep", scene::ArgKind::number, "1: narrows towards the origin"},
    scene::Param{"low", scene::ArgKind::number, "height of one end"},
    scene::Param{"high", scene::ArgKind::number, "height of the other end"},
    scene::Param{"open", scene::ArgKind::number, "1: has no ends"}};

Curves curves_of(std::span<const double> args) {
  return closed_curves(static_cast<Spline>(args[spline_at]), points_of(args.subspan(points_at)));
}

std::optional<ShapeRef> place_prism(TypeStores& stores, std::span<const double> args,
                                    const Transform& to_world, bool inverted) {
  Prism prism;
  prism.outline = shared_data<PrismOutline>(args, [](std::span<const double> all) {
    return std::make_shared<const PrismOutline>(curves_of(all).arcs);
  });
  if (prism.outline->empty()) return std::nullopt;
  prism.low = std::min(args[low_at], args[high_at]);
  prism.high = std::max(args[low_at], args[high_at]);
  prism.conic = args[conic_at] != 0;
  prism.open = args[open_at] != 0;
  return place_shape(stores, std::move(prism), to_world, inverted);
}

std::vector<std::vector<double>> prism_samples() {
  return {{0, 0, -0.5, 1, 0, -1, -1, 1, -1, 1.2, 1, -1, 1, -1, -1},
          {0, 1, 0.4, 1.5, 1, -1, -1, 1, -1, 1.2, 1, -1, 1, -1, -1},
          {0, 0, 0, 1, 0, 2, 2, -2, 2, -2, -2, 2, -2, 2, 2, 1, 1, -1, 1, 0, -1, 1, 1},  // a hole
          {2, 0, 0, 1, 0, -1, 1, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0},
          {1, 0, 0, 1, 0, -1, 0, 0, -1, 1, 0, 0, 1, -1, 0, 0, -1},
          {3, 1, -1, 1, 0, -1, 0, -1, -1, 1, -1, 1, 0, 1, 0, 1, 1, -1, 1, -1, 0}};
}

constexpr PrimitiveType describe_prism() {
  PrimitiveType type;
  type.name = "prism";
  type.doc = "An outline swept along the y axis.";
  type.params = prism_params;
  type.open_ended = true;
  type.sides_by_order = true;
  type.validate = [](std::span<const double> args) { return curves_of(args).problem; };
  type.doubt = [](std::span<const double> args) { return curves_of(args).doubt; };
  type.make_stores = [] { return make_type_stores<Prism>(); };
  type.place = place_prism;
  type.samples = prism_samples;
  return type;
}

}  // namespace

extern constinit const PrimitiveType prism_primitive = describe_prism();

}  // namespace durer::tracer

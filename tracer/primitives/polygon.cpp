#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/profile.h"

namespace durer::tracer {
namespace {

// A flat piece with straight edges, by the even-odd rule (objects §11.4). It has no inside.
struct Polygon {
  Outline outline;  // in the coordinates below
  dvec3 origin{0.0};
  dvec3 u{1, 0, 0};
  dvec3 v{0, 1, 0};
  dvec3 n{0, 0, 1};
  Bounds3 box;

  static constexpr double far = t_far;

  [[nodiscard]] Bounds3 bounds() const { return box; }
  [[nodiscard]] bool contains(dvec3 /*p*/) const { return false; }
  [[nodiscard]] dvec3 normal(dvec3 /*p*/, std::uint32_t /*part*/) const { return n; }
  [[nodiscard]] std::optional<double> hit(const Ray& ray) const {
    const double slope = glm::dot(n, ray.d);
    if (std::abs(slope) < epsilon) return std::nullopt;
    const double t = glm::dot(n, origin - ray.o) / slope;
    const dvec3 p = ray.at(t) - origin;
    if (!outline.contains({glm::dot(p, u), glm::dot(p, v)})) return std::nullopt;
    return t;
  }
  void crossings(const Ray& ray, Crossings& out) const {
    if (const auto t = hit(ray)) out.push_back({*t, 0, 0, Side::sheet, true});
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    const auto t = hit(ray);
    if (!t || !(*t >= t_from && *t < t_to)) return std::nullopt;
    return Nearest{*t, 0};
  }
};

std::vector<dvec3> corners_of(std::span<const double> args) {
  std::vector<dvec3> p;
  for (std::size_t i = 1; i + 2 < args.size(); i += 3)
    p.push_back({args[i], args[i + 1], args[i + 2]});
  return p;
}

bool same(dvec3 a, dvec3 b) {
  return std::abs(a.x - b.x) < epsilon && std::abs(a.y - b.y) < epsilon &&
         std::abs(a.z - b.z) < epsilon;
}

/// Edges of loops, each as two indices; a loop ends where its first corner comes again.
struct Loops {
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  bool closed = true;
};
Loops loops_of(const std::vector<dvec3>& p) {
  Loops loops;
  for (std::size_t first = 0; first < p.size();) {
    std::size_t last = first + 1;
    while (last < p.size() && !same(p[last], p[first])) ++last;
    loops.closed = loops.closed && last < p.size();
    for (std::size_t i = first; i < last; ++i)
      loops.edges.emplace_back(i, i + 1 < last ? i + 1 : first);
    first = last + 1;
  }
  return loops;
}

/// The plane of the corners; none if there is no one plane.
bool find_plane(const std::vector<dvec3>& p, Polygon& out) {
  out.origin = p[0];
  std::size_t i = 1;
  const auto length2 = [&](dvec3 x) { return glm::dot(x, x); };
  while (i < p.size() && !(length2(p[i] - p[0]) > epsilon)) ++i;
  if (i == p.size()) return false;
  const dvec3 u = p[i] - p[0];
  dvec3 n(0.0);
  for (++i; i < p.size() && n == dvec3(0.0); ++i) {
    const dvec3 v = p[i] - p[0];
    const dvec3 cross = glm::cross(u, v);
    if (length2(v) > epsilon && length2(cross) > epsilon) n = glm::normalize(cross);
  }
  if (n == dvec3(0.0)) return false;
  out.n = n;
  out.u = glm::normalize(u);
  out.v = glm::cross(n, out.u);
  return std::all_of(p.begin(), p.end(),
                     [&](dvec3 q) { return std::abs(glm::dot(q - p[0], n)) <= epsilon; });
}

std::optional<ShapeRef> place_polygon(TypeStores& stores, std::span<const double> args,
                                      const Transform& to_world, bool /*inverted*/) {
  const std::vector<dvec3> p = corners_of(args);
  Polygon polygon;
  if (!find_plane(p, polygon)) return std::nullopt;
  std::vector<dvec2> flat;
  for (const dvec3 q : p) {
    flat.push_back({glm::dot(q - p[0], polygon.u), glm::dot(q - p[0], polygon.v)});
    polygon.box.add(q);
  }
  std::vector<Arc> arcs;
  for (const auto& [from, to] : loops_of(p).edges)
    arcs.push_back(straight_arc(flat[from], flat[to]));
  polygon.outline = Outline(std::move(arcs));
  constexpr double pad = 1e-3;
  for (int i = 0; i < 3; ++i) {
    if (polygon.box.hi[i] - polygon.box.lo[i] >= pad) continue;
    polygon.box.lo[i] -= pad;
    polygon.box.hi[i] += pad;
  }
  return place_shape(stores, std::move(polygon), to_world, false);
}

constexpr std::array<scene::Param, 1> polygon_params = {
    scene::Param{"count", scene::ArgKind::number, "how many points follow"}};

constexpr PrimitiveType describe_polygon() {
  PrimitiveType type;
  type.name = "polygon";
  type.doc = "A flat piece with straight edges, and holes.";
  type.params = polygon_params;
  type.open_ended = true;
  type.sides_by_order = true;
  type.validate = [](std::span<const double> args) -> std::optional<std::string> {
    if (args[0] >= 3) return std::nullopt;
    return fmt::format("a polygon takes 3 points or more, here are {}", args[0]);
  };
  type.doubt = [](std::span<const double> args) -> std::optional<std::string> {
    if (loops_of(corners_of(args)).closed) return std::nullopt;
    return "the outline is not closed; it is closed by a straight line";
  };
  type.make_stores = [] { return make_type_stores<Polygon>(); };
  type.place = place_polygon;
  type.samples = [] {
    return std::vector<std::vector<double>>{
        {5, 0, 0, 0, 1, 0, 0.5, 1, 1, 0.5, 0, 1, 0, 0, 0, 0},
        {9,  -1, -1,   0,    1, -1,  0,    1, 1, 0,   -1, 1,    0,    -1,
         -1, 0,  -0.5, -0.5, 0, 0.5, -0.5, 0, 0, 0.5, 0,  -0.5, -0.5, 0}};
  };
  return type;
}

}  // namespace

extern constinit const PrimitiveType polygon_primitive = describe_polygon();

}  // namespace durer::tracer

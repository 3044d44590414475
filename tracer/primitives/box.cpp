#include <cmath>

#include "tracer/primitives/describe.h"

namespace durer::tracer {
namespace {

// Box with sides along the axes, between two opposite corners given in any order (objects §10.2).
struct Box {
  dvec3 corner1{0.0};
  dvec3 corner2{1.0};

  static constexpr std::array params{
      positional<&Box::corner1>("corner1", "one corner"),
      positional<&Box::corner2>("corner2", "the opposite corner"),
  };

  static std::vector<Box> samples() {
    return {{dvec3(-1.0), dvec3(1.0)}, {{3, -1, 2}, {1, 4, 2.5}}, {{0, 0, 0}, {100, 0.01, 1}}};
  }

  struct Slabs;
  [[nodiscard]] std::optional<Framed<Slabs>> shape() const;
};

struct Box::Slabs {
  dvec3 lo;
  dvec3 hi;

  static constexpr bool convex = true;

  [[nodiscard]] Bounds3 bounds() const { return {lo, hi}; }
  [[nodiscard]] bool contains(dvec3 p) const { return bounds().contains(p); }
  /// Parts 0…5: low x, high x, low y, …
  [[nodiscard]] dvec3 normal(dvec3 /*p*/, std::uint32_t part) const {
    // Not put together in memory, which keeps a processor waiting.
    const double side = (part & 1U) != 0 ? 1 : -1;
    const std::uint32_t axis = part >> 1U;
    return {axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0};
  }

  // The faces of a cross-shaped sheet, four parts wide and three high (objects §14).
  [[nodiscard]] dvec2 uv(dvec3 p, std::uint32_t part) const {
    const dvec3 s = (p - lo) / (hi - lo);
    switch (part) {
      case 0: return {s.z / 4, (1 + s.y) / 3};
      case 1: return {(3 - s.z) / 4, (1 + s.y) / 3};
      case 2: return {(1 + s.x) / 4, s.z / 3};
      case 3: return {(1 + s.x) / 4, 1 - s.z / 3};
      case 4: return {1 - s.x / 4, (1 + s.y) / 3};
      default: return {(1 + s.x) / 4, (1 + s.y) / 3};
    }
  }

  /// A box moves into the world if its sides stay along the axes.
  [[nodiscard]] std::optional<Slabs> moved(const Transform& m) const {
    const Affine& f = m.forward;
    if (f.x.y != 0 || f.x.z != 0 || f.y.x != 0 || f.y.z != 0 || f.z.x != 0 || f.z.y != 0) {
      return std::nullopt;
    }
    Bounds3 b;
    b.add(m.point(lo));
    b.add(m.point(hi));
    return Slabs{b.lo, b.hi};
  }

  struct Span {
    double enter = -no_hit_depth;
    double exit = no_hit_depth;
    int enter_axis = 0;
    int exit_axis = 0;
  };

  // Where two slabs begin (or end) within 1e-6 of each other, at edges and corners, the face that
  // looks more against the ray wins; a bound moves only by 1e-6 or more (objects §10.2).
  [[nodiscard]] std::optional<Span> span(const Ray& ray) const {
    constexpr double tie = 1e-6;
    Span s;
    double enter_d = 0;
    double exit_d = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = ray.d[axis];
      const double o = ray.o[axis];
      const double steep = std::abs(d);
      if (steep < epsilon) {
        if (o < lo[axis] || o > hi[axis]) return std::nullopt;
        continue;
      }
      double t1 = (lo[axis] - o) / d;
      double t2 = (hi[axis] - o) / d;
      if (t1 > t2) std::swap(t1, t2);
      if (t1 >= s.enter + tie) {
        s.enter = t1, s.enter_axis = axis, enter_d = steep;
      } else if (t1 > s.enter - tie && steep > enter_d) {
        s.enter_axis = axis, enter_d = steep;
      }
      if (t2 <= s.exit - tie) {
        s.exit = t2, s.exit_axis = axis, exit_d = steep;
      } else if (t2 < s.exit + tie && steep > exit_d) {
        s.exit_axis = axis, exit_d = steep;
      }
      if (!(s.enter <= s.exit)) return std::nullopt;
    }
    return s;
  }
  [[nodiscard]] static std::uint16_t enter_part(const Ray& ray, const Span& s) {
    return static_cast<std::uint16_t>(2 * s.enter_axis + (ray.d[s.enter_axis] > 0 ? 0 : 1));
  }
  [[nodiscard]] static std::uint16_t exit_part(const Ray& ray, const Span& s) {
    return static_cast<std::uint16_t>(2 * s.exit_axis + (ray.d[s.exit_axis] > 0 ? 1 : 0));
  }

  void crossings(const Ray& ray, Crossings& out) const {
    const auto s = span(ray);
    if (!s) return;
    out.push_back({.t = s->enter, .part = enter_part(ray, *s), .side = Side::enter});
    out.push_back({.t = s->exit, .part = exit_part(ray, *s), .side = Side::exit});
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    const auto s = span(ray);
    if (!s || s->exit < t_from || s->enter >= t_to) return std::nullopt;
    if (s->enter >= t_from) return Nearest{s->enter, enter_part(ray, *s)};
    if (s->exit >= t_to) return std::nullopt;
    return Nearest{s->exit, exit_part(ray, *s)};
  }
};

std::optional<Framed<Box::Slabs>> Box::shape() const {
  Bounds3 b;
  b.add(corner1);
  b.add(corner2);
  return Framed<Slabs>{{b.lo, b.hi}, {}};
}

}  // namespace

extern constinit const PrimitiveType box_primitive =
    describe<Box>("box", "A box with sides along the axes: two opposite corners.");

}  // namespace durer::tracer

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tracer/primitives/around_axis.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/profile.h"

namespace durer::tracer {
namespace {

// A curve in the half-plane of radius and height, turned around the y axis (objects §10.7). Where
// it ends away from the axis its inside ends too, level with the end, but nothing is to be seen.
// Nor is what lies nearer to the axis than all of the curve ever inside.
struct Lathe {
  Outline profile;          // x: radius, y: height
  std::size_t count = 1;    // of arcs
  std::vector<dvec2> ends;  // of the curve, away from the axis

  static constexpr double far = t_far;

  [[nodiscard]] Bounds3 bounds() const {
    const double r = std::max(std::abs(profile.lo().x), std::abs(profile.hi().x));
    return {{-r, profile.lo().y, -r}, {r, profile.hi().y, r}};
  }
  /// The radius within which nothing is inside.
  [[nodiscard]] double core() const { return std::max(profile.lo().x, 0.0); }
  [[nodiscard]] static dvec2 onto_profile(dvec3 p) { return {std::hypot(p.x, p.z), p.y}; }
  [[nodiscard]] bool contains(dvec3 p) const {
    const dvec2 q = onto_profile(p);
    return q.x >= core() && profile.contains(q);
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const {
    const dvec2 q = onto_profile(p);
    if (q.x * q.x <= epsilon) return {0, 1, 0};
    const Arc& arc = profile.arc(part);
    const dvec2 slope = arc.slope_near(q);
    return {slope.y * p.x, -slope.x * q.x, slope.y * p.z};
  }
  [[nodiscard]] dvec2 uv(dvec3 p, std::uint32_t part) const {
    const Arc& arc = profile.arc(part);
    const double along = arc.nearest_to(onto_profile(p)) + arc.number;
    return {turn_around_y(p), std::min(along / static_cast<double>(count), 1.0)};
  }

  /// Calls f(s, part, visible) for every crossing, in no order.
  template <typename F>
  void each_crossing(const LineAroundY& line, F&& f) const {
    if (line.level()) {
      each_level_crossing(line, f);
      return;
    }
    const Weights weights(line);
    constexpr double endless = std::numeric_limits<double>::infinity();
    profile.each_near(
        [&](const Outline::Box& box) { return comes_near(line, box, -endless, endless); },
        [&](std::uint32_t i) {
          each_root(profile.arc(i), line, weights, [&](double s) { f(s, i, true); });
        });
    for (const dvec2 end : ends) {
      const double y = end.y - line.y;
      if (weights.square(end.x, y, line) < 0) f(y / line.up, 0U, false);
    }
  }
  void crossings(const Ray& ray, Crossings& out) const {
    const LineAroundY line(ray);
    const auto first = static_cast<std::ptrdiff_t>(out.size());
    each_crossing(line, [&](double s, std::uint32_t part, bool visible) {
      out.push_back({line.middle + s, 0, part, Side::enter, visible});
    });
    // A closed curve has no inside there anyway.
    const double core2 = (core() * core() - line.near2) / line.across2;
    if (!ends.empty() && core2 > 0) {
      for (const double s : {-std::sqrt(core2), std::sqrt(core2)}) {
        out.push_back({line.middle + s, 0, of_core, Side::enter, false});
      }
    }
    set_sides(out, first);
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    const LineAroundY line(ray);
    std::optional<Nearest> best;
    const auto take = [&](double s, std::uint32_t part) {
      const double t = line.middle + s;
      if (!(t >= t_from) || !(t < t_to)) return;
      best = Nearest{t, part};
      t_to = t;
    };
    if (line.level()) {
      const auto any_level = [&](double s, std::uint32_t part, bool) { take(s, part); };
      each_level_crossing(line, any_level);
      return best;
    }
    const Weights weights(line);
    profile.each_near(
        [&](const Outline::Box& box) {
          return comes_near(line, box, t_from - line.middle, t_to - line.middle);
        },
        [&](std::uint32_t i) {
          each_root(profile.arc(i), line, weights, [&](double s) { take(s, i); });
        });
    return best;
  }
  /// Some crossing in the range.
  [[nodiscard]] std::optional<Nearest> any(const Ray& ray, double t_from, double t_to) const {
    const LineAroundY line(ray);
    if (line.level()) return nearest(ray, t_from, t_to);
    const Weights weights(line);
    const double s_from = t_from - line.middle;
    const double s_to = t_to - line.middle;
    bool found = false;
    profile.each_near(
        [&](const Outline::Box& box) { return !found && comes_near(line, box, s_from, s_to); },
        [&](std::uint32_t i) {
          if (!found) found = crosses(profile.arc(i), line, weights, s_from, s_to);
        });
    if (!found) return std::nullopt;
    return Nearest{t_from, 0};
  }

 private:
  static constexpr std::uint32_t of_core = 0xFFFFFFFF;

  /// Sorts the crossings from `first` on, and leaves those where the inside begins or ends.
  static void set_sides(Crossings& out, std::ptrdiff_t first) {
    std::sort(out.begin() + first, out.end(),
              [](const Crossing& x, const Crossing& y) { return x.t < y.t; });
    bool within = false;
    bool in_core = false;
    auto end = out.begin() + first;
    for (auto c = end; c != out.end(); ++c) {
      const bool inside = within && !in_core;
      (c->part == of_core ? in_core : within) ^= true;
      if ((within && !in_core) == inside) continue;
      *end = *c;
      end->side = inside ? Side::exit : Side::enter;
      if (end->part == of_core) end->part = 0;
      ++end;
    }
    out.erase(end, out.end());
  }

  /// The point at radius x, height y above the line's middle lies between line and axis where
  /// a·y² + b·near2 - b·x² is negative.
  struct Weights {
    double a;
    double b;
    explicit Weights(const LineAroundY& line) {
      const double all = 1 / (line.across2 + line.up * line.up);
      a = line.across2 * all;
      b = line.up * line.up * all;
    }
    [[nodiscard]] double square(double x, double y, const LineAroundY& line) const {
      return a * (y * y) + b * line.near2 - b * (x * x);
    }
  };

  /// False if the line is elsewhere wherever it is as high as the box, or there at no s in
  /// s_from…s_to.
  static bool comes_near(const LineAroundY& line, const Outline::Box& box, double s_from,
                         double s_to) {
    const double s1 = (box.middle.y - box.half.y - line.y) / line.up;
    const double s2 = (box.middle.y + box.half.y - line.y) / line.up;
    constexpr double slack = 1e-9;
    const double farthest = std::max(std::abs(s1), std::abs(s2));
    if (std::max(s1, s2) + slack * farthest < s_from ||
        std::min(s1, s2) - slack * farthest > s_to) {
      return false;
    }
    const double nearest = (s1 < 0) != (s2 < 0) ? 0 : std::min(std::abs(s1), std::abs(s2));
    const double outer = std::abs(box.middle.x) + box.half.x;
    const double inner = std::max(std::abs(box.middle.x) - box.half.x, 0.0);
    return line.distance2(nearest) <= outer * outer * (1 + slack) &&
           line.distance2(farthest) * (1 + slack) >= inner * inner;
  }

  /// Weights::square along the arc.
  template <std::size_t N>
  static Bernstein<2 * N> square(const Arc& arc, const LineAroundY& line, const Weights& weights) {
    Bernstein<N> x{};
    Bernstein<N> y{};
    for (std::size_t i = 0; i <= N; ++i) x[i] = arc.c[i].x, y[i] = arc.c[i].y - line.y;
    const auto x2 = product<N, N>(x, x);
    const auto y2 = product<N, N>(y, y);
    Bernstein<2 * N> sum{};
    for (std::size_t i = 0; i <= 2 * N; ++i) {
      sum[i] = weights.a * y2[i] + weights.b * line.near2 - weights.b * x2[i];
    }
    return sum;
  }
  /// Calls f(s) for the crossings with the arc.
  template <typename F>
  static void each_root(const Arc& arc, const LineAroundY& line, const Weights& weights, F&& f) {
    const auto roots = [&](const auto& found) {
      for (const double w : found) f(place(arc.at(w), line, weights));
    };
    switch (arc.degree) {
      case 1: roots(sign_changes<2>(square<1>(arc, line, weights))); break;
      case 2: roots(sign_changes<4>(square<2>(arc, line, weights))); break;
      default: roots(sign_changes<6>(square<3>(arc, line, weights))); break;
    }
  }
  static double place(dvec2 q, const LineAroundY& line, const Weights& weights) {
    const double s = (q.y - line.y) / line.up;
    // Of lines that hardly climb, the radius tells more.
    if (weights.b >= 1e-4) return s;
    return std::copysign(std::sqrt(std::max(q.x * q.x - line.near2, 0.0) / line.across2), s);
  }

  static bool crosses(const Arc& arc, const LineAroundY& line, const Weights& weights,
                      double s_from, double s_to) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(arc.degree); ++i) {
      const double s = (arc.c[i].y - line.y) / line.up;
      least = std::min(least, s);
      most = std::max(most, s);
    }
    if (weights.b >= 1e-4 && least >= s_from && most < s_to) {  // wherever it is, it counts
      switch (arc.degree) {
        case 1: return has_sign_change<2>(square<1>(arc, line, weights));
        case 2: return has_sign_change<4>(square<2>(arc, line, weights));
        default: return has_sign_change<6>(square<3>(arc, line, weights));
      }
    }
    bool found = false;
    each_root(arc, line, weights, [&](double s) { found = found || (s >= s_from && s < s_to); });
    return found;
  }

  template <typename F>
  void each_level_crossing(const LineAroundY& line, F& f) const {
    profile.each_crossing({0, 1, -line.y}, [&](std::uint32_t i, double w) {
      const double x = profile.arc(i).at(w).x;
      const double s2 = (x * x - line.near2) / line.across2;
      if (!(s2 > 0)) return;
      f(-std::sqrt(s2), i, true);
      f(std::sqrt(s2), i, true);
    });
  }
};

enum : std::size_t { spline_at, points_at };

constexpr std::array<scene::Param, points_at> lathe_params = {
    scene::Param{"spline", scene::ArgKind::number, "kind of spline, 0 to 3"}};

Curves curve_of(std::span<const double> args) {
  return open_curve(static_cast<Spline>(args[spline_at]), points_of(args.subspan(points_at)));
}

std::optional<std::string> lathe_problem(std::span<const double> args) {
  const std::vector<dvec2> points = points_of(args.subspan(points_at));
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (points[i].x < 0) return "a lathe has no negative radius";
  }
  return curve_of(args).problem;
}

std::optional<ShapeRef> place_lathe(TypeStores& stores, std::span<const double> args,
                                    const Transform& to_world, bool inverted) {
  std::vector<Arc> arcs = curve_of(args).arcs;
  if (arcs.empty()) return std::nullopt;
  Lathe lathe;
  lathe.count = arcs.size();
  // Chains of arcs, each of which may end in the open.
  for (std::size_t first = 0, i = 0; i < arcs.size(); ++i) {
    if (i + 1 < arcs.size() && arcs[i].end() == arcs[i + 1].begin()) continue;
    if (arcs[first].begin() != arcs[i].end()) {
      lathe.ends.push_back(arcs[first].begin());
      lathe.ends.push_back(arcs[i].end());
    }
    first = i + 1;
  }
  std::erase_if(lathe.ends, [](dvec2 end) { return end.x == 0; });
  lathe.profile = Outline(std::move(arcs));
  return place_shape(stores, std::move(lathe), to_world, inverted);
}

constexpr PrimitiveType describe_lathe() {
  PrimitiveType type;
  type.name = "lathe";
  type.doc = "A curve turned around the y axis.";
  type.params = lathe_params;
  type.open_ended = true;
  type.sides_by_order = true;
  type.validate = lathe_problem;
  type.make_stores = [] { return make_type_stores<Lathe>(); };
  type.place = place_lathe;
  type.samples = [] {
    return std::vector<std::vector<double>>{
        {0, 0, -1, 1, 0, 0.2, 1, 0, 1.2},                // closed by the axis
        {0, 0.5, 0, 1, 0.3, 0.8, 1},                     // open at both ends
        {1, 0, -1, 0.5, 0, 1, 1, 0.5, 2, 0.7, 3},        // quadratic
        {2, 0, -1, 0.5, 0, 1, 1, 0.5, 2, 0.7, 3, 0, 4},  // cubic
        {3, 0.5, 0, 1.5, 0.5, 0, 1.5, 0.5, 2},           // Bézier
        {0, 1, 0, 1.5, 0, 1.4, 0.6, 0.9, 0.3, 1, 0}};    // a ring
  };
  return type;
}

}  // namespace

extern constinit const PrimitiveType lathe_primitive = describe_lathe();

}  // namespace durer::tracer

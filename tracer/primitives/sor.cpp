#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/roots/bernstein.h"
#include "tracer/primitives/around_axis.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer {
namespace {

// A surface of revolution around the y axis whose squared radius is a cubic of the height between
// any two of its points (objects §10.9).
struct Sor {
  struct Segment {
    double low;
    double high;
    Bernstein<3> radius2;  // over [low, high]
  };
  std::vector<Segment> segments;  // rising
  double widest2 = 0;             // no radius² is greater
  bool open = false;

  static constexpr double far = t_far;
  // Parts: the two ends, then the segments.
  static constexpr std::uint32_t bottom = 0;
  static constexpr std::uint32_t top = 1;
  static constexpr std::uint32_t first_segment = 2;

  [[nodiscard]] double low() const { return segments.front().low; }
  [[nodiscard]] double high() const { return segments.back().high; }
  [[nodiscard]] Bounds3 bounds() const {
    const double r = std::sqrt(widest2);
    return {{-r, low(), -r}, {r, high(), r}};
  }
  [[nodiscard]] const Segment& segment_at(double y) const {
    const auto above = std::partition_point(segments.begin(), segments.end() - 1,
                                            [y](const Segment& s) { return s.high < y; });
    return *above;
  }
  [[nodiscard]] static double place_in(const Segment& s, double y) {
    return (y - s.low) / (s.high - s.low);
  }
  [[nodiscard]] bool contains(dvec3 p) const {
    if (!(p.y >= low() && p.y <= high())) return false;
    const Segment& s = segment_at(p.y);
    return p.x * p.x + p.z * p.z <= value_and_slope<3>(s.radius2, place_in(s, p.y)).value;
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const {
    if (part < first_segment) return {0, part == top ? 1 : -1, 0};
    const Segment& s = segments[part - first_segment];
    const double slope = value_and_slope<3>(s.radius2, place_in(s, p.y)).slope;
    return {p.x, -0.5 * slope / (s.high - s.low), p.z};
  }
  [[nodiscard]] dvec2 uv(dvec3 p, std::uint32_t part) const {
    const double u = turn_around_y(p);
    const double rho = std::hypot(p.x, p.z);
    if (part == bottom) return {u, rho / std::sqrt(segments.front().radius2[0]) - 1};
    if (part == top) return {u, 2 - rho / std::sqrt(segments.back().radius2[3])};
    const std::uint32_t i = part - first_segment;
    return {u, (i + place_in(segments[i], p.y)) / static_cast<double>(segments.size())};
  }

  /// Calls f(crossing) for every crossing in t_from…t_to, and perhaps some others, ascending, until
  /// it returns false.
  template <typename F>
  void each_crossing(const Ray& ray, double t_from, double t_to, F&& f) const {
    const LineAroundY line(ray);
    const Stretch all = stretch(line);
    if (all.level) each_level_crossing(line, all.s_out, f);
    bool known = false;  // whether the line is inside, which no segment before t_from was asked
    bool inside = false;
    const auto emit = [&](double s, std::uint32_t part, bool visible) {
      inside = !inside;
      return f(Crossing{line.middle + s, 0, part, inside ? Side::enter : Side::exit, visible});
    };
    const bool done = each_segment(line, all, [&](std::size_t i, double s_enter, double s_leave) {
      const double a = std::max(s_enter, all.s_in);
      const double b = std::min(s_leave, all.s_out);
      if (!(a < b) || line.middle + b < t_from) return true;
      if (line.middle + a > t_to) return false;
      const Bernstein<3> gap = excess(segments[i], line, a, b, s_enter, s_leave);
      if (!known && !(gap[0] < 0)) {
        inside = a > all.s_in;  // or it comes through an end
        if (!inside && !emit(a, all.first_end, sees_end(all.first_end))) return false;
      }
      known = true;
      for (const double w : sign_changes<3>(gap)) {
        if (!emit(a + (b - a) * w, static_cast<std::uint32_t>(i) + first_segment, true)) return false;
      }
      return true;
    });
    if (done && inside) emit(all.s_out, all.last_end, sees_end(all.last_end));
  }
  void crossings(const Ray& ray, Crossings& out) const {
    constexpr double endless = std::numeric_limits<double>::infinity();
    each_crossing(ray, -endless, endless, [&](const Crossing& c) {
      out.push_back(c);
      return true;
    });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    std::optional<Nearest> best;
    each_crossing(ray, t_from, t_to, [&](const Crossing& c) {
      if (!(c.t < t_to)) return false;
      if (!c.visible || !(c.t >= t_from)) return true;
      best = Nearest{c.t, c.part};
      return false;
    });
    return best;
  }
  /// Some crossing in the range.
  [[nodiscard]] std::optional<Nearest> any(const Ray& ray, double t_from, double t_to) const {
    const LineAroundY line(ray);
    const Stretch all = stretch(line);
    if (all.level) return nearest(ray, t_from, t_to);
    const double s_from = std::max(t_from - line.middle, all.s_in);
    const double s_to = std::min(t_to - line.middle, all.s_out);
    const bool none = each_segment(line, all, [&](std::size_t i, double s_enter, double s_leave) {
      const double a = std::max(s_enter, s_from);
      const double b = std::min(s_leave, s_to);
      if (!(a < b)) return true;
      const Bernstein<3> gap = excess(segments[i], line, a, b, s_enter, s_leave);
      if (a == all.s_in && !(gap[0] < 0) && sees_end(all.first_end)) return false;
      if (b == all.s_out && !(gap[3] < 0) && sees_end(all.last_end)) return false;
      return !has_sign_change<3>(gap);
    });
    if (none) return std::nullopt;
    return Nearest{t_from, 0};
  }

 private:
  /// What of a line is as high as the curve, and as near to the axis as its widest place.
  struct Stretch {
    double s_in = 0;  // the line is elsewhere if s_in >= s_out
    double s_out = 0;
    std::uint32_t first_end = bottom;
    std::uint32_t last_end = top;
    bool level = false;  // the height does not change: then s_out is the reach to both sides
  };
  [[nodiscard]] Stretch stretch(const LineAroundY& line) const {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const double reach2 = widest2 * (1 + 1e-9) - line.near2;
    if (!(reach2 > 0)) return {};
    const double reach = line.across2 > 0 ? std::sqrt(reach2 / line.across2) : endless;
    if (line.up == 0 || (line.level() && std::abs(line.up) * reach < 1e-9 * (high() - low()))) {
      return {reach, reach, bottom, top, true};
    }
    const bool climbs = line.up > 0;
    return {std::max((climbs ? low() - line.y : high() - line.y) / line.up, -reach),
            std::min((climbs ? high() - line.y : low() - line.y) / line.up, reach),
            climbs ? bottom : top, climbs ? top : bottom, false};
  }

  /// Calls f(segment, where the line enters its heights, where it leaves them) in the line's order,
  /// until it returns false; then the result is false.
  template <typename F>
  [[nodiscard]] bool each_segment(const LineAroundY& line, const Stretch& all, F&& f) const {
    if (!(all.s_in < all.s_out)) return true;
    const bool climbs = line.up > 0;
    const std::size_t n = segments.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = climbs ? k : n - 1 - k;
      const Segment& segment = segments[i];
      const double s_enter = ((climbs ? segment.low : segment.high) - line.y) / line.up;
      const double s_leave = ((climbs ? segment.high : segment.low) - line.y) / line.up;
      if (!f(i, s_enter, s_leave)) return false;
    }
    return true;
  }

  [[nodiscard]] bool sees_end(std::uint32_t end) const {
    const double radius2 = end == bottom ? segments.front().radius2[0] : segments.back().radius2[3];
    return !open && radius2 > 1e-4;
  }

  /// By how much the surface is farther from the axis than the line, squared, over the piece [a, b]
  /// of the line. At the heights of the points it has the same value for both neighbours.
  static Bernstein<3> excess(const Segment& segment, const LineAroundY& line, double a, double b,
                             double s_enter, double s_leave) {
    Bernstein<3> radius2 = segment.radius2;
    if (line.up < 0) std::swap(radius2[0], radius2[3]), std::swap(radius2[1], radius2[2]);
    if (a > s_enter || b < s_leave) {
      const double size = s_leave - s_enter;
      radius2 = restricted<3>(radius2, (a - s_enter) / size, (b - s_enter) / size);
    }
    const Bernstein<2> away{line.distance2(a), line.near2 + line.across2 * (a * b),
                            line.distance2(b)};
    return {radius2[0] - away[0], radius2[1] - (away[0] + 2 * away[1]) / 3,
            radius2[2] - (2 * away[1] + away[2]) / 3, radius2[3] - away[2]};
  }

  template <typename F>
  void each_level_crossing(const LineAroundY& line, double reach, F& f) const {
    if (!(line.y >= low() && line.y < high()) || std::isinf(reach)) return;
    const Segment& s = segment_at(line.y);
    const double radius2 = value_and_slope<3>(s.radius2, place_in(s, line.y)).value;
    const double half2 = (radius2 - line.near2) / line.across2;
    if (!(half2 > 0)) return;
    const auto part = static_cast<std::uint32_t>(&s - segments.data()) + first_segment;
    if (f(Crossing{line.middle - std::sqrt(half2), 0, part, Side::enter, true})) {
      f(Crossing{line.middle + std::sqrt(half2), 0, part, Side::exit, true});
    }
  }
};

enum : std::size_t { open_at, points_at };

constexpr std::array<scene::Param, points_at> sor_params = {
    scene::Param{"open", scene::ArgKind::number, "1: has no ends"}};

std::optional<std::string> sor_problem(std::span<const double> args) {
  const auto points = args.subspan(points_at);
  const std::size_t n = points.size() / 2;
  const auto radius = [&](std::size_t i) { return points[2 * i]; };
  const auto height = [&](std::size_t i) { return points[2 * i + 1]; };
  if (n < 4) return fmt::format("a surface of revolution takes 4 points or more, here are {}", n);
  for (std::size_t i = 0; i < n; ++i) {
    if (radius(i) < 0) return "a surface of revolution has no negative radius";
    if (i >= 2 && i + 1 < n && !(height(i) > height(i - 1))) {
      return fmt::format("point {} must be higher than the one before it", i + 1);
    }
    if (i >= 2 && std::abs(height(i) - height(i - 2)) < epsilon) {
      return fmt::format("points {} and {} must not be equally high", i - 1, i + 1);
    }
  }
  return std::nullopt;
}

std::optional<ShapeRef> place_sor(TypeStores& stores, std::span<const double> args,
                                  const Transform& to_world, bool inverted) {
  const auto points = args.subspan(points_at);
  const std::size_t n = points.size() / 2;
  Sor sor;
  sor.open = args[open_at] != 0;
  const auto r = [&](std::size_t i) { return points[2 * i]; };
  const auto h = [&](std::size_t i) { return points[2 * i + 1]; };
  for (std::size_t i = 0; i + 3 < n; ++i) {
    const double size = h(i + 2) - h(i + 1);
    const double slope_low = 2 * r(i + 1) * (r(i + 2) - r(i)) / (h(i + 2) - h(i));
    const double slope_high = 2 * r(i + 2) * (r(i + 3) - r(i + 1)) / (h(i + 3) - h(i + 1));
    const double low2 = r(i + 1) * r(i + 1);
    const double high2 = r(i + 2) * r(i + 2);
    const Bernstein<3> radius2{low2, low2 + slope_low * size / 3, high2 - slope_high * size / 3,
                               high2};
    sor.segments.push_back({h(i + 1), h(i + 2), radius2});
    const Bernstein<2> slope{radius2[1] - radius2[0], radius2[2] - radius2[1],
                             radius2[3] - radius2[2]};
    sor.widest2 = std::max({sor.widest2, low2, high2});
    for (const double w : sign_changes<2>(slope)) {
      sor.widest2 = std::max(sor.widest2, value_and_slope<3>(radius2, w).value);
    }
  }
  if (!(sor.widest2 > 0)) return std::nullopt;
  return place_shape(stores, std::move(sor), to_world, inverted);
}

constexpr PrimitiveType describe_sor() {
  PrimitiveType type;
  type.name = "sor";
  type.doc = "A surface of revolution through points around the y axis.";
  type.params = sor_params;
  type.open_ended = true;
  type.validate = sor_problem;
  type.make_stores = [] { return make_type_stores<Sor>(); };
  type.place = place_sor;
  type.samples = [] {
    return std::vector<std::vector<double>>{{0, 0.5, -1, 0.5, 0, 1, 1, 0.4, 2, 0.3, 3},
                                            {1, 0, -1, 0, 0, 0.8, 0.5, 0.2, 1, 0.6, 1.4, 0.9, 2}};
  };
  return type;
}

}  // namespace

extern constinit const PrimitiveType sor_primitive = describe_sor();

}  // namespace durer::tracer

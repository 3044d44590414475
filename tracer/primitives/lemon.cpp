#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/primitives/around_axis.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/frame.h"
#include "tracer/primitives/swept.h"

namespace durer::tracer {
namespace {

// What an arc leaves behind that turns around the line between two points (since 3.8). It is convex.
struct Lemon {
  dvec3 base{0.0};
  double base_radius = 0;
  dvec3 cap{0, 1, 0};
  double cap_radius = 0;
  double inner_radius = 1;
  bool open = false;

  static constexpr std::array params{
      positional<&Lemon::base>("base", "centre of one end"),
      positional<&Lemon::base_radius>("base_radius", "radius at that end"),
      positional<&Lemon::cap>("cap", "centre of the other end"),
      positional<&Lemon::cap_radius>("cap_radius", "radius at the other end"),
      positional<&Lemon::inner_radius>("inner_radius", "radius of the arc between the ends"),
      flag<&Lemon::open>("open", "the wall without its ends"),
  };
  static std::vector<Lemon> samples() {
    return {{dvec3(0.0), 0, {0, 2, 0}, 0, 1.3, false},  {{1, 1, 1}, 0.2, {3, 0, 2}, 0.5, 4, false},
            {{0, 0, -1}, 0.5, {0, 0, 1}, 0.7, 2, true}, {{0, -1, 0}, 0, {0, 1, 0}, 0, 1, false},
            {{0, -1, 0}, 1, {0, 1, 0}, 0.9, 1.1, false}};
  }

  /// Half the distance between the ends of the arc.
  [[nodiscard]] double half_chord() const {
    return 0.5 * std::hypot(glm::distance(base, cap), base_radius - cap_radius);
  }
  [[nodiscard]] std::optional<std::string> problem() const;
  struct Body;
  [[nodiscard]] Body body() const;
  [[nodiscard]] std::optional<Framed<Body>> shape() const;
};

/// On the y axis, from 0 up to `height`.
struct Lemon::Body {
  double height;
  double low_radius;
  double high_radius;
  double arc;     // its radius …
  double centre;  // … and its centre: the height, and how far that lies beyond the axis
  double beyond;
  bool open;

  static constexpr double far = t_far;
  enum Part : std::uint32_t { low_end = swept::low_end, high_end = swept::high_end, wall };

  [[nodiscard]] Bounds3 bounds() const {
    const bool bulges = centre > 0 && centre < height;
    const double r = bulges ? arc - beyond : std::max(low_radius, high_radius);
    return {{-r, 0, -r}, {r, height, r}};
  }
  /// Negative inside the wall; convex.
  [[nodiscard]] double excess(double rho, double y) const {
    const double across = std::max(rho + beyond, 0.0);
    return across * across + (y - centre) * (y - centre) - arc * arc;
  }
  [[nodiscard]] bool contains(dvec3 p) const {
    return p.y >= 0 && p.y < height && excess(std::hypot(p.x, p.z), p.y) < 0;
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const {
    if (part != wall) return {0, part == low_end ? -1 : 1, 0};
    const double rho = std::hypot(p.x, p.z);
    const double f = rho > 0 ? (rho + beyond) / rho : 0;
    return {f * p.x, p.y - centre, f * p.z};
  }
  void crossings(const Ray& ray, Crossings& out) const {
    each(ray, [&out](const Crossing& c) { out.push_back(c); });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    std::optional<Nearest> found;
    each(ray, [&](const Crossing& c) {
      if (!found && c.visible && c.t >= t_from && c.t < t_to) found = Nearest{c.t, c.part};
    });
    return found;
  }

 private:
  /// Calls f(crossing) where the line enters and where it leaves.
  template <typename F>
  void each(const Ray& ray, F&& f) const {
    const auto ends = swept::between(ray.o.y, ray.d.y, 0, height);
    if (!ends) return;
    const LineAroundY line(ray);
    // A ball around the wall, for a start.
    const double radius = arc + std::max(-beyond, 0.0);
    const double a = line.across2 + line.up * line.up;
    const double rise = line.y - centre;
    const double s = -rise * line.up / a;
    const double gap = radius * radius - line.near2 - rise * rise * (line.across2 / a);
    if (!(gap > 0)) return;
    const double half = std::sqrt(gap / a);
    const double in = newton(line, s - half, -1);
    const double out = newton(line, s + half, 1);
    if (!(in < out)) return;
    Crossing enter{line.middle + in, 0, wall, Side::enter, true};
    Crossing exit{line.middle + out, 0, wall, Side::exit, true};
    if (ends->t_in > enter.t) enter = {ends->t_in, 0, ends->part_in, Side::enter, !open};
    if (ends->t_out < exit.t) exit = {ends->t_out, 0, ends->part_out, Side::exit, !open};
    if (!(enter.t < exit.t)) return;
    f(enter);
    f(exit);
  }
  /// From outside, where the slope has this sign, steps along the tangent of a convex function
  /// never go too far; past its lowest point there is nothing.
  [[nodiscard]] double newton(const LineAroundY& line, double s, double sign) const {
    for (int i = 0; i < 100; ++i) {
      const double rho = std::sqrt(line.distance2(s));
      const double y = line.y + line.up * s;
      const double f = excess(rho, y);
      if (!(f > 0)) break;
      const double d_rho = rho > 0 ? line.across2 * s / rho : 0;
      const double slope =
          2 * (std::max(rho + beyond, 0.0) * d_rho + (y - centre) * line.up);
      if (!(sign * slope > 0)) return std::numeric_limits<double>::quiet_NaN();
      const double step = f / slope;
      s -= step;
      if (std::abs(step) <= 1e-16 * std::abs(s)) break;
    }
    return s;
  }
};

Lemon::Body Lemon::body() const {
  const double height = glm::distance(base, cap);
  const double half = half_chord();
  // The centre lies beside the middle of the chord, on the side of the axis.
  const double off = std::sqrt(std::max(inner_radius * inner_radius - half * half, 0.0));
  const double centre = height / 2 + off * (cap_radius - base_radius) / (2 * half);
  const double across = (base_radius + cap_radius) / 2 - off * height / (2 * half);
  return {height, base_radius, cap_radius, inner_radius, centre, -across, open};
}

std::optional<std::string> Lemon::problem() const {
  if (glm::distance(base, cap) < epsilon) return "the two ends of a lemon must differ";
  if (base_radius < 0 || cap_radius < 0) return "the radii of a lemon must not be negative";
  const Body b = body();
  if (inner_radius < half_chord() || -b.beyond > std::min(base_radius, cap_radius)) {
    return "no arc of this inner radius reaches from one end of the lemon to the other";
  }
  return std::nullopt;
}

std::optional<Framed<Lemon::Body>> Lemon::shape() const {
  if (problem()) return std::nullopt;
  const Body b = body();
  Transform upright;  // y to z
  upright.forward = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, 0}};
  upright.backward = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {0, 0, 0}};
  return Framed<Body>{b, upright.then(frame_along(base, (cap - base) / b.height, 1, 1))};
}

}  // namespace

extern constinit const PrimitiveType lemon_primitive =
    describe<Lemon>("lemon", "An arc that turns around a line: two ends, their radii, the arc's.");

}  // namespace durer::tracer

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tracer/primitives/around_axis.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer {
namespace {

// An egg on the y axis: a ball around the origin, one on top of it, and an arc that joins them
// without an edge (objects §10.14). It is convex.
struct Ovus {
  double bottom = 1;
  double top = 0.5;

  static constexpr std::array params{
      positional<&Ovus::bottom>("bottom", "radius of the lower ball, around the origin"),
      positional<&Ovus::top>("top",
                             "radius of the upper ball, whose centre is the top of the other"),
  };
  static std::vector<Ovus> samples() { return {{1.5, 1}, {1, 1.5}, {1, 0.1}, {1, 1}, {1, 2.5}}; }

  [[nodiscard]] std::optional<std::string> problem() const {
    if (bottom < 0 || top < 0) return "the radii of an egg must not be negative";
    return std::nullopt;
  }
  [[nodiscard]] std::optional<std::string> doubt() const {
    if (top < 2 * bottom) return std::nullopt;
    return "the upper radius is twice the lower one or more: this is the upper ball alone";
  }
  struct Egg;
  [[nodiscard]] std::optional<Framed<Egg>> shape() const;
};

struct Ovus::Egg {
  double bottom;
  double top;
  // The arc: its radius, the height of its centre, how far beyond the axis that lies, its ends.
  double arc = 0;
  double centre = 0;
  double beyond = 0;
  double arc_low = 0;
  double arc_high = 0;

  static constexpr double far = t_far;
  enum Part : std::uint32_t { lower, middle, upper };

  [[nodiscard]] Bounds3 bounds() const {
    if (arc == 0) return {{-top, bottom - top, -top}, {top, bottom + top, top}};  // one ball
    const double r = std::max({arc - beyond, bottom, top});
    return {{-r, -bottom, -r}, {r, bottom + top, r}};
  }
  [[nodiscard]] Part part_at(double y) const {
    return y <= arc_low ? lower : y >= arc_high ? upper : middle;
  }
  /// Negative inside of the whole body that this part belongs to; convex.
  [[nodiscard]] double excess(double rho2, double y, Part part) const {
    switch (part) {
      case lower: return rho2 + y * y - bottom * bottom;
      case upper: return rho2 + (y - bottom) * (y - bottom) - top * top;
      default: {
        const double r = std::sqrt(rho2) + beyond;
        return r * r + (y - centre) * (y - centre) - arc * arc;
      }
    }
  }
  [[nodiscard]] bool contains(dvec3 p) const {
    return excess(p.x * p.x + p.z * p.z, p.y, part_at(p.y)) < 0;
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const {
    if (part == lower) return p;
    if (part == upper) return {p.x, p.y - bottom, p.z};
    const double rho = std::hypot(p.x, p.z);
    const double f = rho > 0 ? (rho + beyond) / rho : 0;
    return {f * p.x, p.y - centre, f * p.z};
  }
  [[nodiscard]] dvec2 uv(dvec3 p, std::uint32_t /*part*/) const {
    const dvec3 d = glm::normalize(p - dvec3(0, 0.5 * top, 0));
    return {turn_around_y(p), 0.5 + std::asin(d.y) / std::numbers::pi};
  }

  struct Hit {
    double t;
    Part part;
  };
  struct Hits {
    Hit in;
    Hit out;
  };
  /// Where the line enters and leaves. Each end lies on one of the three parts.
  [[nodiscard]] std::optional<Hits> hits(const Ray& ray) const {
    const LineAroundY line(ray);
    Hits found{};
    bool any = false;
    const double slack = 1e-12 * (bottom + top);
    for (const Part part : {lower, middle, upper}) {
      const auto ends = body_ends(line, part);
      if (!ends) continue;
      for (const double s : {ends->x, ends->y}) {
        const double y = line.y + line.up * s;
        const bool here = part == lower    ? y <= arc_low + slack
                          : part == middle ? y >= arc_low - slack && y <= arc_high + slack
                                           : y >= arc_high - slack;
        if (!here) continue;
        const Hit hit{line.middle + s, part};
        if (!any || hit.t < found.in.t) found.in = hit;
        if (!any || hit.t > found.out.t) found.out = hit;
        any = true;
      }
    }
    if (!any || !(found.in.t < found.out.t)) return std::nullopt;
    return found;
  }
  void crossings(const Ray& ray, Crossings& out) const {
    const auto h = hits(ray);
    if (!h) return;
    out.push_back({h->in.t, 0, h->in.part, Side::enter, true});
    out.push_back({h->out.t, 0, h->out.part, Side::exit, true});
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    const auto h = hits(ray);
    if (!h) return std::nullopt;
    for (const Hit& hit : {h->in, h->out}) {
      if (hit.t >= t_from && hit.t < t_to) return Nearest{hit.t, hit.part};
    }
    return std::nullopt;
  }

 private:
  /// Both ends of the line inside of the whole body.
  [[nodiscard]] std::optional<dvec2> body_ends(const LineAroundY& line, Part part) const {
    const double y0 = part == lower ? 0 : part == upper ? bottom : centre;
    const double radius = part == lower ? bottom : part == upper ? top : arc;
    if (part == middle && arc_low >= arc_high) return std::nullopt;
    // A ball; around the arc's body, which is within it, for a start.
    const double a = line.across2 + line.up * line.up;
    const double rise = line.y - y0;
    const double s = -rise * line.up / a;
    const double gap = radius * radius - line.near2 - rise * rise * (line.across2 / a);
    if (!(gap > 0)) return std::nullopt;
    const double half = std::sqrt(gap / a);
    if (part != middle) return dvec2(s - half, s + half);
    const double in = newton(line, s - half, -1);
    const double out = newton(line, s + half, 1);
    if (!(in < out)) return std::nullopt;
    return dvec2(in, out);
  }
  /// From outside, where the slope has this sign, steps along the tangent of a convex function
  /// never go too far; past its lowest point there is nothing.
  [[nodiscard]] double newton(const LineAroundY& line, double s, double sign) const {
    for (int i = 0; i < 100; ++i) {
      const double rho2 = line.distance2(s);
      const double rho = std::sqrt(rho2);
      const double y = line.y + line.up * s;
      const double f = excess(rho2, y, middle);
      const double d_rho = rho > 0 ? line.across2 * s / rho : 0;
      const double slope = 2 * ((rho + beyond) * d_rho + (y - centre) * line.up);
      if (!(f > 0)) break;
      if (!(sign * slope > 0)) return std::numeric_limits<double>::quiet_NaN();
      const double step = f / slope;
      s -= step;
      if (std::abs(step) <= 1e-16 * std::abs(s)) break;
    }
    return s;
  }
};

std::optional<Framed<Ovus::Egg>> Ovus::shape() const {
  if (!(bottom >= 0) || !(top >= 0) || bottom + top == 0) return std::nullopt;
  Egg egg{bottom, top};
  if (top >= 2 * bottom) {
    egg.bottom = bottom;
    egg.arc_low = egg.arc_high = -no_hit_depth;
    return Framed<Egg>{egg, {}};
  }
  const double b = bottom;
  const double t = top;
  if (b > t) {
    egg.arc = 2 * b;
    egg.centre = 2 * t - b - t * t / (2 * b);
    egg.beyond = std::sqrt(b * b - egg.centre * egg.centre);
    egg.arc_low = -egg.centre;
    egg.arc_high = (b - egg.centre) * t / (egg.arc - t) + b;
  } else {
    egg.arc = 2 * t;
    egg.centre = -2 * t + b + 1.5 * t * t / b;
    egg.beyond = std::sqrt(t * t - (egg.centre - b) * (egg.centre - b));
    egg.arc_low = -egg.centre * b / (egg.arc - b);
    egg.arc_high = 2 * b - egg.centre;
  }
  return Framed<Egg>{egg, {}};
}

}  // namespace

extern constinit const PrimitiveType ovus_primitive =
    describe<Ovus>("ovus", "An egg on the y axis: its lower radius, its upper radius.");

}  // namespace durer::tracer

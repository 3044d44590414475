#include <cmath>
#include <numbers>

#include "base/roots/each_sign_change.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer {
namespace {

// Ring around the y axis (objects §10.4). Where minor > major it meets itself; the spindle around
// the axis then lies inside, but its surface is seen.
struct Torus {
  double major = 1;
  double minor = 0.25;

  static constexpr std::array params{
      positional<&Torus::major>("major", "radius of the ring"),
      positional<&Torus::minor>("minor", "radius of the tube; negative is invisible"),
  };

  static std::vector<Torus> samples() {
    return {{1, 0.25}, {5, 0.01}, {1, 0.999}, {0.5, 1}, {0.1, 1}};
  }

  struct Ring;
  [[nodiscard]] std::optional<Framed<Ring>> shape() const;
};

struct Torus::Ring {
  double major;
  double minor;

  static constexpr double far = t_far;

  [[nodiscard]] Bounds3 bounds() const {
    const double r = major + minor;
    return {{-r, -minor, -r}, {r, minor, r}};
  }
  // Distance functions of the tube and, with the other sign, of the spindle; see on_spindle().
  [[nodiscard]] double excess(dvec3 p, double ring) const {
    const double across = std::sqrt(p.x * p.x + p.z * p.z) - ring;
    return p.y * p.y + across * across - minor * minor;
  }
  [[nodiscard]] bool contains(dvec3 p) const { return excess(p, major) <= 0; }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t /*part*/) const {
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (rho <= epsilon) return p;
    return p - major / rho * dvec3(p.x, 0, p.z);
  }

  [[nodiscard]] dvec2 uv(dvec3 p, std::uint32_t /*part*/) const {
    constexpr double turn = 2 * std::numbers::pi;
    const double around = std::atan2(p.z, p.x) / turn;
    const double across = std::atan2(p.y, std::sqrt(p.x * p.x + p.z * p.z) - major) / turn;
    return {0.5 - around, 0.5 + across};
  }

  // The quartic is the product of both excesses; its root belongs to the one that vanishes.
  [[nodiscard]] bool on_spindle(dvec3 p) const {
    return minor > major && std::abs(excess(p, -major)) < std::abs(excess(p, major));
  }

  // Two Newton steps on the distance itself: the quartic's coefficients lose digits for thin rings.
  [[nodiscard]] double polished(double s, dvec3 p, dvec3 d) const {
    for (int i = 0; i < 2; ++i) {
      const dvec3 q = p + s * d;
      const double rho = std::sqrt(q.x * q.x + q.z * q.z);
      if (rho < epsilon) break;
      const double ring = on_spindle(q) ? -major : major;
      const double slope = 2 * ((rho - ring) * (q.x * d.x + q.z * d.z) / rho + q.y * d.y);
      const double step = excess(q, ring) / slope;
      if (!(std::abs(step) < 1e-3 * minor)) break;
      s -= step;
    }
    return s;
  }

  /// Calls f(t, p) for the crossings of the line, ascending, until it returns false: all of those
  /// between `t_from` and `t_to`, and perhaps others. Tangent lines miss.
  // Measured in true length from the point of the line nearest to the centre, so that the cubic
  // term vanishes and nothing grows with the distance of the ray's origin. The equation is
  // (|q|² + R² - r²)² = 4 R² (x² + z²), q = p + s d.
  template <typename F>
  void each_crossing(const Ray& ray, double t_from, double t_to, F&& f) const {
    const double length = glm::length(ray.d);
    const dvec3 d = ray.d / length;
    const double middle = -glm::dot(ray.o, d);
    const dvec3 p = ray.o + middle * d;
    const double p2 = glm::dot(p, p);
    const double reach = major + minor;
    const double slack = 1e-3 * minor;
    const double half2 = reach * reach - p2;
    if (!(half2 > 0)) return;
    double hi = std::sqrt(half2) + slack;
    double lo = -hi;
    if (std::abs(d.y) > epsilon) {  // the slab |y| <= r
      const double mid = -p.y / d.y;
      const double half = std::abs(minor / d.y) + slack;
      lo = std::max(lo, mid - half);
      hi = std::min(hi, mid + half);
    } else if (std::abs(p.y) > minor) {
      return;
    }
    lo = std::max(lo, t_from * length - middle - slack);
    hi = std::min(hi, t_to * length - middle + slack);
    if (!(lo < hi)) return;
    const double rr = major * major;
    const double k = p2 - rr - minor * minor;
    const Polynomial<4> quartic{1, 0, 2 * (k + 2 * rr * d.y * d.y), 8 * rr * p.y * d.y,
                                k * k + 4 * rr * (p.y * p.y - minor * minor)};
    each_sign_change<4>(quartic, lo, hi, [&](double root) {
      const double s = polished(root, p, d);
      return f((middle + s) / length, p + s * d);
    });
  }

  /// What lies outside of the plane that touches the ring, on its outside, near the apex.
  [[nodiscard]] bool misses(const ShaftHull& hull) const {
    const dvec3 m = normal(hull.apex, 0);
    const double support = major * std::sqrt(m.x * m.x + m.z * m.z) + minor * glm::length(m);
    return hull.beyond(dvec3(0.0), m, support);
  }

  void crossings(const Ray& ray, Crossings& out) const {
    bool inside = false;
    each_crossing(ray, -far, far, [&](double t, dvec3 p) {
      if (on_spindle(p)) {
        out.push_back({.t = t, .side = Side::sheet});
        return true;
      }
      inside = !inside;
      out.push_back({.t = t, .side = inside ? Side::enter : Side::exit});
      return true;
    });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    std::optional<Nearest> best;
    each_crossing(ray, t_from, t_to, [&](double t, dvec3 /*p*/) {
      if (t >= t_from && t < t_to) best = Nearest{t, 0};
      return !best;
    });
    return best;
  }
};

std::optional<Framed<Torus::Ring>> Torus::shape() const {
  if (!(major >= 0) || !(minor > 0)) return std::nullopt;
  return Framed<Ring>{{major, minor}, {}};
}

}  // namespace

extern constinit const PrimitiveType torus_primitive =
    describe<Torus>("torus", "A ring around the y axis: its radius, radius of the tube.");

}  // namespace durer::tracer

#include <algorithm>
#include <array>
#include <cmath>

#include "tracer/accel/box_tree.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer {
namespace {

/// A norm and its derivatives: (a^p + b^p)^(1/p) for a, b >= 0; p may be infinite.
struct Norm {
  double value;
  double da;
  double db;
};
Norm norm(double a, double b, double p) {
  const bool swap = a < b;
  const double large = swap ? b : a;
  const double small = swap ? a : b;
  if (!(large > 0)) return {0, 1, 1};
  const double ratio = small / large;
  const double power = std::pow(ratio, p);  // 0 for p = ∞ and ratio < 1
  const double root = std::pow(1 + power, 1 / p);
  const double d_large = root / (1 + power);
  const double d_small = ratio > 0 ? d_large * power / ratio : (p > 1 ? 0 : d_large);
  return {large * root, swap ? d_small : d_large, swap ? d_large : d_small};
}

// A ball in a norm that is one thing across the z axis and another along it (objects §10.5).
struct Superellipsoid {
  dvec2 exponents{1, 1};

  static constexpr std::array params{
      positional<&Superellipsoid::exponents>("exponents",
                                             "exponents, around the z axis and along it"),
  };
  static std::vector<Superellipsoid> samples() {
    return {{{1, 1}}, {{0.25, 0.5}}, {{1.5, 0.7}}, {{0.1, 0.1}}, {{2, 2}}, {{2.5, 3}}, {{0, 0.3}}};
  }

  static constexpr double far = t_far;
  static constexpr double size = 1.0001;  // of the box (objects §7)

  [[nodiscard]] Bounds3 bounds() const { return {dvec3(-size), dvec3(size)}; }
  [[nodiscard]] double around() const { return 2 / exponents.x; }
  [[nodiscard]] double along() const { return 2 / exponents.y; }
  [[nodiscard]] bool convex_shape() const { return exponents.x <= 2 && exponents.y <= 2; }

  /// Less than 0 inside, and its derivative along the line.
  struct Slope {
    double value;
    double slope;
  };
  [[nodiscard]] Slope excess(const Ray& ray, double t) const {
    const dvec3 p = ray.at(t);
    const Norm xy = norm(std::abs(p.x), std::abs(p.y), around());
    const Norm all = norm(xy.value, std::abs(p.z), along());
    // How fast |x|, |y| and |z| grow.
    const dvec3 grows(std::copysign(1.0, p.x) * ray.d.x, std::copysign(1.0, p.y) * ray.d.y,
                      std::copysign(1.0, p.z) * ray.d.z);
    return {all.value - 1, all.da * (xy.da * grows.x + xy.db * grows.y) + all.db * grows.z};
  }
  [[nodiscard]] bool contains(dvec3 p) const { return excess({p, dvec3(0.0)}, 0).value < epsilon; }

  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t /*part*/) const {
    const dvec3 a(std::abs(p.x), std::abs(p.y), std::abs(p.z));
    const double along_z = std::pow(a.z, along());
    const double large = std::max(a.x, a.y);
    const double ratio = large > 0 ? std::pow(std::min(a.x, a.y) / large, around()) : 0;
    const double wx = a.x >= a.y ? 1 : ratio;
    const double wy = a.x >= a.y ? ratio : 1;
    dvec3 n(0.0);
    if (p.x != 0) n.x = (1 - along_z) * wx / p.x;
    if (p.y != 0) n.y = (1 - along_z) * wy / p.y;
    if (p.z != 0) n.z = (1 + ratio) * along_z / p.z;
    return n == dvec3(0.0) ? p : n;
  }

  /// Calls f(t) for every crossing, ascending, until it returns false.
  template <typename F>
  void each_crossing(const Ray& ray, F&& f) const {
    double t_in = -no_hit_depth;
    double t_out = no_hit_depth;
    constexpr double room = 1.01;
    if (!BoxTree::clip({dvec3(-room), dvec3(room)}, ray.o, 1.0 / ray.d, t_in, t_out)) return;
    if (convex_shape()) {
      search(ray, t_in, t_out, f);
      return;
    }
    // Between these planes the surface has neither edges nor dents.
    std::array<double, 11> stops{};
    std::size_t n = 0;
    stops[n++] = t_in;
    const dvec3 o = ray.o;
    const dvec3 d = ray.d;
    const std::array<dvec2, 9> planes = {{{o.x, d.x},
                                          {o.y, d.y},
                                          {o.z, d.z},
                                          {o.x + o.y, d.x + d.y},
                                          {o.x - o.y, d.x - d.y},
                                          {o.x + o.z, d.x + d.z},
                                          {o.x - o.z, d.x - d.z},
                                          {o.y + o.z, d.y + d.z},
                                          {o.y - o.z, d.y - d.z}}};
    for (const dvec2 plane : planes) {
      const double t = -plane.x / plane.y;
      if (t > t_in && t < t_out) stops[n++] = t;
    }
    std::sort(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(n));
    stops[n++] = t_out;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      if (!search(ray, stops[i], stops[i + 1], f)) return;
    }
  }
  void crossings(const Ray& ray, Crossings& out) const {
    bool inside = false;
    each_crossing(ray, [&](double t) {
      inside = !inside;
      out.push_back({t, 0, 0, inside ? Side::enter : Side::exit, true});
      return true;
    });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    std::optional<Nearest> best;
    each_crossing(ray, [&](double t) {
      if (t >= t_from && t < t_to) best = Nearest{t, 0};
      return t < t_from;
    });
    return best;
  }

 private:
  /// The sign changes in [a, b], where the excess has one extremum at most, none if the ends
  /// differ: in the convex case it is a valley.
  template <typename F>
  bool search(const Ray& ray, double a, double b, F& f) const {
    Slope at_a = excess(ray, a);
    Slope at_b = excess(ray, b);
    const bool inside_a = at_a.value < 0;
    if (inside_a != (at_b.value < 0)) return f(root(ray, a, b, inside_a));
    if (!convex_shape()) {  // slopes of this side of the edges
      const double step = 1e-7 * (b - a);
      at_a = excess(ray, a + step);
      at_b = excess(ray, b - step);
    }
    // Towards the extremum, as long as the far side may lie beyond the surface.
    const double sign = inside_a ? -1 : 1;
    if (!(sign * at_a.slope < 0) || !(sign * at_b.slope > 0)) return true;
    double lo = a;
    double hi = b;
    Slope at_lo = at_a;
    Slope at_hi = at_b;
    for (int i = 0; i < 60; ++i) {
      // Tangents bound a valley from below.
      const double cut = (at_hi.value - at_lo.value + at_lo.slope * lo - at_hi.slope * hi) /
                         (at_lo.slope - at_hi.slope);
      const double floor = at_lo.value + at_lo.slope * (cut - lo);
      if (convex_shape() && !(floor < 0)) return true;
      double t = cut;
      const double margin = 0.05 * (hi - lo);
      if (!(t > lo + margin && t < hi - margin))
        t = i % 2 == 0 ? std::clamp(t, lo + margin, hi - margin) : 0.5 * (lo + hi);
      if (!(t > lo && t < hi)) t = 0.5 * (lo + hi);
      const Slope at_t = excess(ray, t);
      if ((at_t.value < 0) != inside_a) {
        return f(root(ray, a, t, inside_a)) && f(root(ray, t, b, !inside_a));
      }
      if (hi - lo < 1e-12 * (1 + std::abs(hi))) break;
      if (sign * at_t.slope < 0) {
        lo = t, at_lo = at_t;
      } else {
        hi = t, at_hi = at_t;
      }
    }
    return true;
  }

  /// The sign change between a and b: Newton steps, halving where they would leave the bracket.
  [[nodiscard]] double root(const Ray& ray, double a, double b, bool inside_a) const {
    double t = 0.5 * (a + b);
    for (int i = 0; i < 100; ++i) {
      const Slope at = excess(ray, t);
      if (at.value == 0) return t;
      ((at.value < 0) == inside_a ? a : b) = t;
      double next = t - at.value / at.slope;
      if (!(next > a && next < b)) next = 0.5 * (a + b);
      const double step = std::abs(next - t);
      t = next;
      if (step <= 4e-16 * std::abs(t)) break;
    }
    return t;
  }
};

}  // namespace

extern constinit const PrimitiveType superellipsoid_primitive = describe<Superellipsoid>(
    "superellipsoid", "Between ball, box, cylinder and star: its exponents around and along z.");

}  // namespace durer::tracer

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/roots/quadratic.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer {
namespace {

// A x² + B y² + C z² + D xy + E xz + F yz + G x + H y + I z + J = 0; inside where the left side is
// not positive (objects §12.2).
struct Quadric {
  dvec3 squares{1.0};    // A B C
  dvec3 products{0.0};   // D E F
  dvec3 linear{0.0};     // G H I
  double constant = -1;  // J

  static constexpr std::array params{
      positional<&Quadric::squares>("squares", "factors of x², y², z²"),
      positional<&Quadric::products>("products", "factors of xy, xz, yz"),
      positional<&Quadric::linear>("linear", "factors of x, y, z"),
      positional<&Quadric::constant>("constant", "constant term"),
  };

  static std::vector<Quadric> samples() {
    return {{dvec3(1), dvec3(0), dvec3(0), -1},
            {{1, 2, 3}, {0.5, 0, 0.2}, {0, 1, 0}, -1},
            {{1, 0, 1}, dvec3(0), {0, -1, 0}, 0},
            {{1, -1, 1}, dvec3(0), dvec3(0), -0.5}};
  }

  [[nodiscard]] double value(dvec3 p) const {
    return glm::dot(squares, p * p) + products.x * p.x * p.y + products.y * p.x * p.z +
           products.z * p.y * p.z + glm::dot(linear, p) + constant;
  }
  [[nodiscard]] dvec3 gradient(dvec3 p) const {
    return 2.0 * squares * p + linear +
           dvec3(products.x * p.y + products.y * p.z, products.x * p.x + products.z * p.z,
                 products.y * p.x + products.z * p.y);
  }
  /// The quadratic part as a bilinear form.
  [[nodiscard]] double curvature(dvec3 d) const {
    return glm::dot(squares, d * d) + products.x * d.x * d.y + products.y * d.x * d.z +
           products.z * d.y * d.z;
  }

  static constexpr double far = t_far;

  /// Ellipsoids along the axes are bounded; everything else may reach anywhere.
  [[nodiscard]] Bounds3 bounds() const {
    if (products != dvec3(0.0) || !(squares.x > 0) || !(squares.y > 0) || !(squares.z > 0)) {
      return Bounds3::everything();
    }
    const dvec3 centre = -0.5 * linear / squares;
    const double level = -value(centre);
    if (!(level > 0)) return {};
    const dvec3 half(std::sqrt(level / squares.x), std::sqrt(level / squares.y),
                     std::sqrt(level / squares.z));
    return {centre - half, centre + half};
  }
  /// Without mixed terms, each coordinate is bounded by what the others can be at least.
  [[nodiscard]] Bounds3 inside_within(Bounds3 box) const {
    if (products != dvec3(0.0)) return box;
    for (int i = 0; i < 3; ++i) {
      const double rest =
          constant + least(box, (i + 1) % 3) + least(box, (i + 2) % 3);  // -infinity: unbounded
      const double a = squares[i];
      const double b = linear[i];
      if (!std::isfinite(rest) || a < 0 || (a == 0 && b == 0)) continue;
      if (a == 0) {
        (b > 0 ? box.hi : box.lo)[i] =
            b > 0 ? std::min(box.hi[i], -rest / b) : std::max(box.lo[i], -rest / b);
        continue;
      }
      const double under_root = b * b - 4 * a * rest;
      if (!(under_root >= 0)) return {};
      const double half = std::sqrt(under_root) / (2 * a);
      box.lo[i] = std::max(box.lo[i], -b / (2 * a) - half);
      box.hi[i] = std::min(box.hi[i], -b / (2 * a) + half);
    }
    return box;
  }
  /// The least of a x² + b x along one side of the box.
  [[nodiscard]] double least(const Bounds3& box, int i) const {
    const double a = squares[i];
    const double b = linear[i];
    const auto at = [&](double x) {
      if (std::abs(x) < unbounded) return x * (a * x + b);
      const double slope = a != 0 ? a : x > 0 ? b : -b;
      return slope == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), slope);
    };
    double best = std::min(at(box.lo[i]), at(box.hi[i]));
    const double turn = -b / (2 * a);
    if (a > 0 && turn > box.lo[i] && turn < box.hi[i]) best = std::min(best, at(turn));
    return best;
  }
  [[nodiscard]] bool contains(dvec3 p) const { return value(p) <= 0; }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t /*part*/) const {
    const dvec3 g = gradient(p);
    return g == dvec3(0.0) ? dvec3(1, 0, 0) : g;
  }

  [[nodiscard]] bool begins_inside(const Ray& ray) const {
    const double a = curvature(ray.d);
    if (a != 0) return a < 0;
    const double b = glm::dot(gradient(ray.o), ray.d);
    return b != 0 ? b > 0 : contains(ray.o);
  }
  void crossings(const Ray& ray, Crossings& out) const {
    bool inside = begins_inside(ray);
    for (const double t :
         quadratic_roots(curvature(ray.d), glm::dot(gradient(ray.o), ray.d), value(ray.o))) {
      inside = !inside;
      out.push_back({.t = t, .side = inside ? Side::enter : Side::exit});
    }
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    for (const double t :
         quadratic_roots(curvature(ray.d), glm::dot(gradient(ray.o), ray.d), value(ray.o))) {
      if (t >= t_from && t < t_to) return Nearest{t, 0};
    }
    return std::nullopt;
  }
};

}  // namespace

extern constinit const PrimitiveType quadric_primitive = [] {
  PrimitiveType type = describe<Quadric>(
      "quadric", "A surface of second degree: squares, products, linear, constant.");
  type.keeps_bounds = true;
  return type;
}();

}  // namespace durer::tracer

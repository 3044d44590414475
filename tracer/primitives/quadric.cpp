#include <cmath>

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

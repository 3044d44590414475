#include <cmath>

#include "base/roots/any_degree.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer {
namespace {

/// How many terms a polynomial of this degree in x, y, z has (objects §12.3).
constexpr std::size_t term_count(std::size_t degree) {
  return (degree + 1) * (degree + 2) * (degree + 3) / 6;
}

// The surface where a polynomial in x, y, z vanishes; inside where it is negative, with the
// oracle's tolerance (objects §12.3). Terms in the language's order: falling powers of x, for each
// falling powers of y, for each falling powers of z.
struct Poly {
  std::size_t degree = 2;
  std::vector<double> terms;

  [[nodiscard]] Bounds3 bounds() const { return Bounds3::everything(); }

  [[nodiscard]] double value(dvec3 p) const {
    const double* c = terms.data();
    double sum_x = 0;
    for (std::size_t i = degree + 1; i-- > 0;) {
      double sum_y = 0;
      for (std::size_t j = degree - i + 1; j-- > 0;) {
        double sum_z = 0;
        for (std::size_t k = degree - i - j + 1; k-- > 0;) sum_z = sum_z * p.z + *c++;
        sum_y = sum_y * p.y + sum_z;
      }
      sum_x = sum_x * p.x + sum_y;
    }
    return sum_x;
  }
  [[nodiscard]] bool contains(dvec3 p) const { return value(p) < 1e-4; }

  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t /*part*/) const {
    // Powers up to the degree, then the gradient term by term.
    std::array<dvec3, max_degree + 1> power{};
    power[0] = dvec3(1.0);
    for (std::size_t i = 1; i <= degree; ++i) power[i] = power[i - 1] * p;
    dvec3 g(0.0);
    const double* c = terms.data();
    for (std::size_t i = degree + 1; i-- > 0;) {
      for (std::size_t j = degree - i + 1; j-- > 0;) {
        for (std::size_t k = degree - i - j + 1; k-- > 0;) {
          const double f = *c++;
          if (f == 0) continue;
          if (i > 0) g.x += f * static_cast<double>(i) * power[i - 1].x * power[j].y * power[k].z;
          if (j > 0) g.y += f * static_cast<double>(j) * power[i].x * power[j - 1].y * power[k].z;
          if (k > 0) g.z += f * static_cast<double>(k) * power[i].x * power[j].y * power[k - 1].z;
        }
      }
    }
    return g == dvec3(0.0) ? dvec3(1, 0, 0) : g;
  }

  /// sum := sum · (o + s d), powers of s rising; `count` coefficients become count + 1.
  static void times_linear(std::array<double, max_degree + 2>& sum, std::size_t count, double o,
                           double d) {
    sum[count] = 0;
    for (std::size_t i = count; i > 0; --i) sum[i] = sum[i] * o + sum[i - 1] * d;
    sum[0] *= o;
  }

  /// The polynomial along p + s d, by Horner's rule in all three variables.
  [[nodiscard]] AnyPolynomial along(dvec3 p, dvec3 d) const {
    using Sum = std::array<double, max_degree + 2>;
    const double* c = terms.data();
    Sum sum_x{};
    std::size_t nx = 0;
    for (std::size_t i = degree + 1; i-- > 0;) {
      Sum sum_y{};
      std::size_t ny = 0;
      for (std::size_t j = degree - i + 1; j-- > 0;) {
        Sum sum_z{};
        std::size_t nz = 0;
        for (std::size_t k = degree - i - j + 1; k-- > 0;) {
          if (nz > 0) times_linear(sum_z, nz, p.z, d.z);
          sum_z[0] += *c++;
          ++nz;
        }
        if (ny > 0) times_linear(sum_y, ny, p.y, d.y);
        ny = std::max(ny + 1, nz);
        for (std::size_t m = 0; m < nz; ++m) sum_y[m] += sum_z[m];
      }
      if (nx > 0) times_linear(sum_x, nx, p.x, d.x);
      nx = std::max(nx + 1, ny);
      for (std::size_t m = 0; m < ny; ++m) sum_x[m] += sum_y[m];
    }
    AnyPolynomial out;
    out.degree = degree;
    for (std::size_t m = 0; m <= degree; ++m) out.c[m] = sum_x[degree - m];
    return out;
  }

  /// The line measured in true length from its point nearest to the local origin, where the
  /// coefficients are smallest.
  struct Line {
    double length;
    double middle;
    AnyPolynomial p;
    bool solid;  // false: constant along the line
  };
  [[nodiscard]] Line line(const Ray& ray) const {
    Line l;
    l.length = glm::length(ray.d);
    const dvec3 d = ray.d / l.length;
    l.middle = -glm::dot(ray.o, d);
    l.p = along(ray.o + l.middle * d, d);
    l.solid = l.p.trim();
    return l;
  }

  [[nodiscard]] bool begins_inside(const Ray& ray) const {
    const Line l = line(ray);
    if (!l.solid) return l.p.c[0] < 0;
    return (l.p.degree % 2 == 0) == (l.p.c[0] < 0);
  }
  void crossings(const Ray& ray, Crossings& out) const {
    const Line l = line(ray);
    if (!l.solid) return;
    bool inside = (l.p.degree % 2 == 0) == (l.p.c[0] < 0);
    const double reach = l.p.root_bound();
    for (const double s : sign_changes(l.p, -reach, reach)) {
      inside = !inside;
      out.push_back({.t = (l.middle + s) / l.length, .side = inside ? Side::enter : Side::exit});
    }
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    const Line l = line(ray);
    if (!l.solid) return std::nullopt;
    const double reach = l.p.root_bound();
    // Roots nearer than 1e-4 in local units are not seen (objects §3).
    const double lo = std::max(std::max(t_from * l.length, 1e-4) - l.middle, -reach);
    if (!(lo < std::min(t_to * l.length - l.middle, reach))) return std::nullopt;
    // Not up to t_to: the last bits of a root must not depend on what was hit before.
    const Roots<max_degree> roots = sign_changes(l.p, lo, reach);
    if (roots.count == 0) return std::nullopt;
    const double t = (l.middle + roots.values[0]) / l.length;
    if (!(t < t_to)) return std::nullopt;
    return Nearest{t, 0};
  }
};

// The operands are the degree and as many terms as it takes; the language writes them in four ways
// (`poly`, `cubic`, `quartic`, `polynomial`), so the interpreter reads them itself.
constexpr std::array<scene::Param, 1> poly_params = {
    scene::Param{"degree", scene::ArgKind::number, "degree, 2 to 35"}};

std::optional<std::string> poly_problem(std::span<const double> args) {
  if (args.empty() || !(args[0] >= 2 && args[0] <= static_cast<double>(max_degree))) {
    return "the degree of a polynomial surface is 2 to 35";
  }
  return std::nullopt;
}

std::optional<ShapeRef> place_poly(TypeStores& stores, std::span<const double> args,
                                   const Transform& to_world, bool inverted) {
  Poly p;
  p.degree = static_cast<std::size_t>(args[0]);
  p.terms.assign(args.begin() + 1, args.end());
  p.terms.resize(term_count(p.degree));
  return place_shape(stores, std::move(p), to_world, inverted);
}

std::vector<std::vector<double>> poly_samples() {
  const auto sphere = std::vector<double>{2, 1, 0, 0, 0, 1, 0, 0, 1, 0, -1};
  std::vector<double> quartic(36);  // x⁴ + y⁴ + z⁴ - 1
  quartic[0] = 4;
  quartic[1] = quartic[21] = quartic[31] = 1;
  quartic[35] = -1;
  return {sphere, quartic};
}

constexpr PrimitiveType describe_poly() {
  PrimitiveType type;
  type.name = "poly";
  type.doc = "A surface of any degree from 2 to 35, by its terms.";
  type.params = poly_params;
  type.open_ended = true;
  type.keeps_bounds = true;
  type.validate = poly_problem;
  type.make_stores = [] { return make_type_stores<Poly>(); };
  type.place = place_poly;
  type.samples = poly_samples;
  return type;
}

}  // namespace

extern constinit const PrimitiveType poly_primitive = describe_poly();

}  // namespace durer::tracer

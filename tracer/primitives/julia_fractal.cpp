#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tracer/accel/box_tree.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/julia_set.h"

namespace durer::tracer {
namespace {

// A three-dimensional slice of a Julia set (objects §10.12). There is no equation to solve: rays
// walk in steps that the orbit says are safe, or at least as wide as `precision` tells. What is
// thinner than that may be missed, as the oracle does.
struct JuliaFractal {
  JuliaSet set;

  [[nodiscard]] Bounds3 bounds() const { return {dvec3(-set.radius), dvec3(set.radius)}; }
  [[nodiscard]] bool contains(dvec3 p) const {
    return glm::dot(p, p) <= set.radius * set.radius && set.contains(p);
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t /*part*/) const { return set.normal(p); }

  /// Calls f(t, entering, visible) for every crossing from t = from on, until it returns false.
  /// Where the set is larger than the ball around it, it is cut off, and open.
  template <typename F>
  void each_crossing(const Ray& ray, double from, double to, F&& f) const {
    const double length = glm::length(ray.d);
    const dvec3 d = ray.d / length;
    const double middle = -glm::dot(ray.o, d);
    const dvec3 nearest = ray.o + middle * d;
    const double half2 = set.radius * set.radius - glm::dot(nearest, nearest);
    if (!(half2 > 0)) return;
    const double end = middle + std::sqrt(half2);
    const double enough = to * length;  // steps do not depend on it, only how many there are
    double s = std::max(middle - std::sqrt(half2), from * length);
    if (!(s < end)) return;
    constexpr double least = 1e-7;
    JuliaSet::Look look = set.look(ray.o + s * d, d);
    if (look.inside) {
      const double start = s;
      s += 2 * least;
      look = set.look(ray.o + s * d, d);
      if (look.inside && !f(start / length, true, false)) return;
    }
    while (s < enough) {
      const double before = s;
      s += look.step;
      if (s > end) {
        if (look.inside) f(end / length, false, false);
        return;
      }
      const bool was_inside = look.inside;
      look = set.look(ray.o + s * d, d);
      if (look.inside == was_inside) continue;
      if (!f(boundary(ray.o, d, before, s, was_inside) / length, look.inside, true)) return;
    }
  }
  void crossings(const Ray& ray, Crossings& out) const {
    each_crossing(ray, -no_hit_depth, no_hit_depth, [&](double t, bool enters, bool visible) {
      out.push_back({t, 0, 0, enters ? Side::enter : Side::exit, visible});
      return true;
    });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    std::optional<Nearest> best;
    each_crossing(ray, 1e-7 / glm::length(ray.d), t_to, [&](double t, bool, bool visible) {
      if (!visible) return true;
      if (t >= t_from && t < t_to) best = Nearest{t, 0};
      return t < t_from;
    });
    return best;
  }

 private:
  /// Where the set begins or ends between a and b: the end that lies inside.
  [[nodiscard]] double boundary(dvec3 o, dvec3 d, double a, double b, bool inside_a) const {
    while (b - a > 1e-7) {
      const double s = 0.5 * (a + b);
      (set.contains(o + s * d) == inside_a ? a : b) = s;
    }
    return inside_a ? a : b;
  }
};

/// Operands as the interpreter lays them out.
enum : std::size_t {
  c_at,
  hyper_at = 4,
  function_at,
  power_at,
  iterations_at = 8,
  precision_at,
  slice_at,
  distance_at = 14,
  all_of_it
};

constexpr std::array julia_params = {
    scene::Param{"real", scene::ArgKind::number, "first component of the parameter"},
    scene::Param{"imaginary", scene::ArgKind::vector, "the other components"},
    scene::Param{"hypercomplex", scene::ArgKind::number, "1: numbers are not quaternions"},
    scene::Param{"function", scene::ArgKind::number, "what is iterated"},
    scene::Param{"power", scene::ArgKind::vector2, "exponent of `pwr`"},
    scene::Param{"max_iteration", scene::ArgKind::number, "after how many steps a point is inside"},
    scene::Param{"precision", scene::ArgKind::number, "the smallest step is one over this"},
    scene::Param{"slice", scene::ArgKind::vector, "normal of the slice, first three components"},
    scene::Param{"slice_w", scene::ArgKind::number, "its fourth"},
    scene::Param{"slice_distance", scene::ArgKind::number, "its distance from the origin"}};

std::optional<std::string> julia_problem(std::span<const double> args) {
  if (args[slice_at + 3] == 0) return "the fourth component of `slice` must not be 0";
  if (args[hyper_at] == 0 && args[function_at] > 1) {
    return "quaternions take `sqr` and `cube` only; the others need `hypercomplex`";
  }
  return std::nullopt;
}

JuliaSet set_of(std::span<const double> args) {
  JuliaSet set;
  set.c = {args[c_at], args[c_at + 1], args[c_at + 2], args[c_at + 3]};
  set.hypercomplex = args[hyper_at] != 0;
  set.function = static_cast<JuliaFunction>(args[function_at]);
  set.power = {args[power_at], args[power_at + 1]};
  set.iterations = static_cast<std::uint32_t>(std::clamp(args[iterations_at], 1.0, 1e9));
  set.smallest_step = 1 / std::max(args[precision_at], 1.0);
  const dvec3 slice(args[slice_at], args[slice_at + 1], args[slice_at + 2]);
  const double w = args[slice_at + 3];
  const double length = std::sqrt(glm::dot(slice, slice) + w * w);
  set.slice = -slice / w;
  set.slice_at = args[distance_at] * length / w;
  if (set.hypercomplex) {
    set.radius = 4;
    set.escape2 = 16;
  } else {
    set.radius = std::min(2.0, 1 + std::sqrt(norm2(set.c)) + 1e-7);
    set.escape2 = set.radius * set.radius + 1e-7;
  }
  return set;
}

constexpr PrimitiveType describe_julia_fractal() {
  PrimitiveType type;
  type.name = "julia_fractal";
  type.doc = "A slice of a Julia set of quaternions or hypercomplex numbers.";
  type.params = julia_params;
  type.sides_by_order = true;
  type.validate = julia_problem;
  type.make_stores = [] { return make_type_stores<JuliaFractal>(); };
  type.place = [](TypeStores& stores, std::span<const double> args, const Transform& to_world,
                  bool inverted) -> std::optional<ShapeRef> {
    return place_shape(stores, JuliaFractal{set_of(args)}, to_world, inverted);
  };
  type.hit_tolerance = 1e-6;
  type.samples = [] {
    // Smooth ones: of others the steps may miss parts.
    return std::vector<std::vector<double>>{{0, 0, 0, 0, 0, 0, 0, 0, 12, 20, 0, 0, 0, 1, 0},
                                            {0.1, 0, 0, 0, 0, 0, 0, 0, 12, 50, 0, 0, 0, 1, 0.3},
                                            {0, 0, 0, 0, 0, 1, 0, 0, 12, 20, 0.2, 0.1, 0, 1, 0}};
  };
  return type;
}

}  // namespace

extern constinit const PrimitiveType julia_fractal_primitive = describe_julia_fractal();

}  // namespace durer::tracer

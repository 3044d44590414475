#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tracer/accel/box_tree.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/julia_lanes.h"
#include "tracer/primitives/julia_orbit.h"

namespace durer::tracer {
namespace {

/// Looks along one line. Near the set steps are small and the same: then several are looked at
/// together, before it is known that they will be taken.
class JuliaLine {
 public:
  /// `d` is of unit length.
  JuliaLine(const JuliaSet& set, dvec3 o, dvec3 d) : set_(set), o_(o), d_(d) {}

  /// At o + s · d, `last` being the step that led there.
  [[nodiscard]] JuliaSet::Look look(double s, double last) {
    if (next_ < julia_lanes && ahead_[next_] == s) return ahead(next_++);
    if (last != set_.smallest_step || !set_.is_polynomial()) return set_.look(o_ + s * d_, d_);
    for (double& at : ahead_) {
      at = s;
      s += last;
    }
    julia_orbits(set_, o_, d_, ahead_, orbits_);
    next_ = 1;
    return ahead(0);
  }

  /// Where the set begins or ends between a and b: the end that lies inside.
  [[nodiscard]] double boundary(double a, double b, bool inside_a) const {
    if (!set_.is_polynomial()) {
      while (b - a > nearness) {
        const double s = 0.5 * (a + b);
        (set_.contains(o_ + s * d_) == inside_a ? a : b) = s;
      }
      return inside_a ? a : b;
    }
    while (b - a > nearness) halve_thrice(a, b, inside_a);
    return inside_a ? a : b;
  }

 private:
  static constexpr double nearness = 1e-7;

  [[nodiscard]] JuliaSet::Look ahead(std::size_t i) const {
    const double escape = orbits_.escape[i];
    if (escape < 0) return {true, set_.smallest_step};
    const auto step = static_cast<std::uint32_t>(escape);
    if (!set_.hypercomplex) {
      return {false, set_.step_quaternion(step, orbits_.product[0][i], orbits_.q[0][i])};
    }
    const auto number = [i](const std::array<JuliaOrbits::Lanes, 4>& of) {
      return four(HypercomplexOrbit<double>{of[0][i], of[1][i], of[2][i], of[3][i]});
    };
    return {false, set_.step_hypercomplex(step, number(orbits_.product), number(orbits_.q), d_)};
  }

  /// All that three halvings may ask for is found at once: node n of the tree of middles has the
  /// halves 2n and 2n + 1.
  void halve_thrice(double& a, double& b, bool inside_a) const {
    JuliaOrbits::Lanes middle{};
    std::array<double, julia_lanes> low{};
    std::array<double, julia_lanes> high{};
    low[1] = a;
    high[1] = b;
    for (std::size_t n = 1; n < julia_lanes; ++n) {
      middle[n] = 0.5 * (low[n] + high[n]);
      if (2 * n >= julia_lanes) continue;
      low[2 * n] = low[n];
      high[2 * n] = low[2 * n + 1] = middle[n];
      high[2 * n + 1] = high[n];
    }
    middle[0] = middle[1];
    const unsigned inside = julia_contains(set_, o_, d_, middle);
    for (std::size_t n = 1; n < julia_lanes && b - a > nearness;) {
      const bool beyond = ((inside >> n & 1U) != 0) == inside_a;
      (beyond ? a : b) = middle[n];
      n = 2 * n + (beyond ? 1 : 0);
    }
  }

  const JuliaSet& set_;
  dvec3 o_;
  dvec3 d_;
  JuliaOrbits::Lanes ahead_;
  JuliaOrbits orbits_;
  std::size_t next_ = julia_lanes;  // in `ahead_`: what may be asked for next
};

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
    JuliaLine line(set, ray.o, d);
    JuliaSet::Look look = line.look(s, 0);
    if (look.inside) {
      const double start = s;
      s += 2 * least;
      look = line.look(s, 0);
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
      look = line.look(s, look.step);
      if (look.inside == was_inside) continue;
      if (!f(line.boundary(before, s, was_inside) / length, look.inside, true)) return;
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

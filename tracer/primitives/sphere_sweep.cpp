#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "base/roots/bernstein.h"
#include "tracer/accel/box_tree.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/shared_data.h"

namespace durer::tracer {
namespace {

enum class Path : std::uint8_t { linear, cubic, b_spline };

/// A ball on its way: Bézier coefficients of centre and radius. Straight ways have two, curves
/// four.
struct SweptBall {
  std::array<dvec3, 4> centre;
  std::array<double, 4> radius;
};

struct SweepData {
  std::vector<SweptBall> ways;
  BoxTree tree;
  Bounds3 bounds;
  dvec3 middle{0.0};
  double tolerance = 1e-6;
  bool straight = true;
};

/// Where a line is inside, and on which way each end lies.
struct Passage {
  double t_in;
  double t_out;
  std::uint32_t part_in;
  std::uint32_t part_out;
};
std::vector<Passage>& empty_passages() {
  thread_local std::vector<Passage> passages;
  passages.clear();
  return passages;
}

// Everything that a ball passes through as it moves and grows along a spline (objects §10.10). A
// line is inside where it is inside of any of the balls: for all balls that it meets in a row, that
// is from the first of their entries to the last of their exits.
struct SphereSweep {
  std::shared_ptr<const SweepData> data;

  static constexpr double far = t_far;

  [[nodiscard]] Bounds3 bounds() const { return data->bounds; }
  [[nodiscard]] bool contains(dvec3 p) const {
    bool inside = false;
    data->tree.at(p, [&](std::uint32_t i) {
      inside = inside || (data->straight ? holds<1>(data->ways[i], p) : holds<3>(data->ways[i], p));
    });
    return inside;
  }
  /// From the centre of the ball that the point lies on.
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const {
    const SweptBall& way = data->ways[part];
    return data->straight ? from_centre<1>(way, p) : from_centre<3>(way, p);
  }
  void crossings(const Ray& ray, Crossings& out) const {
    each_passage(ray, -no_hit_depth, no_hit_depth, [&](const Passage& p) {
      out.push_back({p.t_in, 0, p.part_in, Side::enter, true});
      out.push_back({p.t_out, 0, p.part_out, Side::exit, true});
      return true;
    });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    std::optional<Nearest> best;
    t_from = std::max(t_from, data->tolerance);
    each_passage(ray, t_from, t_to, [&](const Passage& p) {
      const bool ahead = p.t_in >= t_from;
      const double t = ahead ? p.t_in : p.t_out;
      if (!(t >= t_from)) return true;
      if (t < t_to) best = Nearest{t, ahead ? p.part_in : p.part_out};
      return false;
    });
    return best;
  }

 private:
  /// Calls f(passage) for those that reach into t_from…t_to, ascending, until it returns false.
  template <typename F>
  void each_passage(const Ray& ray, double t_from, double t_to, F&& f) const {
    auto& passages = empty_passages();
    data->tree.along(ray, t_from, t_to, [&](std::uint32_t i) {
      data->straight ? add_passages<1>(i, ray, passages) : add_passages<3>(i, ray, passages);
    });
    std::sort(passages.begin(), passages.end(),
              [](const Passage& a, const Passage& b) { return a.t_in < b.t_in; });
    for (std::size_t i = 0; i < passages.size();) {
      Passage all = passages[i++];
      for (; i < passages.size() && passages[i].t_in <= all.t_out; ++i) {
        if (passages[i].t_out > all.t_out) {
          all.t_out = passages[i].t_out;
          all.part_out = passages[i].part_out;
        }
      }
      if (!f(all)) return;
    }
  }

  /// The balls whose centre is nearer to the line than their radius: where a polynomial is
  /// positive.
  template <std::size_t N>
  void add_passages(std::uint32_t part, const Ray& ray, std::vector<Passage>& out) const {
    const SweptBall& way = data->ways[part];
    const double d2 = glm::dot(ray.d, ray.d);
    const double start = glm::dot(data->middle - ray.o, ray.d) / d2;
    const dvec3 o = ray.at(start);
    Bernstein<N> along{};
    Bernstein<2 * N> depth{};  // half the chord, squared
    {
      std::array<Bernstein<N>, 3> beside{};
      Bernstein<N> radius{};
      for (std::size_t i = 0; i <= N; ++i) {
        const dvec3 c = way.centre[i] - o;
        const dvec3 x = glm::cross(c, ray.d);
        along[i] = glm::dot(c, ray.d) / d2;
        radius[i] = way.radius[i];
        for (int k = 0; k < 3; ++k) beside[static_cast<std::size_t>(k)][i] = x[k];
      }
      const auto r2 = product<N, N>(radius, radius);
      const auto x2 = product<N, N>(beside[0], beside[0]);
      const auto y2 = product<N, N>(beside[1], beside[1]);
      const auto z2 = product<N, N>(beside[2], beside[2]);
      bool any = false;
      for (std::size_t i = 0; i <= 2 * N; ++i) {
        depth[i] = (r2[i] - (x2[i] + y2[i] + z2[i]) / d2) / d2;
        any = any || depth[i] > 0;
      }
      if (!any) return;
    }
    const auto edges = sign_changes<2 * N>(depth);
    if (edges.count == 0 && !(depth[0] > 0)) return;
    // Where the entry or the exit comes or goes first: along' = ± (√depth)'.
    const auto speed = derivative<N>(along);
    const auto change = derivative<2 * N>(depth);
    const auto left = product<2 * N - 2, 2 * N>(product<N - 1, N - 1>(speed, speed), depth);
    auto turns = product<2 * N - 1, 2 * N - 1>(change, change);
    for (std::size_t i = 0; i < turns.size(); ++i) turns[i] = 4 * left[i] - turns[i];
    const auto extremes = sign_changes<4 * N - 2>(turns);
    // Across the line both come at the same place, where that polynomial only touches zero.
    const auto summits = sign_changes<2 * N - 1>(change);

    Passage passage{};
    bool open = false;
    const auto visit = [&](double u) {
      const double middle = value_and_slope<N>(along, u).value + start;
      const double half = std::sqrt(std::max(value_and_slope<2 * N>(depth, u).value, 0.0));
      if (!open || middle - half < passage.t_in) passage.t_in = middle - half;
      if (!open || middle + half > passage.t_out) passage.t_out = middle + half;
      open = true;
    };
    const auto close = [&] {
      if (!open) return;
      passage.part_in = passage.part_out = part;
      out.push_back(passage);
      open = false;
    };
    bool meets = depth[0] > 0;
    if (meets) visit(0);
    std::size_t e = 0;
    std::size_t m = 0;
    for (std::size_t k = 0; k <= edges.count; ++k) {
      const double until = k < edges.count ? edges.values[k] : 1;
      for (; e < extremes.count && extremes.values[e] <= until; ++e) {
        if (meets) visit(extremes.values[e]);
      }
      for (; m < summits.count && summits.values[m] <= until; ++m) {
        if (meets) visit(summits.values[m]);
      }
      if (k == edges.count) break;
      visit(until);
      if (meets) close();
      meets = !meets;
    }
    if (meets) visit(1);
    close();
  }

  /// |p - centre|² - radius².
  template <std::size_t N>
  static Bernstein<2 * N> outside(const SweptBall& way, dvec3 p) {
    std::array<Bernstein<N>, 4> x{};
    for (std::size_t i = 0; i <= N; ++i) {
      const dvec3 off = way.centre[i] - p;
      x[0][i] = off.x, x[1][i] = off.y, x[2][i] = off.z, x[3][i] = way.radius[i];
    }
    Bernstein<2 * N> sum = product<N, N>(x[0], x[0]);
    const auto y2 = product<N, N>(x[1], x[1]);
    const auto z2 = product<N, N>(x[2], x[2]);
    const auto r2 = product<N, N>(x[3], x[3]);
    for (std::size_t i = 0; i <= 2 * N; ++i) sum[i] += y2[i] + z2[i] - r2[i];
    return sum;
  }
  template <std::size_t N>
  static bool holds(const SweptBall& way, dvec3 p) {
    const auto gap = outside<N>(way, p);
    return gap[0] <= 0 || gap[2 * N] <= 0 || sign_changes<2 * N>(gap).count > 0;
  }
  template <std::size_t N>
  static dvec3 from_centre(const SweptBall& way, dvec3 p) {
    const auto gap = outside<N>(way, p);
    double best = gap[0] <= gap[2 * N] ? 0 : 1;
    double least = std::min(gap[0], gap[2 * N]);
    for (const double u : sign_changes<2 * N - 1>(derivative<2 * N>(gap))) {
      const double g = value_and_slope<2 * N>(gap, u).value;
      if (g < least) least = g, best = u;
    }
    dvec3 centre;
    for (int k = 0; k < 3; ++k) {
      Bernstein<N> c{};
      for (std::size_t i = 0; i <= N; ++i) c[i] = way.centre[i][k];
      centre[k] = value_and_slope<N>(c, best).value;
    }
    return p - centre;
  }
};

/// A centre and its radius as one point of a spline.
struct Ball {
  dvec3 centre;
  double radius;

  friend Ball operator+(Ball a, Ball b) { return {a.centre + b.centre, a.radius + b.radius}; }
  friend Ball operator-(Ball a, Ball b) { return {a.centre - b.centre, a.radius - b.radius}; }
  friend Ball operator*(double f, Ball b) { return {f * b.centre, f * b.radius}; }
};

SweptBall way_through(std::initializer_list<Ball> balls) {
  SweptBall way{};
  std::size_t i = 0;
  for (const Ball& b : balls) way.centre[i] = b.centre, way.radius[i++] = b.radius;
  return way;
}

enum : std::size_t { path_at, tolerance_at, balls_at };

constexpr std::array<scene::Param, balls_at> sphere_sweep_params = {
    scene::Param{"path", scene::ArgKind::number, "0: straight, 1: cubic_spline, 2: b_spline"},
    scene::Param{"tolerance", scene::ArgKind::number, "least depth of a hit"}};

std::vector<Ball> balls_of(std::span<const double> list) {
  std::vector<Ball> balls;
  for (std::size_t i = 0; i + 3 < list.size(); i += 4) {
    balls.push_back({{list[i], list[i + 1], list[i + 2]}, list[i + 3]});
  }
  return balls;
}

std::shared_ptr<const SweepData> sweep_of(std::span<const double> args) {
  const auto path = static_cast<Path>(args[path_at]);
  const std::vector<Ball> b = balls_of(args.subspan(balls_at));
  auto data = std::make_shared<SweepData>();
  data->tolerance = args[tolerance_at];
  data->straight = path == Path::linear;
  const std::size_t each = data->straight ? 2 : 4;
  for (std::size_t i = 0; i + each <= b.size(); ++i) {
    switch (path) {
      case Path::linear: data->ways.push_back(way_through({b[i], b[i + 1]})); break;
      case Path::cubic:
        data->ways.push_back(way_through({b[i + 1], b[i + 1] + (1.0 / 6) * (b[i + 2] - b[i]),
                                          b[i + 2] - (1.0 / 6) * (b[i + 3] - b[i + 1]), b[i + 2]}));
        break;
      case Path::b_spline: {
        const Ball third = (1.0 / 3) * b[i + 1];
        const Ball other = (1.0 / 3) * b[i + 2];
        const auto joint = [&](std::size_t k) {
          return (1.0 / 6) * (b[k] + 4 * b[k + 1] + b[k + 2]);
        };
        data->ways.push_back(
            way_through({joint(i), 2 * third + other, third + 2 * other, joint(i + 1)}));
        break;
      }
    }
  }
  // The box is the oracle's, who takes the listed balls, or twice their size.
  for (const Ball& ball : b) {
    const dvec3 r((path == Path::cubic ? 2 : 1) * ball.radius);
    data->bounds.add(ball.centre - r);
    data->bounds.add(ball.centre + r);
  }
  data->middle = 0.5 * (data->bounds.lo + data->bounds.hi);
  std::vector<Bounds3> boxes;
  for (const SweptBall& way : data->ways) {
    Bounds3 box;
    double radius = 0;
    for (std::size_t i = 0; i < each; ++i) {
      box.add(way.centre[i]);
      radius = std::max(radius, std::abs(way.radius[i]));
    }
    boxes.push_back({box.lo - dvec3(radius), box.hi + dvec3(radius)});
  }
  data->tree = BoxTree(boxes);
  return data;
}

std::optional<ShapeRef> place_sphere_sweep(TypeStores& stores, std::span<const double> args,
                                           const Transform& to_world, bool inverted) {
  return place_shape(stores, SphereSweep{shared_data<SweepData>(args, sweep_of)}, to_world,
                     inverted);
}

constexpr PrimitiveType describe_sphere_sweep() {
  PrimitiveType type;
  type.name = "sphere_sweep";
  type.doc = "What a ball passes through on its way along a spline.";
  type.params = sphere_sweep_params;
  type.open_ended = true;
  type.validate = [](std::span<const double> args) -> std::optional<std::string> {
    const std::size_t least = args[path_at] == 0 ? 2 : 4;
    const std::size_t n = (args.size() - balls_at) / 4;
    if (n >= least) return std::nullopt;
    return fmt::format("such a sweep takes {} spheres or more, here are {}", least, n);
  };
  type.make_stores = [] { return make_type_stores<SphereSweep>(); };
  type.place = place_sphere_sweep;
  type.samples = [] {
    return std::vector<std::vector<double>>{
        {0, 1e-6, 0, 0, 0, 1, 2, 0, 0, 0.5, 2, 1, 1, 0.2},
        {1, 1e-6, -1, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 0.5, 3, 1, 0, 1, 3, 2, 2, 0.3},
        {2, 1e-6, -1, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 0.5, 3, 1, 0, 1, 3, 2, 2, 0.3}};
  };
  return type;
}

}  // namespace

extern constinit const PrimitiveType sphere_sweep_primitive = describe_sphere_sweep();

}  // namespace durer::tracer

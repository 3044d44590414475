#include "tracer/primitives/parametric_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "tracer/primitives/container.h"
#include "tracer/primitives/function_field.h"
#include "tracer/primitives/shared_data.h"

namespace durer::tracer {
namespace {

/// Cells are split at most this often: what is still undecided there is a point.
constexpr int depth_limit = 24;

double square(double x) { return x * x; }

void delete_children(const PatchCell& cell) {
  const PatchCell* children = cell.children.load(std::memory_order_relaxed);
  if (children == nullptr) return;
  for (int i = 0; i < 4; ++i) delete_children(children[i]);
  delete[] children;
}

struct Bound {
  Interval range;
  std::array<Interval, 2> slope;
};

/// Bounds from samples at the corners and the steepest slope allowed, for functions that cannot be
/// bounded otherwise.
Bound sampled_bound(const functions::Function& f, dvec2 centre, dvec2 half, double steepest,
                    functions::Workspace& w) {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -lo;
  for (const double u : {centre.x - half.x, centre.x + half.x}) {
    for (const double v : {centre.y - half.y, centre.y + half.y}) {
      const double x = functions::evaluate(f, std::array{u, v}, w);
      lo = std::min(lo, x);
      hi = std::max(hi, x);
    }
  }
  const double margin = steepest * (half.x + half.y);
  return {{lo - margin, hi + margin}, {Interval{-steepest, steepest}, {-steepest, steepest}}};
}

Bound bound_over(const functions::Function& f, dvec2 centre, dvec2 half, functions::Workspace& w) {
  const std::array<Interval, 2> box{Interval{centre.x - half.x, centre.x + half.x},
                                    Interval{centre.y - half.y, centre.y + half.y}};
  const Trend t = functions::evaluate_trend(f, box, w);
  return {t.range(), {t.slope(0), t.slope(1)}};
}

}  // namespace

ParametricData::ParametricData(std::shared_ptr<const scene::Parametric> surface,
                               functions::NoiseGenerator generator)
    : surface_(std::move(surface)), generator_(generator) {
  for (std::size_t i = 0; i < 3; ++i) {
    has_bounds_[i] = can_be_bounded(*surface_->functions[i]);
  }
  examine(root_, (surface_->from + surface_->to) * 0.5, (surface_->to - surface_->from) * 0.5);
}

ParametricData::~ParametricData() { delete_children(root_); }

dvec3 ParametricData::point(dvec2 uv) const {
  functions::Workspace& w = function_workspace(generator_);
  const std::array place{uv.x, uv.y};
  return {functions::evaluate(*surface_->functions[0], place, w),
          functions::evaluate(*surface_->functions[1], place, w),
          functions::evaluate(*surface_->functions[2], place, w)};
}

ParametricData::Place ParametricData::at(dvec2 uv) const {
  functions::Workspace& w = function_workspace(generator_);
  const std::array<Dual, 2> place{Dual(uv.x, {1, 0, 0}), Dual(uv.y, {0, 1, 0})};
  Place r{};
  for (int i = 0; i < 3; ++i) {
    const Dual x =
        functions::evaluate_gradient(*surface_->functions[static_cast<std::size_t>(i)], place, w);
    r.p[i] = x.v;
    r.du[i] = x.d.x;
    r.dv[i] = x.d.y;
  }
  return r;
}

void ParametricData::examine(PatchCell& cell, dvec2 centre, dvec2 half) const {
  functions::Workspace& w = function_workspace(generator_);
  cell.p = point(centre);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const functions::Function& f = *surface_->functions[k];
    const Bound b = has_bounds_[k] ? bound_over(f, centre, half, w)
                                   : sampled_bound(f, centre, half, surface_->max_gradient, w);
    Interval range = b.range;
    double swing = 0;
    for (std::size_t a = 0; a < 2; ++a) {
      const Interval& s = b.slope[a];
      const bool known = !s.nan && s.is_bounded();
      cell.slope[a][i] = known ? s.mid() : 0;
      cell.spread[a][i] = known ? s.radius() : std::numeric_limits<double>::infinity();
      swing += std::max(std::abs(s.lo), std::abs(s.hi)) * half[static_cast<int>(a)];
    }
    if (std::isfinite(swing)) range = narrowed(range, {cell.p[i] - swing, cell.p[i] + swing});
    const double pad = 1e-12 * std::max(std::abs(range.lo), std::abs(range.hi));
    cell.box.lo[i] = range.lo - pad;
    cell.box.hi[i] = range.hi + pad;
  }
}

const PatchCell* ParametricData::children(const PatchCell& cell, dvec2 centre, dvec2 half) const {
  if (const PatchCell* made = cell.children.load(std::memory_order_acquire)) return made;
  auto made = std::make_unique<PatchCell[]>(4);
  const dvec2 quarter = half * 0.5;
  for (int i = 0; i < 4; ++i) {
    const dvec2 side((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1);
    examine(made[static_cast<std::size_t>(i)], centre + side * quarter, quarter);
  }
  const PatchCell* expected = nullptr;
  if (cell.children.compare_exchange_strong(expected, made.get(), std::memory_order_acq_rel)) {
    return made.release();
  }
  return expected;  // another thread was faster; its cells are the same
}

std::shared_ptr<const ParametricData> shared_parametric_data(
    const std::shared_ptr<const scene::Parametric>& surface, functions::NoiseGenerator generator) {
  static SharedData<scene::Parametric, ParametricData> known;
  auto data = known.get(surface.get(), [&] {
    return std::make_shared<const ParametricData>(surface, generator);
  });
  if (data->generator() == generator) return data;
  return std::make_shared<const ParametricData>(surface, generator);
}

namespace {

struct PatchHit {
  double t;
  dvec2 uv;
};

/// The search of one line. The line is the meeting of two planes; a point of the surface lies on it
/// where its distances from both vanish: two equations in u and v.
class PatchSearch {
 public:
  PatchSearch(const ParametricData& data, const Ray& ray, double t_from, double t_to)
      : data_(data), ray_(ray), t_from_(t_from), t_to_(t_to) {
    d2_ = glm::dot(ray.d, ray.d);
    const dvec3 a = glm::abs(ray.d);
    const dvec3 aside = a.x <= a.y && a.x <= a.z ? dvec3(1, 0, 0)
                        : a.y <= a.z             ? dvec3(0, 1, 0)
                                                 : dvec3(0, 0, 1);
    across_[0] = glm::normalize(glm::cross(ray.d, aside));
    across_[1] = glm::normalize(glm::cross(ray.d, across_[0]));
  }

  /// Calls take(hit) for hits in the range; what it returns ends the range from then on.
  template <typename Take>
  void run(Take take) {
    const scene::Parametric& s = data_.surface();
    double entry = 0;
    if (!meets(data_.root().box, entry)) return;
    walk(data_.root(), (s.from + s.to) * 0.5, (s.to - s.from) * 0.5, 0, take);
  }

 private:
  /// Where the line is inside the box, within the range; false if nowhere.
  [[nodiscard]] bool meets(const Bounds3& box, double& entry) const {
    double from = t_from_;
    double to = t_to_;
    for (int k = 0; k < 3; ++k) {
      if (ray_.d[k] == 0) {
        if (!(ray_.o[k] >= box.lo[k] && ray_.o[k] <= box.hi[k])) return false;
        continue;
      }
      const double a = (box.lo[k] - ray_.o[k]) / ray_.d[k];
      const double b = (box.hi[k] - ray_.o[k]) / ray_.d[k];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    entry = from;
    return from <= to;
  }

  enum class Verdict : std::uint8_t { none, unique, open };

  /// Krawczyk's test: with Y near the inverse of the slopes, all solutions in the rectangle lie in
  /// m - Y F(m) + (1 - Y J)(rectangle - m). If that shrinks, there is one solution at most.
  /// Source: Krawczyk, "Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken", 1969.
  [[nodiscard]] Verdict judge(const PatchCell& cell, dvec2 half) const {
    std::array<double, 2> f{};
    std::array<dvec2, 2> j{};       // rows: planes, columns: u, v
    std::array<dvec2, 2> spread{};
    for (std::size_t i = 0; i < 2; ++i) {
      f[i] = glm::dot(across_[i], cell.p - ray_.o);
      const dvec3 weight = glm::abs(across_[i]);
      for (std::size_t a = 0; a < 2; ++a) {
        j[i][static_cast<int>(a)] = glm::dot(across_[i], cell.slope[a]);
        spread[i][static_cast<int>(a)] = glm::dot(weight, cell.spread[a]);
      }
    }
    const double det = j[0].x * j[1].y - j[0].y * j[1].x;
    if (!(std::abs(det) > 0) || !std::isfinite(spread[0].x + spread[0].y + spread[1].x + spread[1].y)) {
      return Verdict::open;
    }
    const std::array<dvec2, 2> y{dvec2(j[1].y, -j[0].y) / det, dvec2(-j[1].x, j[0].x) / det};
    bool shrinks = true;
    for (std::size_t i = 0; i < 2; ++i) {
      const double step = -(y[i].x * f[0] + y[i].y * f[1]);
      const double reach = (std::abs(y[i].x) * spread[0].x + std::abs(y[i].y) * spread[1].x) * half.x +
                           (std::abs(y[i].x) * spread[0].y + std::abs(y[i].y) * spread[1].y) * half.y;
      const double own = half[static_cast<int>(i)];
      if (std::abs(step) > (reach + own) * (1 + 1e-9)) return Verdict::none;
      shrinks = shrinks && reach < 0.5 * own;
    }
    return shrinks ? Verdict::unique : Verdict::open;
  }

  /// Newton's method; none if the solution lies outside of the rectangle.
  [[nodiscard]] std::optional<PatchHit> polish(dvec2 centre, dvec2 half) const {
    dvec2 uv = centre;
    for (int i = 0; i < 12; ++i) {
      const ParametricData::Place s = data_.at(uv);
      const double f0 = glm::dot(across_[0], s.p - ray_.o);
      const double f1 = glm::dot(across_[1], s.p - ray_.o);
      const dvec2 j0(glm::dot(across_[0], s.du), glm::dot(across_[0], s.dv));
      const dvec2 j1(glm::dot(across_[1], s.du), glm::dot(across_[1], s.dv));
      const double det = j0.x * j1.y - j0.y * j1.x;
      const dvec2 step((j0.y * f1 - j1.y * f0) / det, (j1.x * f0 - j0.x * f1) / det);
      uv += step;
      const dvec2 off = glm::abs(uv - centre) - half;
      if (!(off.x < half.x && off.y < half.y)) return std::nullopt;
      if (std::abs(step.x) > 1e-10 * half.x || std::abs(step.y) > 1e-10 * half.y) continue;
      if (off.x > 1e-9 * half.x || off.y > 1e-9 * half.y) return std::nullopt;
      const double t = glm::dot(ray_.d, s.p + step.x * s.du + step.y * s.dv - ray_.o) / d2_;
      return PatchHit{t, uv};
    }
    return std::nullopt;
  }

  template <typename Take>
  void accept(const PatchHit& hit, Take& take) {
    if (hit.t >= t_from_ && hit.t < t_to_) t_to_ = take(hit);
  }

  template <typename Take>
  void walk(const PatchCell& cell, dvec2 centre, dvec2 half, int depth, Take& take) {
    const dvec3 extent = cell.box.hi - cell.box.lo;
    const double size2 = glm::dot(extent, extent);
    const scene::Parametric& s = data_.surface();
    if (size2 < 0.25 * square(s.accuracy) || depth == depth_limit) {
      return accept({glm::dot(ray_.d, cell.p - ray_.o) / d2_, centre}, take);
    }
    const Verdict verdict = judge(cell, half);
    if (verdict == Verdict::none) return;
    if (verdict == Verdict::unique) {
      if (const auto hit = polish(centre, half)) accept(*hit, take);
      return;
    }
    const PatchCell* children = data_.children(cell, centre, half);
    struct Next {
      double entry;
      int child;
    };
    std::array<Next, 4> order{};
    std::size_t n = 0;
    for (int i = 0; i < 4; ++i) {
      double entry = 0;
      if (!meets(children[i].box, entry)) continue;
      std::size_t at = n++;
      for (; at > 0 && order[at - 1].entry > entry; --at) order[at] = order[at - 1];
      order[at] = {entry, i};
    }
    const dvec2 quarter = half * 0.5;
    for (std::size_t i = 0; i < n; ++i) {
      if (order[i].entry > t_to_) break;
      const int child = order[i].child;
      const dvec2 side((child & 1) != 0 ? 1 : -1, (child & 2) != 0 ? 1 : -1);
      walk(children[child], centre + side * quarter, quarter, depth + 1, take);
    }
  }

  const ParametricData& data_;
  Ray ray_;
  double t_from_;
  double t_to_;
  double d2_;
  std::array<dvec3, 2> across_;
};

constexpr double steps = 65536;

std::uint32_t part_of(const scene::Parametric& s, dvec2 uv) {
  const dvec2 share = (uv - s.from) / (s.to - s.from) * steps;
  const auto index = [](double x) {
    return static_cast<std::uint32_t>(std::clamp(std::floor(x), 0.0, steps - 1));
  };
  return index(share.x) << 16U | index(share.y);
}

}  // namespace

Bounds3 ParametricShape::bounds() const {
  const Bounds3 b = data_->root().box.intersection(data_->surface().container.bounds());
  return b.empty() ? Bounds3{dvec3(0.0), dvec3(0.0)} : b;
}

/// The place that the part names, made exact by the point that lies there.
dvec2 ParametricShape::uv(dvec3 p, std::uint32_t part) const {
  const scene::Parametric& s = data_->surface();
  const dvec2 index(part >> 16U, part & 0xFFFFU);
  const dvec2 coarse = s.from + (s.to - s.from) * ((index + 0.5) / steps);
  dvec2 uv = coarse;
  for (int i = 0; i < 2; ++i) {  // Gauss-Newton on the distance
    const ParametricData::Place at = data_->at(uv);
    const dvec3 off = p - at.p;
    const double a = glm::dot(at.du, at.du);
    const double b = glm::dot(at.du, at.dv);
    const double c = glm::dot(at.dv, at.dv);
    const double det = a * c - b * b;
    const double e = glm::dot(at.du, off);
    const double f = glm::dot(at.dv, off);
    const dvec2 step((c * e - b * f) / det, (a * f - b * e) / det);
    if (!(std::abs(step.x) < s.to.x - s.from.x && std::abs(step.y) < s.to.y - s.from.y)) break;
    uv = glm::clamp(uv + step, s.from, s.to);
  }
  const dvec2 cell = (s.to - s.from) / steps;
  return glm::clamp(uv, coarse - cell, coarse + cell);
}

/// The oracle's: differences over steps as long as the accuracy.
dvec3 ParametricShape::normal(dvec3 p, std::uint32_t part) const {
  const double step = data_->surface().accuracy;
  dvec2 at = uv(p, part);
  const dvec2 middle = (data_->surface().from + data_->surface().to) * 0.5;
  for (int i = 0; i < 8; ++i) {
    const dvec3 here = data_->point(at);
    const dvec3 n = glm::cross(data_->point(at + dvec2(step, 0)) - here,
                               data_->point(at + dvec2(0, step)) - here);
    if (glm::dot(n, n) > 0) return n;
    at += (middle - at) * 0.01;  // a pole: what lies beside it
  }
  return {1, 0, 0};
}

void ParametricShape::crossings(const Ray& ray, Crossings& out) const {
  const auto stretch = stretch_in(data_->surface().container, ray);
  if (!stretch) return;
  PatchSearch search(*data_, ray, stretch->from, stretch->to);
  search.run([&](const PatchHit& hit) {
    out.push_back({.t = hit.t, .part = part_of(data_->surface(), hit.uv), .side = Side::sheet});
    return stretch->to;
  });
}

std::optional<Nearest> ParametricShape::nearest(const Ray& ray, double t_from, double t_to) const {
  const auto stretch = stretch_in(data_->surface().container, ray);
  if (!stretch) return std::nullopt;
  std::optional<Nearest> best;
  PatchSearch search(*data_, ray, std::max(t_from, stretch->from), std::min(t_to, stretch->to));
  search.run([&](const PatchHit& hit) {
    best = Nearest{hit.t, part_of(data_->surface(), hit.uv)};
    return hit.t;
  });
  return best;
}

}  // namespace durer::tracer

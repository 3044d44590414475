#include "tracer/primitives/outline.h"

#include <algorithm>
#include <glm/common.hpp>

namespace durer::tracer {

Arc straight_arc(dvec2 from, dvec2 to) { return {{from, to}, 1}; }

Arc quadratic_spline_arc(dvec2 before, dvec2 from, dvec2 to) {
  return {{from, from + 0.25 * (to - before), to}, 2};
}

Arc cubic_spline_arc(dvec2 before, dvec2 from, dvec2 to, dvec2 after) {
  return {{from, from + (to - before) / 6.0, to - (after - from) / 6.0, to}, 3};
}

dvec2 Arc::at(double w) const {
  std::array<dvec2, 4> p = c;
  for (int left = degree; left > 0; --left) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(left); ++i) p[i] += (p[i + 1] - p[i]) * w;
  }
  return p[0];
}

dvec2 Arc::slope(double w) const {
  std::array<dvec2, 4> p = c;
  for (int left = degree; left > 1; --left) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(left); ++i) p[i] += (p[i + 1] - p[i]) * w;
  }
  return static_cast<double>(degree) * (p[1] - p[0]);
}

namespace {

// Where the distance has an extremum, (P(w) - p) · P'(w) vanishes.
template <std::size_t N>
double nearest_on(const Arc& arc, dvec2 p) {
  std::array<Bernstein<N>, 2> gap{};
  for (std::size_t i = 0; i <= N; ++i) gap[0][i] = arc.c[i].x - p.x, gap[1][i] = arc.c[i].y - p.y;
  Bernstein<2 * N - 1> slope{};
  for (const Bernstein<N>& x : gap) {
    const auto part = product<N, N - 1>(x, derivative<N>(x));
    for (std::size_t i = 0; i < slope.size(); ++i) slope[i] += part[i];
  }
  double best = 0;
  double least = glm::dot(arc.c[0] - p, arc.c[0] - p);
  const auto consider = [&](double w) {
    const dvec2 off = arc.at(w) - p;
    if (glm::dot(off, off) < least) least = glm::dot(off, off), best = w;
  };
  consider(1);
  for (const double w : sign_changes<2 * N - 1>(slope)) consider(w);
  return best;
}

}  // namespace

double Arc::nearest_to(dvec2 p) const {
  switch (degree) {
    case 1: {
      const dvec2 way = c[1] - c[0];
      const double length2 = glm::dot(way, way);
      return length2 > 0 ? std::clamp(glm::dot(p - c[0], way) / length2, 0.0, 1.0) : 0;
    }
    case 2: return nearest_on<2>(*this, p);
    default: return nearest_on<3>(*this, p);
  }
}

dvec2 Arc::slope_near(dvec2 p) const { return degree == 1 ? c[1] - c[0] : slope(nearest_to(p)); }

Outline::Outline(std::vector<Arc> arcs) : arcs_(std::move(arcs)) {
  if (arcs_.empty()) return;
  const Box all = box_of(0, static_cast<std::uint32_t>(arcs_.size()));
  split(0, static_cast<std::uint32_t>(arcs_.size()));
  // Control points bound the curve, but not tightly; for extents that show, ask the curve.
  lo_ = all.middle + all.half;
  hi_ = all.middle - all.half;
  for (const Arc& arc : arcs_) {
    const auto add = [&](dvec2 p) {
      lo_ = glm::min(lo_, p);
      hi_ = glm::max(hi_, p);
    };
    add(arc.begin());
    add(arc.end());
    if (arc.degree == 1) continue;
    for (int axis = 0; axis < 2; ++axis) {
      const auto n = static_cast<std::size_t>(arc.degree);
      Bernstein<2> rise{};  // of degree 1 for a quadratic arc, raised
      for (std::size_t i = 0; i < n; ++i) rise[i] = arc.c[i + 1][axis] - arc.c[i][axis];
      if (n == 2) rise = raised<2, 1>({rise[0], rise[1]});
      for (const double w : sign_changes<2>(rise)) add(arc.at(w));
    }
  }
}

Outline::Box Outline::box_of(std::uint32_t begin, std::uint32_t end) const {
  dvec2 lo(arcs_[begin].c[0]);
  dvec2 hi = lo;
  for (std::uint32_t a = begin; a < end; ++a) {
    for (std::size_t i = 0; i <= static_cast<std::size_t>(arcs_[a].degree); ++i) {
      lo = glm::min(lo, arcs_[a].c[i]);
      hi = glm::max(hi, arcs_[a].c[i]);
    }
  }
  const dvec2 size = glm::max(glm::abs(lo), glm::abs(hi));
  return {0.5 * (lo + hi), 0.5 * (hi - lo) + 1e-12 * size};
}

void Outline::split(std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t leaf_size = 2;
  const auto at = nodes_.size();
  nodes_.push_back({box_of(begin, end), 0, begin, end - begin});
  if (end - begin > leaf_size) {
    nodes_[at].count = 0;
    const dvec2 half = nodes_[at].box.half;
    const int axis = half.x >= half.y ? 0 : 1;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(arcs_.begin() + begin, arcs_.begin() + middle, arcs_.begin() + end,
                     [axis](const Arc& a, const Arc& b) {
                       return a.begin()[axis] + a.end()[axis] < b.begin()[axis] + b.end()[axis];
                     });
    split(begin, middle);
    split(middle, end);
  }
  nodes_[at].skip = static_cast<std::uint32_t>(nodes_.size());
}

bool Outline::contains(dvec2 p) const {
  if (!(p.x <= hi_.x && p.y >= lo_.y && p.y <= hi_.y)) return false;
  bool inside = false;
  each_near(
      [&](const Box& b) {
        return std::abs(p.y - b.middle.y) <= b.half.y && p.x <= b.middle.x + b.half.x;
      },
      [&](std::uint32_t i) {
        const Arc& arc = arcs_[i];
        arc.each_sign_change([&](dvec2 q) { return q.y - p.y; },
                             [&](double w) { inside ^= arc.at(w).x >= p.x; });
      });
  return inside;
}

}  // namespace durer::tracer

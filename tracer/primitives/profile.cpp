#include "tracer/primitives/profile.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace durer::tracer {
namespace {

bool same(dvec2 a, dvec2 b) {
  return std::abs(a.x - b.x) < epsilon && std::abs(a.y - b.y) < epsilon;
}

/// How a kind of spline lists the points of a curve.
struct Layout {
  std::size_t least;   // points of the shortest list
  std::size_t before;  // control points that the curve does not reach, before it …
  std::size_t after;   // … and after it
};
constexpr std::array<Layout, 3> layouts = {{{3, 0, 0}, {5, 1, 0}, {6, 1, 1}}};

Arc arc_at(Spline spline, std::span<const dvec2> p, std::size_t i, dvec2 to) {
  switch (spline) {
    case Spline::linear: return straight_arc(p[i], to);
    case Spline::quadratic: return quadratic_spline_arc(p[i - 1], p[i], to);
    default: return cubic_spline_arc(p[i - 1], p[i], to, p[i + 2]);
  }
}

void add_through(Spline spline, std::span<const dvec2> p, Curves& out) {
  const Layout layout = layouts[static_cast<std::size_t>(spline)];
  for (std::size_t at = 0; at < p.size();) {
    const std::size_t first = at + layout.before;
    std::size_t last = first + 1;
    while (last < p.size() && !same(p[last], p[first])) ++last;
    const bool closes = last + layout.after < p.size();
    if (!closes && spline != Spline::linear) {
      out.problem =
          fmt::format("the curve that starts at point {} does not come back to it", first + 1);
      return;
    }
    if (!closes) out.doubt = "the outline is not closed; it is closed by a straight line";
    for (std::size_t i = first; i < last; ++i) {
      // The curve ends where it began, to the last bit.
      const dvec2 to = i + 1 >= last ? p[first] : p[i + 1];
      if (spline == Spline::linear && to == p[i]) continue;
      out.arcs.push_back(arc_at(spline, p, i, to));
    }
    at = last + 1 + layout.after;
  }
}

void add_bezier(std::span<const dvec2> p, Curves& out) {
  std::vector<Arc> arcs;
  dvec2 start = p[0];
  dvec2 end = p[0];
  bool closed = true;
  for (std::size_t i = 0; i < p.size(); i += 4) {
    if (!same(p[i], end)) {
      closed = closed && same(start, end);
      start = end = p[i];
    }
    const dvec2 to = same(p[i + 3], start) ? start : p[i + 3];
    // The oracle runs through each from its end.
    arcs.push_back({{to, p[i + 2], p[i + 1], end}, 3});
    end = to;
  }
  closed = closed && same(start, end);
  if (closed) {
    out.arcs = std::move(arcs);
  } else {
    out.doubt = "the outline is not closed; nothing is seen of it";
  }
}

}  // namespace

std::vector<dvec2> points_of(std::span<const double> numbers) {
  std::vector<dvec2> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
    points.push_back({numbers[i], numbers[i + 1]});
  return points;
}

Curves closed_curves(Spline spline, std::span<const dvec2> points) {
  Curves out;
  if (spline == Spline::bezier) {
    if (points.empty() || points.size() % 4 != 0) {
      out.problem = fmt::format("Bézier curves take four points each, here are {}", points.size());
    } else {
      add_bezier(points, out);
    }
    return out;
  }
  const std::size_t least = layouts[static_cast<std::size_t>(spline)].least;
  if (points.size() < least) {
    out.problem =
        fmt::format("such a spline takes {} points or more, here are {}", least, points.size());
    return out;
  }
  add_through(spline, points, out);
  return out;
}

Curves open_curve(Spline spline, std::span<const dvec2> p) {
  constexpr std::array<std::size_t, 3> least = {2, 3, 4};
  Curves out;
  const std::size_t n = p.size();
  if (spline == Spline::bezier) {
    if (p.empty() || n % 4 != 0) {
      out.problem = fmt::format("Bézier curves take four points each, here are {}", n);
      return out;
    }
    for (std::size_t i = 0; i < n; i += 4) {
      const dvec2 from = i > 0 && same(p[i - 1], p[i]) ? p[i - 1] : p[i];
      out.arcs.push_back({{from, p[i + 1], p[i + 2], p[i + 3]}, 3});
    }
  } else {
    const auto kind = static_cast<std::size_t>(spline);
    if (n < least[kind]) {
      out.problem =
          fmt::format("such a spline takes {} points or more, here are {}", least[kind], n);
      return out;
    }
    const Layout layout = layouts[kind];
    for (std::size_t i = layout.before; i + 1 + layout.after < n; ++i) {
      out.arcs.push_back(arc_at(spline, p, i, p[i + 1]));
    }
  }
  for (std::size_t i = 0; i < out.arcs.size(); ++i)
    out.arcs[i].number = static_cast<std::uint32_t>(i);
  return out;
}

}  // namespace durer::tracer

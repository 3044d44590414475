#include "tracer/primitives/tube.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace durer::tracer {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Bounds3 Tube::bounds() const {
  const double r = std::max(1.0, std::abs(radius(1)));
  return {{-r, -r, 0}, {r, r, 1}};
}

bool Tube::contains(dvec3 p) const {
  const double grow = open ? epsilon : -epsilon;
  const double r = radius(p.z);
  return p.x * p.x + p.y * p.y <= r * r + grow && p.z >= -grow && p.z <= 1 + grow;
}

dvec3 Tube::normal(dvec3 p, std::uint32_t part) const {
  if (part != 0) return {0, 0, part == 1 ? -1 : 1};
  return {p.x, p.y, -slope * radius(p.z)};
}

// The plane that touches the wall near the apex: how far along its normal both ends reach.
bool Tube::misses(const ShaftHull& hull) const {
  const dvec3 m = normal(hull.apex, 0);
  const double aside = std::sqrt(m.x * m.x + m.y * m.y);
  const double support = std::max(aside * std::abs(radius(0)), aside * std::abs(radius(1)) + m.z);
  return hull.beyond(dvec3(0.0), m, support);
}

// Where x² + y² <= radius(z)², on the endless wall: a t² + 2 b t + c <= 0. Measured from the point
// of the line nearest to the middle of the body, which keeps the discriminant exact far away.
Tube::Pieces Tube::inside_wall(const Ray& ray) const {
  const dvec3 d = ray.d;
  const double d2 = glm::dot(d, d);
  const double middle = glm::dot(dvec3(0, 0, 0.5) - ray.o, d) / d2;
  const dvec3 p = ray.at(middle);
  const double dr = slope * d.z;
  const double r = radius(p.z);
  const double a = d.x * d.x + d.y * d.y - dr * dr;
  const double b = p.x * d.x + p.y * d.y - r * dr;
  const double c = p.x * p.x + p.y * p.y - r * r;
  const End begin{-infinity, 0};
  const End end{infinity, 0};
  Pieces pieces;
  if (std::abs(a) <= epsilon * d2) {  // parallel to the wall: at most one root
    if (b * b <= epsilon * epsilon * d2) {
      if (c <= 0) pieces.add(begin, end);
      return pieces;
    }
    const End root{middle - c / (2 * b), 0};
    b > 0 ? pieces.add(begin, root) : pieces.add(root, end);
    return pieces;
  }
  // Tangent lines hit (objects §10.3): silhouettes that pass through pixel centres are drawn
  // whatever rounding says.
  const double noise = 4e-15 * std::abs(a) * (p.x * p.x + p.y * p.y + r * r);
  const double discriminant = b * b - a * c;
  if (!(discriminant >= -noise)) {
    if (a < 0) pieces.add(begin, end);
    return pieces;
  }
  double t1 = -b / a;
  double t2 = t1;
  if (discriminant > 0) {
    // Stable roots: q takes the sign that does not cancel, the other root follows from the product.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    t1 = q / a;
    t2 = c / q;
    if (t1 > t2) std::swap(t1, t2);
  }
  if (a > 0) {
    pieces.add({middle + t1, 0}, {middle + t2, 0});
  } else {
    pieces.add(begin, {middle + t1, 0});
    pieces.add({middle + t2, 0}, end);
  }
  return pieces;
}

Tube::Pieces Tube::inside(const Ray& ray) const {
  End low{-infinity, 0};
  End high{infinity, 0};
  if (ray.d.z * ray.d.z > epsilon * epsilon * glm::dot(ray.d, ray.d)) {
    low = {-ray.o.z / ray.d.z, 1};
    high = {(1 - ray.o.z) / ray.d.z, 2};
    if (low.t > high.t) std::swap(low, high);
  } else if (!(ray.o.z >= 0 && ray.o.z <= 1)) {
    return {};
  }
  const Pieces endless = inside_wall(ray);
  Pieces result;
  for (int i = 0; i < endless.count; ++i) {
    const auto& [enter, exit] = endless.items[static_cast<std::size_t>(i)];
    const End from = enter.t >= low.t ? enter : low;
    const End to = exit.t <= high.t ? exit : high;
    if (from.t <= to.t && from.t > -infinity && to.t < infinity) result.add(from, to);
  }
  return result;
}

void Tube::crossings(const Ray& ray, Crossings& out) const {
  const Pieces pieces = inside(ray);
  const auto push = [&](End e, Side side) {
    out.push_back({.t = e.t, .part = e.part, .side = side, .visible = visible(e.part)});
  };
  for (int i = 0; i < pieces.count; ++i) {
    push(pieces.items[static_cast<std::size_t>(i)].enter, Side::enter);
    push(pieces.items[static_cast<std::size_t>(i)].exit, Side::exit);
  }
}

std::optional<Nearest> Tube::nearest(const Ray& ray, double t_from, double t_to) const {
  const Pieces pieces = inside(ray);
  std::optional<Nearest> best;
  const auto offer = [&](End e) {
    if (!visible(e.part) || !(e.t >= t_from && e.t < t_to)) return;
    best = Nearest{e.t, e.part};
    t_to = e.t;
  };
  for (int i = 0; i < pieces.count; ++i) {
    offer(pieces.items[static_cast<std::size_t>(i)].enter);
    offer(pieces.items[static_cast<std::size_t>(i)].exit);
  }
  return best;
}

}  // namespace durer::tracer

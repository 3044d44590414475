#include "tracer/primitives/blob_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "tracer/primitives/frame.h"

namespace durer::tracer {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Makes stretches of one component.
struct Appender {
  double radius2;
  double strength;
  double full;
  std::vector<BlobStretch>& out;

  /// The stretch where |o + t d|² < radius2, cut to [from, to].
  void operator()(dvec3 o, dvec3 d, double from, double to) const {
    const double bend = glm::dot(d, d);
    if (bend <= 1e-30) {  // along a rod: the same all the way
      const double top = radius2 - glm::dot(o, o);
      const double full_begin = top > full ? from : endless;
      if (top > 0 && from < to) out.push_back({from, to, 0, top, 0, strength, full_begin, to});
      return;
    }
    const double middle = -glm::dot(o, d) / bend;
    const dvec3 nearest = o + middle * d;
    const double top = radius2 - glm::dot(nearest, nearest);
    if (!(top > epsilon * radius2)) return;
    const double half = std::sqrt(top / bend);
    const double begin = std::max(middle - half, from);
    const double end = std::min(middle + half, to);
    if (!(begin < end)) return;
    double full_begin = endless;
    double full_end = -endless;
    if (top > full) {
      const double full_half = std::sqrt((top - full) / bend);
      full_begin = std::max(middle - full_half, begin);
      full_end = std::min(middle + full_half, end);
    }
    out.push_back({begin, end, middle, top, bend, strength, full_begin, full_end});
  }
};

/// The oracle's boxes are cubes: around a ball, around both ends of a rod, and one around what is
/// between them; their edges are those that the widest side of a turned cube has.
Bounds3 seen_of(const BlobComponent& c, const Affine& to_blob) {
  const dvec3 widest = dvec3(glm::abs(to_blob.x)) + glm::abs(to_blob.y) + glm::abs(to_blob.z);
  const double widening = std::max({widest.x, widest.y, widest.z});
  Bounds3 all;
  const auto add_cube = [&](double z, double radius) {
    const dvec3 middle = to_blob.point({0, 0, z});
    all.add(Bounds3{middle - radius * widening, middle + radius * widening});
  };
  add_cube(0, std::sqrt(c.radius2));
  if (c.length < 0) return all;
  add_cube(c.length, std::sqrt(c.radius2));
  add_cube(0.5 * c.length, std::sqrt(c.radius2 + 0.25 * c.length * c.length));
  return all;
}

}  // namespace

dvec3 BlobComponent::from_axis(dvec3 own) const {
  if (length > 0) own.z -= std::clamp(own.z, 0.0, length);
  return own;
}

double BlobComponent::field(dvec3 p) const {
  const dvec3 off = from_axis(to_own.point(p));
  const double root = radius2 - glm::dot(off, off);
  return root > 0 ? strength * root * root : 0;
}

dvec3 BlobComponent::fall(dvec3 p) const {
  const dvec3 off = from_axis(to_own.point(p));
  const double root = radius2 - glm::dot(off, off);
  return root > 0 ? to_own.covector(4 * strength * root * off) : dvec3(0.0);
}

void BlobComponent::append_stretches(const Ray& ray, double t_from, double t_to,
                                     std::vector<BlobStretch>& out) const {
  const Appender append{radius2, strength, full, out};
  const dvec3 o = to_own.point(ray.o);
  const dvec3 d = to_own.vector(ray.d);
  if (length < 0) {
    append(o, d, t_from, t_to);
    return;
  }
  // Where the line is beside the rod, below and above it.
  const double t0 = -o.z / d.z;
  const double t1 = (length - o.z) / d.z;
  const dvec3 o_top = o - dvec3(0, 0, length);
  const dvec3 o_side(o.x, o.y, 0);
  const dvec3 d_side(d.x, d.y, 0);
  if (std::abs(d.z) < 1e-15) {
    if (o.z < 0) append(o, d, t_from, t_to);
    if (o.z > length) append(o_top, d, t_from, t_to);
    if (o.z >= 0 && o.z <= length) append(o_side, d_side, t_from, t_to);
    return;
  }
  const bool climbs = d.z > 0;
  const auto until = [&](double t) { return std::min(t, t_to); };
  const auto from = [&](double t) { return std::max(t, t_from); };
  append(o, d, climbs ? t_from : from(t0), climbs ? until(t0) : t_to);
  append(o_side, d_side, from(std::min(t0, t1)), until(std::max(t0, t1)));
  append(o_top, d, climbs ? from(t1) : t_from, climbs ? t_to : until(t1));
}

std::size_t blob_component_size(std::span<const double> list) {
  if (list.empty()) return 0;
  const auto kind = static_cast<unsigned>(list[0]);
  const std::size_t size = ((kind & 1U) != 0 ? 10 : 7) + ((kind & 2U) != 0 ? 12U : 0U);
  return size <= list.size() ? size : 0;
}

std::vector<BlobComponent> blob_components(std::span<const double> list, double threshold) {
  std::vector<BlobComponent> all;
  for (std::size_t size = 0; (size = blob_component_size(list)) > 0; list = list.subspan(size)) {
    const auto kind = static_cast<unsigned>(list[0]);
    const bool rod = (kind & 1U) != 0;
    std::size_t at = 1;
    const auto next = [&] { return list[at++]; };
    const auto point = [&] {
      at += 3;
      return dvec3(list[at - 3], list[at - 2], list[at - 1]);
    };
    BlobComponent c;
    const dvec3 from = point();
    const dvec3 to = rod ? point() : from;
    const double radius = std::abs(next());
    const double strength = next();
    c.texture = static_cast<std::uint32_t>(next());
    if (!(radius > 0) || strength == 0) continue;
    c.radius2 = radius * radius;
    c.strength = strength / (c.radius2 * c.radius2);
    // A little deeper, so that rounding cannot take it below.
    c.full = threshold > 0 && strength > 0 ? (1 + 1e-9) * std::sqrt(threshold / c.strength)
                                           : c.radius2;
    Transform placement = Transform::translate(from);
    Bounds3 reach{dvec3(-radius), dvec3(radius)};
    if (rod) {
      c.length = glm::distance(from, to);
      placement = frame_along(from, (to - from) / c.length, 1, 1);
      reach.hi.z += c.length;
    }
    if ((kind & 2U) != 0) {
      std::array<double, 12> m{};
      for (double& x : m) x = next();
      if (const auto moved = Transform::matrix(m)) placement = placement.then(*moved);
    }
    c.to_own = placement.backward;
    c.plain = !rod && (kind & 2U) == 0;
    c.reach = reach.transformed(placement.forward);
    if (strength > 0) c.seen = seen_of(c, placement.forward);
    all.push_back(c);
  }
  return all;
}

}  // namespace durer::tracer

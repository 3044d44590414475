#include "tracer/primitives/isosurface_shape.h"

#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "tracer/primitives/field_packet.h"
#include "tracer/primitives/field_search.h"
#include "tracer/primitives/sampled_search.h"
#include "tracer/primitives/shared_data.h"

namespace durer::tracer {

IsosurfaceData::IsosurfaceData(std::shared_ptr<const scene::Isosurface> s,
                               functions::NoiseGenerator generator)
    : surface(std::move(s)),
      field(surface->function, surface->threshold, surface->container.bounds(), generator),
      differences(field.function()) {}

void IsosurfaceData::note_slope(double slope) const {
  double known = steepest.load(std::memory_order_relaxed);
  while (slope > known &&
         !steepest.compare_exchange_weak(known, slope, std::memory_order_relaxed)) {
  }
}

std::shared_ptr<const IsosurfaceData> shared_isosurface_data(
    const std::shared_ptr<const scene::Isosurface>& surface, functions::NoiseGenerator generator) {
  static SharedData<scene::Isosurface, IsosurfaceData> known;
  auto data = known.get(surface.get(),
                        [&] { return std::make_shared<const IsosurfaceData>(surface, generator); });
  // The scene's noise may have been settled since somebody asked first, during parsing.
  if (data->field.generator() == generator) return data;
  return std::make_shared<const IsosurfaceData>(surface, generator);
}

bool IsosurfaceShape::contains(dvec3 p) const {
  const scene::Isosurface& s = *data_->surface;
  if (!tracer::contains(s.container, p)) return false;
  functions::Workspace& w = function_workspace(data_->field.generator());
  return functions::evaluate(*data_->field.function(), std::array{p.x, p.y, p.z}, w) <= s.threshold;
}

namespace {

/// A normal by differences; where there are none, along x.
dvec3 upward(const dvec3& n) {
  return n == dvec3(0.0) || !(glm::dot(n, n) > 0) ? dvec3(1, 0, 0) : n;
}

}  // namespace

/// The oracle's: differences over a step as long as the accuracy, which a coarse accuracy smooths.
dvec3 IsosurfaceShape::normal(dvec3 p, std::uint32_t part) const {
  const scene::Isosurface& s = *data_->surface;
  if (part != 0) return face_normal(s.container, p, part);
  functions::Workspace& w = function_workspace(data_->field.generator());
  const auto [here, x, y, z] = data_->differences(p, s.accuracy, w);
  return upward(dvec3(x, y, z) - here);
}

void IsosurfaceShape::normals(const PacketPoints& points, PacketVectors& out) const {
  using functions::Pack;
  const scene::Isosurface& s = *data_->surface;
  std::uint32_t faces = 0;
  for (std::size_t i = 0; i < points.count; ++i) faces |= (points.part[i] != 0 ? 1U : 0U) << i;
  const std::uint32_t wanted = ~faces & ((2U << (points.count - 1)) - 1);
  constexpr std::size_t group = Pack::lanes;
  functions::Workspace& w = function_workspace(data_->field.generator());
  for (std::size_t first = 0; first < points.count; first += group) {
    if ((wanted >> first & ((1U << group) - 1)) == 0) continue;
    const auto at = [first](auto& v, std::size_t k) { return &v.of[k][first]; };
    data_->differences({at(points.p, 0), at(points.p, 1), at(points.p, 2)}, s.accuracy,
                       {at(out, 0), at(out, 1), at(out, 2)}, w);
  }
  for (std::uint32_t left = wanted & ~above_zero(out, points.count); left != 0; left &= left - 1) {
    out.set(static_cast<std::size_t>(std::countr_zero(left)), upward(dvec3(0.0)));
  }
  for (; faces != 0; faces &= faces - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(faces));
    out.set(i, face_normal(s.container, points.p[i], points.part[i]));
  }
}

/// As the oracle judges: by ratio and difference of what was set and what was found (objects
/// §10.13). Only where the setting was used at all.
std::pair<std::string, std::string> IsosurfaceShape::doubt() const {
  const double set = data_->surface->max_gradient;
  const double found = data_->steepest.load(std::memory_order_relaxed);
  if (data_->field.has_bounds() || !(found > 0)) return {};
  const double ratio = set / found;
  const double excess = set - found;
  const bool holes =
      (ratio <= 0.9 && excess <= -0.5) || ((ratio <= 0.95 || excess <= -0.1) && set < 10);
  const bool slow = excess >= 10 || (ratio >= 1.1 && excess >= 0.5);
  if (!holes && !slow) return {};
  return {fmt::format("the function of this `isosurface` has slopes of {:.3f}, but `max_gradient` "
                      "is {:.3f}: {}",
                      found, set, holes ? "there may be holes" : "that is more than it takes"),
          fmt::format("write `max_gradient {:.3f}`", found)};
}

double IsosurfaceShape::least() const {
  constexpr double share = 1.0 / 64;
  return share * data_->surface->accuracy;
}

/// Calls take(crossing) in ascending order, at least for all with t_from <= t < t_to, until it
/// returns true.
template <typename Take>
void IsosurfaceShape::each_crossing(const Ray& ray, double t_from, double t_to, Take take) const {
  const scene::Isosurface& s = *data_->surface;
  const auto stretch = stretch_in(s.container, ray);
  if (!stretch || !(stretch->to >= t_from) || !(stretch->from < t_to)) return;
  const auto found = [&](double t, int sign) {
    if (t == stretch->from) {
      return sign < 0 &&
             take(Crossing{
                 .t = t, .part = stretch->face_from, .side = Side::enter, .visible = !s.open});
    }
    return take(Crossing{.t = t, .side = sign < 0 ? Side::enter : Side::exit});
  };
  int last = 0;
  if (data_->field.has_bounds()) {
    FieldSearch search(data_->field, ray, t_from, t_to, least());
    last = search.run(*stretch, found);
  } else {
    SampledSearch search(*data_, ray, t_from, t_to);
    last = search.run(*stretch, found);
  }
  if (last < 0) {
    take(Crossing{
        .t = stretch->to, .part = stretch->face_to, .side = Side::exit, .visible = !s.open});
  }
}

void IsosurfaceShape::crossings(const Ray& ray, Crossings& out) const {
  each_crossing(ray, -no_hit_depth, no_hit_depth, [&](const Crossing& c) {
    out.push_back(c);
    return false;
  });
}

void IsosurfaceShape::nearest(const PacketRays& rays, bool any, PacketHits& hits) const {
  if (data_->field.has_bounds()) {
    return FieldPacket(data_->field, *data_->surface, least(), any, rays, hits).run();
  }
  for (std::size_t i = 0; i < rays.count; ++i) {
    if (!(rays.t_from[i] < rays.t_to[i])) continue;
    const auto hit = nearest(rays.ray(i), rays.t_from[i], rays.t_to[i]);
    if (hit) hits.set(i, hit->t, hit->part);
  }
}

std::optional<Nearest> IsosurfaceShape::nearest(const Ray& ray, double t_from, double t_to) const {
  std::optional<Nearest> hit;
  each_crossing(ray, t_from, t_to, [&](const Crossing& c) {
    if (!c.visible || !(c.t >= t_from)) return false;
    if (c.t < t_to) hit = Nearest{c.t, c.part};
    return true;
  });
  return hit;
}

}  // namespace durer::tracer

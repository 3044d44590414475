#include "tracer/primitives/isosurface_shape.h"

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
  auto data = known.get(surface.get(), [&] {
    return std::make_shared<const IsosurfaceData>(surface, generator);
  });
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

void IsosurfaceShape::normals(std::span<const dvec3> points, std::span<const std::uint32_t> parts,
                              dvec3* out) const {
  using functions::Pack;
  const scene::Isosurface& s = *data_->surface;
  // Those of the surface itself, eight at a time; the last ones repeat one.
  std::array<std::size_t, most_in_packet> places;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (parts[i] == 0) {
      places[count++] = i;
    } else {
      out[i] = face_normal(s.container, points[i], parts[i]);
    }
  }
  functions::Workspace& w = function_workspace(data_->field.generator());
  for (std::size_t first = 0; first < count; first += Pack::lanes) {
    const std::size_t last = std::min(count, first + Pack::lanes) - 1;
    std::array<Pack, 3> p;
    for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
      const dvec3& point = points[places[std::min(first + lane, last)]];
      for (std::size_t k = 0; k < 3; ++k) p[k].v[lane] = point[static_cast<int>(k)];
    }
    const auto [here, x, y, z] = data_->differences(p, s.accuracy, w);
    for (std::size_t i = first; i <= last; ++i) {
      const std::size_t lane = i - first;
      out[places[i]] = upward(dvec3(x.v[lane], y.v[lane], z.v[lane]) - here.v[lane]);
    }
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
  const bool holes = (ratio <= 0.9 && excess <= -0.5) ||
                     ((ratio <= 0.95 || excess <= -0.1) && set < 10);
  const bool slow = excess >= 10 || (ratio >= 1.1 && excess >= 0.5);
  if (!holes && !slow) return {};
  return {fmt::format("the function of this `isosurface` has slopes of {:.3f}, but `max_gradient` "
                      "is {:.3f}: {}",
                      found, set,
                      holes ? "there may be holes" : "that is more than it takes"),
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
      return sign < 0 && take(Crossing{.t = t, .part = stretch->face_from, .side = Side::enter,
                                       .visible = !s.open});
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
    take(Crossing{.t = stretch->to, .part = stretch->face_to, .side = Side::exit,
                  .visible = !s.open});
  }
}

void IsosurfaceShape::crossings(const Ray& ray, Crossings& out) const {
  each_crossing(ray, -no_hit_depth, no_hit_depth, [&](const Crossing& c) {
    out.push_back(c);
    return false;
  });
}

void IsosurfaceShape::nearest(std::span<const PacketRay> rays,
                              std::span<std::optional<Nearest>> hits, bool any) const {
  if (data_->field.has_bounds()) {
    return FieldPacket(data_->field, *data_->surface, least(), any).run(rays, hits);
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = nearest(rays[i].ray, rays[i].t_from, rays[i].t_to);
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

// The short way for several points: lamp by lamp, so that objects which answer rays together are
// asked once for all points that a lamp may light.
#include <new>

#include "tracer/transport/plain.h"

namespace durer::tracer {
namespace {

/// Copies number by number: reading at once, in larger pieces, what was just computed takes long.
template <typename Vector>
DURER_INLINE void put(const Vector& from, Vector& to) {
  to.x = from.x;
  to.y = from.y;
  to.z = from.z;
}

}  // namespace

/// A point on its way to be lit.
struct Tracer::PlainPoint {
  Sample* sample = nullptr;
  const View* view = nullptr;
  LayerPoint layer;
  vec3 lit{0.0F};
};

/// Lights those samples that go the short way and have been looked up; they wait no longer. Asks the
/// same rays as if they were lit one by one.
void Tracer::light_together(std::span<Sample> samples) {
  Packet<PlainPoint> points;
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    FoundSurface& found = scratch_->found[i];
    const View& view = found.look.view;
    if (!found.waits || !is_plain(view) || view.known.empty()) continue;
    found.waits = false;
    const LayerLook& own = view.known.front();
    PlainPoint& point = *::new (&points[count++]) PlainPoint;
    point.sample = &samples[i];
    point.view = &view;
    point.layer.finish = &finish_of_plain(view);
    put(*own.n, point.layer.n);
    put(own.colour->rgb, point.layer.pigment);
  }
  for (std::size_t first = 0; first < count;) {
    const std::uint32_t lamps = points[first].view->lamps;
    std::size_t end = first + 1;
    while (end < count && points[end].view->lamps == lamps) ++end;
    const std::span<PlainPoint> same = points.first(end).subspan(first);
    for (const std::uint32_t lamp : lamp_sets_[lamps]) add_lamp(lamp, same);
    first = end;
  }
  for (const PlainPoint& point : points.first(count)) {
    add_glow(point.layer, point.lit, point.sample->seen.colour);
    point.sample->seen.transmittance = 0;
  }
}

/// Adds the light of one lamp to points that it is for.
void Tracer::add_lamp(std::uint32_t number, std::span<PlainPoint> points) {
  struct Waiting {
    PlainPoint* point;
    vec3 light;
    bool hidden;
  };
  Packet<Waiting> waiting;
  std::size_t count = 0;
  for (PlainPoint& point : points) {
    const View& view = *point.view;
    if (!point.layer.finish->lit) continue;
    const auto wait_or_light = [&](const Light& lamp, const Incidence& in,
                                   bool hidden) DURER_LAMBDA_INLINE {
      if (lamp.plain && in.distance > 2 * t_shadow) {
        ShadowRay& ray = scratch_->shadow_rays[count];
        put(view.p, ray.ray.o);
        put(in.l, ray.ray.d);
        ray.t_from = t_shadow;
        ray.t_to = in.distance - t_shadow;
        Waiting& w = *::new (&waiting[count++]) Waiting;
        w.point = &point;
        put(in.colour, w.light);
        w.hidden = hidden;
        return;
      }
      scratch_->noise = point.sample->noise;
      const Incidence kept = in;  // `in` itself may stay in registers
      add_light(view, point.sample->path.inside, point.layer, lamp, kept, hidden, point.lit);
      point.sample->noise = scratch_->noise;
    };
    if_lit(number, view, point.layer, wait_or_light);
  }
  scratch_->rays += count;
  const auto rays = std::span(scratch_->shadow_rays).first(count);
  scene_->geometry.occluded(rays, *scratch_->geometry);
  for (std::size_t i = 0; i < count; ++i) {
    if (rays[i].blocked) continue;
    const auto& [point, light, hidden] = waiting[i];
    scratch_->noise = point->sample->noise;
    point->lit +=
        shade_from(*point->view, point->layer, rays[i].ray.d, light, {hidden, true, true});
    point->sample->noise = scratch_->noise;
  }
}

}  // namespace durer::tracer

// The short way for several points: lamp by lamp, so that objects which answer rays together are
// asked once for all points that a lamp may light.
#include <new>

#include "tracer/transport/plain.h"

namespace durer::tracer {

/// A point on its way to be lit.
struct Tracer::PlainPoint {
  Sample* sample;
  const View* view;
  LayerPoint layer;
  vec3 lit;
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
    const LayerPoint layer{&finish_of_plain(view), 1, *own.n, own.colour->rgb};
    ::new (&points[count++]) PlainPoint{&samples[i], &view, layer, vec3(0.0F)};
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
    Incidence in;
    bool hidden;
  };
  Packet<Waiting> waiting;
  std::size_t count = 0;
  for (PlainPoint& point : points) {
    const View& view = *point.view;
    if (!point.layer.finish->lit) continue;
    if_lit(number, view, point.layer, [&](const Light& lamp, const Incidence& in, bool hidden) {
      if (lamp.plain && in.distance > 2 * t_shadow) {
        ShadowRay& ray = scratch_->shadow_rays[count];
        ray.ray = {view.p, in.l};
        ray.t_from = t_shadow;
        ray.t_to = in.distance - t_shadow;
        ::new (&waiting[count++]) Waiting{&point, in, hidden};
        return;
      }
      scratch_->noise = point.sample->noise;
      add_light(view, point.sample->path.inside, point.layer, lamp, in, hidden, point.lit);
      point.sample->noise = scratch_->noise;
    });
  }
  scratch_->rays += count;
  const auto rays = std::span(scratch_->shadow_rays).first(count);
  scene_->geometry.occluded(rays, *scratch_->geometry);
  for (std::size_t i = 0; i < count; ++i) {
    if (rays[i].blocked) continue;
    const auto& [point, in, hidden] = waiting[i];
    scratch_->noise = point->sample->noise;
    point->lit += shade_from(*point->view, point->layer, in.l, in.colour, {hidden, true, true});
    point->sample->noise = scratch_->noise;
  }
}

}  // namespace durer::tracer

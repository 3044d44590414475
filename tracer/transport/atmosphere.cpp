// The air that a ray goes through before it meets something (shading §7.5).
#include "tracer/transport/trace.h"

namespace durer::tracer {

/// Inside of any solid body there is no air.
bool Tracer::in_the_open(const Containment& inside) const {
  for (const std::uint32_t id : inside.ids()) {
    if (!scene_->interiors[id].hollow) return false;
  }
  return true;
}

/// True if something everywhere may weaken the light of lamps.
bool Tracer::dims() const {
  return (air_ && scene_->atmosphere.foggy()) || !scene_->air_media.empty();
}

/// What lies over the first `depth` of the path's ray, up to a `hit` if there is one: fog before
/// media before rainbows.
Veil Tracer::veil(const Path& path, double depth, const Hit* hit) {
  Veil air;
  if (air_) air = scene_->atmosphere.fog(path.ray, depth);
  if (!scene_->media.empty()) {
    const MediaEffect media = media_along(path, depth, hit);
    air.add_behind({media.added, media.kept, grey(media.kept)});
  }
  if (air_) air.add_behind(scene_->atmosphere.rainbow(path.ray, depth, scratch_->noise));
  return air;
}

}  // namespace durer::tracer

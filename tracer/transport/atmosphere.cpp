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

/// What lies over the first `depth` of the path's ray: fog before rainbows.
Veil Tracer::veil(const Path& path, double depth) {
  Veil air = scene_->atmosphere.fog(path.ray, depth);
  air.add_behind(scene_->atmosphere.rainbow(path.ray, depth, scratch_->noise));
  return air;
}

}  // namespace durer::tracer

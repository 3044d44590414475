// All photons of a scene (participating-and-global §3.4).
#pragma once

#include "tracer/film/progress.h"
#include "tracer/transport/photons.h"
#include "tracer/compiled_scene.h"

namespace durer::tracer {

/// Shoots the photons of a scene from all threads; the result is the same for any number of them.
/// Empty if photons are off, or nobody wants any, or the meter says to stop.
[[nodiscard]] PhotonMaps shoot_photons(const CompiledScene& scene, int threads,
                                       ProgressMeter& meter);

}  // namespace durer::tracer

// All photons of a scene (participating-and-global §3.4).
#pragma once

#include <string>

#include "tracer/film/progress.h"
#include "tracer/transport/photons.h"
#include "tracer/compiled_scene.h"

namespace durer::tracer {

/// Shoots the photons of a scene from all threads; the result is the same for any number of them.
/// Empty if photons are off, or nobody wants any, or the meter says to stop. Or takes them from the
/// file that the settings have loaded. `warning`: why they could not be saved, if they should be.
[[nodiscard]] PhotonMaps shoot_photons(const CompiledScene& scene, int threads,
                                       ProgressMeter& meter, std::string& warning);

}  // namespace durer::tracer

#pragma once

#include "base/bounds.h"
#include "scene/scene.h"

namespace durer::tracer {

/// The box that the language shows as min_extent and max_extent: corners and edge lengths in single
/// precision, looser after rotations of solids, ±1e10 where endless (objects §7).
[[nodiscard]] Bounds3 extent_of(const scene::Scene& scene, scene::ObjectId object);

}  // namespace durer::tracer

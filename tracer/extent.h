#pragma once

#include <optional>

#include "base/bounds.h"
#include "scene/scene.h"

namespace durer::tracer {

/// The box that the language shows as min_extent and max_extent: corners and edge lengths in single
/// precision, looser after rotations of solids, ±1e10 where endless (objects §7). `around`: from the
/// space around the object to where the box is wanted.
[[nodiscard]] Bounds3 extent_of(const scene::Scene& scene, scene::ObjectId object,
                                const Transform& around = {});

/// The box of the object's bounds, in the world, where it has taken the place of the object's own
/// because it is smaller. `around`: from the space around the object to the world.
[[nodiscard]] std::optional<Bounds3> bounding_box_of(const scene::Scene& scene,
                                                     scene::ObjectId object,
                                                     const Transform& around);

}  // namespace durer::tracer

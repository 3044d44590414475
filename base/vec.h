// The vocabulary types of the whole house: geometry is double, colour is float.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace durer {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;

/// "Is zero" threshold of the language and of most geometry (spec: language, constants table).
inline constexpr double epsilon = 1e-10;
/// A hit nearer than this is never the visible hit of an object, in world units (objects §3).
inline constexpr double t_min = 1e-4;
/// A shadow ray sees blockers only in (t_shadow, distance - t_shadow), world units (objects §3).
inline constexpr double t_shadow = 1e-3;
/// Greatest depth accepted by most primitives, world units.
inline constexpr double t_far = 1e7;
/// Half the side of the box of an unbounded object, and the depth given to a ray that hits nothing.
inline constexpr double unbounded = 1e10;
inline constexpr double no_hit_depth = 2e10;

}  // namespace durer

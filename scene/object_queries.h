// Questions about an object that the language asks while it is interpreted: `trace`, `inside`,
// `min_extent`, `max_extent`. The tracer answers them; the interpreter knows only this interface.
#pragma once

#include <optional>

#include "base/bounds.h"
#include "scene/scene.h"

namespace durer::scene {

class ObjectQueries {
 public:
  virtual ~ObjectQueries() = default;

  struct Trace {
    dvec3 point{0.0};
    dvec3 normal{0.0};  // unit, outward, not turned towards the ray
  };
  /// Nearest hit of the object, as placed by its own transforms, beyond the usual minimum distance.
  /// `direction` need not be unit length. None: the ray misses.
  virtual std::optional<Trace> trace(const Scene& scene, ObjectId id, dvec3 origin,
                                     dvec3 direction) = 0;
  /// None: the object has no inside (objects §8.3).
  virtual std::optional<bool> inside(const Scene& scene, ObjectId id, dvec3 point) = 0;
  /// The box that bounding uses: single precision, loose after rotations (objects §7).
  virtual Bounds3 extent(const Scene& scene, ObjectId id) = 0;
  /// The feature that keeps the object from being asked, or nothing.
  virtual std::optional<std::string> unsupported(const Scene& scene, ObjectId id) = 0;
};

}  // namespace durer::scene

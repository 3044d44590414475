// Patterns and pigments as functions that the language calls while it is interpreted, and that
// other functions contain. The tracer makes them; the interpreter knows only this interface.
#pragma once

#include "functions/tape.h"
#include "scene/scene.h"

namespace durer::scene {

class PigmentQueries {
 public:
  virtual ~PigmentQueries() = default;

  /// The value of the pigment's pattern at x, y, z, after its own warps, transforms, frequency,
  /// phase and wave (builtin-functions §7). `pigment.pattern` is not `none`. What the function
  /// needs it copies: it may outlive both arguments.
  [[nodiscard]] virtual functions::External pattern_function(const Scene& scene,
                                                             const Pigment& pigment) = 0;
  /// The pigment's red, green, blue, filter and transmit at x, y, z, in single precision.
  [[nodiscard]] virtual functions::External pigment_function(const Scene& scene,
                                                             const Pigment& pigment) = 0;
  /// 1 where x, y, z is inside of the object, 0 elsewhere.
  [[nodiscard]] virtual functions::External inside_function(const Scene& scene,
                                                            ObjectId object) = 0;
};

}  // namespace durer::scene

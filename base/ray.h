#pragma once

#include "base/vec.h"

namespace durer {

/// A half-line o + t·d. World rays have |d| = 1, so t is a world distance. Rays keep their
/// parameter when they go into object space: d is transformed without renormalising there.
struct Ray {
  dvec3 o{0.0};
  dvec3 d{0.0, 0.0, 1.0};

  [[nodiscard]] dvec3 at(double t) const { return o + t * d; }
};

}  // namespace durer

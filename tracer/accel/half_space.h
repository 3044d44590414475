#pragma once

#include "base/vec.h"

namespace durer::tracer {

/// Everything on that side of the plane through `p` to which `n` points; `n` of any length.
struct HalfSpace {
  dvec3 p{0.0};
  dvec3 n{0.0};
};

}  // namespace durer::tracer

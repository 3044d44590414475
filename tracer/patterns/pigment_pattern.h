#pragma once

#include "tracer/shading/pigment.h"

namespace durer::tracer {

/// A pigment that a pattern looks at, compiled for itself: its space is that of the pattern.
struct InnerPigment {
  explicit InnerPigment(const scene::Settings& settings) : store(settings) {}

  PigmentStore store;
  PigmentId id = 0;
};

}  // namespace durer::tracer

#pragma once

#include "base/vec.h"

namespace durer::tracer {

/// The displacement of an anti-aliasing sample, each component in [-1/2, 1/2): a hash of where the
/// sample is (shading §9), so that it depends on nothing else.
[[nodiscard]] dvec2 jitter(double x, double y);

/// The numbers 0…4095 in a random order that never changes; of `i` the low twelve bits count.
[[nodiscard]] int shuffled(int i);

}  // namespace durer::tracer

#pragma once

#include "functions/tape.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {

/// Gives a prepared `function` pattern what it evaluates: a tape of x, y, z, which must outlive it.
void bind_function(PatternState& state, const functions::Function& tape,
                   functions::NoiseGenerator noise_generator);

}  // namespace durer::tracer::patterns

// The plain instructions of a tape on eight points, once per instruction set. Every set computes the
// same bits.
#pragma once

#include <vector>

#include "functions/tape.h"

namespace durer::functions::simd {

/// Executes instructions `pc` … `end` - 1 up to the first that only the general interpreter can do,
/// and returns the place of that one, or `end`.
using TapeLanes = std::uint32_t (*)(const Function& f, Pack* registers, std::uint32_t pc,
                                    std::uint32_t end);

/// The best one for this processor.
extern constinit TapeLanes best_tape_lanes;
/// All that this processor can run, the baseline first; for tests.
[[nodiscard]] std::vector<TapeLanes> all_tape_lanes();

}  // namespace durer::functions::simd

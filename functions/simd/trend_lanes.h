// The frequent instructions of a tape on trends, once per instruction set. Every set computes the same
// bits, which are those of base/trend.h.
#pragma once

#include <vector>

#include "functions/tape.h"

namespace durer::functions::simd {

/// Executes instructions `pc` … `end` - 1 up to the first that only the general interpreter can do,
/// as where something is infinite, and returns the place of that one, or `end`.
using TrendLanes = std::uint32_t (*)(const Function& f, Trend* registers, std::uint32_t pc,
                                     std::uint32_t end);

/// The best one for this processor.
extern constinit TrendLanes best_trend_lanes;
/// All that this processor can run, the baseline first; for tests.
[[nodiscard]] std::vector<TrendLanes> all_trend_lanes();

}  // namespace durer::functions::simd

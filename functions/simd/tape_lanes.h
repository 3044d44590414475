// The plain instructions of a tape on eight points, once per instruction set. Every set computes the
// same bits.
#pragma once

#include <vector>

#include "functions/tape.h"

namespace durer::functions::simd {

/// The entry points of one instruction set. Packs that they read must have been written by them, or
/// some time ago: what was just stored in pieces is slow to load as a whole.
struct TapeLanes {
  /// Executes instructions `pc` … `end` - 1 up to the first that only the general interpreter can
  /// do, and returns the place of that one, or `end`.
  std::uint32_t (*run)(const Function& f, Pack* registers, std::uint32_t pc, std::uint32_t end);
  /// Fills n packs with the numbers from `from` on.
  void (*copy)(const double* from, std::size_t n, Pack* to);
  /// All lanes of to[i] = from[i] for i < n.
  void (*spread)(const double* from, std::size_t n, Pack* to);
};

/// The best for this processor.
extern constinit const TapeLanes* best_tape_lanes;
/// All that this processor can run, the baseline first; for tests.
[[nodiscard]] std::vector<const TapeLanes*> all_tape_lanes();

}  // namespace durer::functions::simd

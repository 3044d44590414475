// Bounds of the interpolated noise sum over a box inside one lattice cell, once per instruction set.
// Every set computes the same bits.
#pragma once

#include "functions/noise_cell.h"

namespace durer::functions::simd {

/// A range as middle and radius: shorter formulas than with two ends. Rounding is not covered.
struct Ball {
  double m = 0;
  double r = 0;
};

/// Range of the sum before offset and scale, and of its slopes along the axes.
struct NoiseBound {
  double lo = 0;
  double hi = 0;
  double slope_lo[3] = {};
  double slope_hi[3] = {};
};

/// Over the box `f`, in positions 0…1 of the cell.
[[nodiscard]] NoiseBound noise_bound(const Cell& cell, const Ball (&f)[3]);
/// The same by a given instruction set, for tests: 0 baseline, 1 the best.
[[nodiscard]] NoiseBound noise_bound(const Cell& cell, const Ball (&f)[3], int set);

}  // namespace durer::functions::simd

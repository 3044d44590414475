// Places on a lens that samples are taken at (shading §2.7).
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "scene/scene.h"

namespace durer::tracer {

struct LensPoints {
  std::vector<dvec2> points;     // in a disc of radius 1/2; with bokeh in a square of edge 1
  double jitter = 0;             // by which they are moved, to either side
  std::span<const int> batches;  // how many to take before looking whether they are enough
};

/// A hexagon as large as `count` allows, then points that keep apart from each other.
[[nodiscard]] LensPoints round_lens(int count);

/// Points in proportion to the brightness of the lens's pigment.
[[nodiscard]] LensPoints bokeh_lens(int count, const scene::Pigment& pigment,
                                    const scene::Settings& settings);

}  // namespace durer::tracer

// A picture that gets less noisy from pass to pass.
#pragma once

#include <vector>

#include "tracer/film/adaptive.h"
#include "tracer/film/eye.h"
#include "tracer/film/progress.h"

namespace durer::tracer {

/// Where the passes end, in samples per pixel: the first ones are short, to show something soon, the
/// others equal. Never more than 255 of them.
[[nodiscard]] std::vector<int> pass_ends(int samples);

/// Takes the samples of all blocks, pass by pass, where `film` does not have them yet. After every
/// pass of a block, its pixels are the mean of the samples so far.
void render_passes(const Viewpoint& view, const std::vector<Block>& blocks, int threads,
                   ProgressMeter& meter, Checkpoint& film);

}  // namespace durer::tracer

#include "tracer/patterns/noise_pattern.h"

namespace durer::tracer::patterns {

extern constinit const PatternType spotted_pattern = describe_pattern<NoisePattern>(
    "spotted", "Smooth noise, grey unless coloured.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

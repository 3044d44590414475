#include "tracer/patterns/noise_pattern.h"

namespace durer::tracer::patterns {
namespace {

constexpr std::array default_map{
    entry(0.4F, 1, 1, 1), entry(0.4F, 0, 1, 0), entry(0.6F, 0, 1, 0),
    entry(0.6F, 0, 0, 1), entry(0.8F, 0, 0, 1), entry(0.8F, 1, 0, 0),
};

}  // namespace

extern constinit const PatternType bozo_pattern =
    describe_pattern<NoisePattern>("bozo", "Smooth noise.", {.default_map = default_map});

}  // namespace durer::tracer::patterns

#include "tracer/patterns/noise_pattern.h"

namespace durer::tracer::patterns {
namespace {

struct Bumps : NoisePattern {
  dvec3 perturb(dvec3 p, dvec3 n, double amount) const {
    return n + amount * functions::vnoise(p);
  }
};

}  // namespace

extern constinit const PatternType bumps_pattern = describe_pattern<Bumps>(
    "bumps", "Smooth noise; as a normal, bumps of its own kind.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

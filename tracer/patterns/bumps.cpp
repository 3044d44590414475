#include <algorithm>

#include "tracer/patterns/noise_pattern.h"

namespace durer::tracer::patterns {
namespace {

struct Bumps : NoisePattern {
  dvec3 perturb(dvec3 p, dvec3 n, double amount) const {
    return n + amount * functions::vnoise(p);
  }
  void perturb(std::span<const dvec3> points, dvec3* normals, double amount) const {
    std::array<dvec3, 16> bumps;
    for (std::size_t done = 0; done < points.size(); done += bumps.size()) {
      const auto some = points.subspan(done, std::min(bumps.size(), points.size() - done));
      functions::vnoise(some, std::span(bumps).first(some.size()));
      for (std::size_t i = 0; i < some.size(); ++i) *normals++ += amount * bumps[i];
    }
  }
};

}  // namespace

extern constinit const PatternType bumps_pattern = describe_pattern<Bumps>(
    "bumps", "Smooth noise; as a normal, bumps of its own kind.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns

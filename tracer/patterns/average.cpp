#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Not a value but a blend of everything in the map (textures §11.6).
struct Average {
  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};
  double operator()(dvec3) const { return 0; }
};

}  // namespace

extern constinit const PatternType average_pattern =
    describe_pattern<Average>("average", "A blend of all entries of a map.", {.default_map = {}, .averages = true});

}  // namespace durer::tracer::patterns

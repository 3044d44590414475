#include "tracer/patterns/pigment_pattern.h"

namespace durer::tracer::patterns {
namespace {

// How bright another pigment is (textures §8.5). Without one it is 0 everywhere.
struct PigmentPattern {
  const InnerPigment* pigment = nullptr;

  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};

  void prepare(const PatternContext& context) { pigment = context.pigment; }
  double operator()(dvec3 p, const SurfaceView* view) const {
    if (pigment == nullptr || !pigment->store.covers(pigment->id, p, view)) return 0;
    return grey(pigment->store.at(pigment->id, p, view).rgb);
  }
};

}  // namespace

extern constinit const PatternType pigment_pattern_pattern =
    describe_pattern<PigmentPattern>("pigment_pattern", "How bright another pigment is.",
                                     {.default_map = black_to_white, .takes_pigment = true});

}  // namespace durer::tracer::patterns

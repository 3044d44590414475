#include "tracer/patterns/image_sampler.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// How bright a picture is, or how transparent (textures §12.5). Without one it is 0 everywhere.
struct ImagePattern {
  const ImageSampler* image = nullptr;

  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};

  void prepare(const PatternContext& context) { image = context.image; }
  double operator()(dvec3 p) const {
    const auto at = image != nullptr ? image->locate(p) : std::nullopt;
    return at ? image->value(*at) : 0;
  }
};

}  // namespace

extern constinit const PatternType image_pattern_pattern = describe_pattern<ImagePattern>(
    "image_pattern", "How bright a picture is.",
    {.default_map = black_to_white, .unwrapped = true, .takes_image = true});

}  // namespace durer::tracer::patterns

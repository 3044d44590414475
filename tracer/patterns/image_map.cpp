#include "tracer/patterns/image_sampler.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// The colours of a picture (textures §12). Without one, nothing.
struct ImageMap {
  const ImageSampler* image = nullptr;

  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};

  void prepare(const PatternContext& context) { image = context.image; }
  double operator()(dvec3) const { return 0; }

  bool opaque() const { return image != nullptr && image->opaque(); }
  bool covers(dvec3 p) const { return image != nullptr && image->locate(p).has_value(); }
  Colour colour(dvec3 p) const {
    const auto at = image != nullptr ? image->locate(p) : std::nullopt;
    // Beyond a picture that is shown once the surface is not there.
    return at ? image->colour(*at) : Colour{vec3(1.0F), 0, 1};
  }
};

}  // namespace

extern constinit const PatternType image_map_pattern =
    describe_pattern<ImageMap>("image_map", "The colours of a picture.",
                               {.default_map = {}, .unwrapped = true, .takes_image = true, .only_pigment = true});

}  // namespace durer::tracer::patterns

#include <algorithm>

#include "tracer/patterns/image_sampler.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// One of several textures for every pixel of a picture (textures §12.6).
struct MaterialMap {
  double count = 1;
  const ImageSampler* image = nullptr;

  static constexpr std::array operands{
      positional<&MaterialMap::count>("count", "the number of textures"),
  };
  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};

  void prepare(const PatternContext& context) { image = context.image; }
  double operator()(dvec3 p) const {
    const auto at = image != nullptr ? image->locate(p) : std::nullopt;
    if (!at) return 0;
    const int textures = std::max(1, static_cast<int>(count));
    const int number = image->material(*at);
    // One too many is the last one; only more than that begins anew.
    return std::min(number > textures ? number % textures : number, textures - 1);
  }
};

}  // namespace

extern constinit const PatternType material_map_pattern =
    describe_pattern<MaterialMap>("material_map", "A texture for every pixel of a picture.",
                                  {.default_map = {}, .unwrapped = true, .takes_image = true, .only_texture = true});

}  // namespace durer::tracer::patterns

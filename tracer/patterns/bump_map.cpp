#include <glm/geometric.hpp>

#include "tracer/patterns/image_sampler.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Bumps as high as a picture is bright (textures §13.7). Without one the surface stays as it is.
struct BumpMap {
  const ImageSampler* image = nullptr;

  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};

  void prepare(const PatternContext& context) { image = context.image; }
  double operator()(dvec3 p) const {
    const auto at = image != nullptr ? image->locate(p) : std::nullopt;
    return at ? image->height(*at) : 0;
  }

  // Three pixels make a triangle whose normal stands for y in a frame about n.
  dvec3 perturb(dvec3 p, dvec3 n, double amount) const {
    const auto at = image != nullptr ? image->locate(p) : std::nullopt;
    if (!at) return n;
    const dvec2 size = image->size();
    const double left = at->x < 1 ? at->x - 1 + size.x : at->x - 1;
    const double below = at->y + 1 >= size.y ? at->y + 1 - size.y : at->y + 1;
    const double right = left + 2 >= size.x ? left + 2 - size.x : left + 2;
    const dvec3 here(0, amount * image->height(*at), 0);
    const dvec3 one(-1, amount * image->height({left, below}), 1);
    const dvec3 other(1, amount * image->height({right, below}), 1);
    const dvec3 bump = glm::normalize(glm::cross(other - one, here - one));

    dvec3 x = glm::cross(n, dvec3(0, 1, 0));
    dvec3 y = n;
    if (const double l = glm::length(x); l < epsilon) {
      x = {1, 0, 0};
      y = {0, n.y < 0 ? -1 : 1, 0};
    } else {
      x /= l;
    }
    const dvec3 z = glm::normalize(glm::cross(x, y));
    return bump.x * x + bump.y * y - bump.z * z;
  }
};

}  // namespace

extern constinit const PatternType bump_map_pattern =
    describe_pattern<BumpMap>("bump_map", "Bumps as high as a picture is bright.",
                              {.default_map = {}, .unwrapped = true, .takes_image = true, .only_normal = true});

}  // namespace durer::tracer::patterns

#include "tracer/shading/sky.h"

#include <algorithm>
#include <cmath>

namespace durer::tracer {

Sky::Sky(const scene::Scene& scene)
    : background_(scene.background),
      legacy_(scene.settings.effective_version < 370),
      pigments_(scene.settings),
      plain_{find(dvec3(0.0), false), find(dvec3(0.0), true)} {
  if (!scene.sky_sphere) return;
  emission_ = scene.sky_sphere->emission;
  for (const scene::Pigment& p : scene.sky_sphere->pigments) {
    layers_.push_back(pigments_.add(p, scene.sky_sphere->transform));
  }
}

Sky::Seen Sky::find(dvec3 d, bool opaque) const {
  Colour background = background_;
  if (legacy_) {
    // With an alpha channel the old rules show nothing at all (shading §7.2).
    if (!opaque) return {vec3(0.0F), 1};
    background.filter = background.transmit = 0;
    return legacy(d, background);
  }
  if (opaque) background.filter = background.transmit = 0;
  return modern(d, background);
}

/// Layers are seen through each other as layers of a texture are.
Sky::Seen Sky::modern(dvec3 d, const Colour& background) const {
  vec3 sum(0.0F);
  vec3 through(1.0F);
  for (std::size_t i = layers_.size(); i-- > 0;) {
    const Colour c = pigments_.at(layers_[i], d);
    sum += c.rgb * c.opacity() * through * emission_;
    through *= c.transmission();
  }
  sum += background.rgb * background.opacity() * through;
  through *= background.transmission();
  return {sum, std::min(1.0F, std::abs(grey(through)))};
}

/// Before 3.7 lower layers are not tinted by filtering ones above them.
Sky::Seen Sky::legacy(dvec3 d, const Colour& background) const {
  vec3 sum(0.0F);
  Colour product{vec3(1.0F), 1, 1};
  float through = 1;
  for (std::size_t i = layers_.size(); i-- > 0;) {
    const Colour c = pigments_.at(layers_[i], d);
    sum += c.rgb * through * c.opacity();
    product.rgb *= c.rgb;
    product.filter *= c.filter;
    product.transmit *= c.transmit;
    through = std::abs(product.filter) + std::abs(product.transmit);
  }
  if (layers_.empty()) return {background.rgb, 0};
  return {sum * emission_ + background.rgb * (product.rgb * product.filter + product.transmit), 0};
}

}  // namespace durer::tracer

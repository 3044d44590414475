// What a ray sees that hits nothing: sky sphere over background (shading §7).
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"
#include "tracer/shading/pigment.h"

namespace durer::tracer {

class Sky {
 public:
  explicit Sky(const scene::Scene& scene);

  struct Seen {
    vec3 colour;
    float transmittance;  // of the picture, 0…1
  };
  /// Colour in direction `d` (unit length). Mirrors, and pictures without an alpha channel, show an
  /// opaque sky.
  [[nodiscard]] Seen at(const dvec3& d, bool opaque) const {
    const Seen* everywhere = plain(opaque);
    return everywhere != nullptr ? *everywhere : find(d, opaque);
  }
  /// What is seen in all directions; null if they differ.
  [[nodiscard]] const Seen* plain(bool opaque) const {
    return layers_.empty() ? &plain_[opaque ? 1 : 0] : nullptr;
  }

 private:
  [[nodiscard]] Seen find(dvec3 d, bool opaque) const;
  [[nodiscard]] Seen modern(dvec3 d, const Colour& background) const;
  [[nodiscard]] Seen legacy(dvec3 d, const Colour& background) const;

  Colour background_;
  bool legacy_ = false;  // rules of versions below 3.7
  vec3 emission_{1.0F};
  PigmentStore pigments_;
  std::vector<PigmentId> layers_;  // in written order; later ones lie on top
  std::array<Seen, 2> plain_;  // what is seen everywhere, if there are none: with alpha, and opaque
};

}  // namespace durer::tracer

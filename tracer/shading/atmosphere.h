// Fog and rainbows: what the air does to light on a straight way (shading §7.3, §7.4).
#pragma once

#include <limits>
#include <vector>

#include "base/ray.h"
#include "scene/scene.h"
#include "tracer/shading/pigment.h"

namespace durer::tracer {

/// What lies between the eye and a point: light from there becomes `glow + through · light`.
struct Veil {
  vec3 glow{0.0F};
  vec3 through{1.0F};
  float transmittance = 1;  // of the picture's alpha channel

  /// Puts `farther` behind this one.
  void add_behind(const Veil& farther) {
    glow += through * farther.glow;
    through *= farther.through;
    transmittance *= farther.transmittance;
  }
};

/// A fog with everything worked out that does not depend on the ray.
struct Fog {
  explicit Fog(const scene::Fog& fog, functions::NoiseGenerator generator);

  /// Share of light that passes the first `depth` of a ray, 0…1; what the colour always lets through
  /// included.
  [[nodiscard]] double clarity(const Ray& ray, double depth) const;
  /// What light that passes is tinted with.
  [[nodiscard]] vec3 tint(double clarity) const {
    return static_cast<float>(clarity) * (1 - colour.filter + colour.filter * colour.rgb);
  }

  scene::Fog::Kind kind;
  double distance;
  Colour colour;
  double offset;
  double alt;
  dvec3 up;
  bool turbulent;
  dvec3 turbulence;
  double turb_depth;
  functions::Octaves octaves;
  functions::NoiseGenerator noise_generator;
};

/// A rainbow likewise.
struct Rainbow {
  dvec3 direction{0.0};
  dvec3 up{0.0};     // unit, at right angles to `direction`
  dvec3 right{0.0};  // likewise
  double inner = 0;  // radians from `direction`
  double width = 0;  // radians
  double arc = 0;    // radians to both sides of `up`
  double falloff = 0;
  double distance = 0;
  double jitter = 0;
  double least_ahead = 0;  // cosines outside of which there is nothing for sure
  double most_ahead = std::numeric_limits<double>::infinity();
  PigmentId colours = 0;  // at (i, 0, 0): the colour of a share i of the band's width
};

/// All fogs and rainbows of a scene.
class Atmosphere {
 public:
  explicit Atmosphere(const scene::Scene& scene);

  [[nodiscard]] bool empty() const { return fogs_.empty() && rainbows_.empty(); }
  [[nodiscard]] bool foggy() const { return !fogs_.empty(); }
  /// All fogs over the first `depth` of a ray.
  [[nodiscard]] Veil fog(const Ray& ray, double depth) const;
  /// What they leave of a lamp's light on such a way.
  [[nodiscard]] vec3 fog_shadow(const Ray& ray, double depth) const;
  /// All rainbows before something at `depth`. `noise`: state of random numbers, for jitter.
  [[nodiscard]] Veil rainbow(const Ray& ray, double depth, std::uint32_t& noise) const;

 private:
  [[nodiscard]] bool band(const Rainbow& bow, dvec3 d, double depth, std::uint32_t& noise,
                          Veil& out) const;

  std::vector<Fog> fogs_;  // latest declared first
  std::vector<Rainbow> rainbows_;
  PigmentStore pigments_;
};

}  // namespace durer::tracer
